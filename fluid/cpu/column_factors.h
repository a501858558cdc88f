// One column's tridiagonal system, factored once for many right-hand sides:
//
//   x[j-1] + b[j] x[j] + x[j+1] = d[j],   b[j] = base + what the ends add,   pivot[j] = 1 / (b[j] - pivot[j-1])
//
// A periodic column is solved by Sherman and Morrison: the system without its corners, and a correction along `vector`.
// Based on: Thomas 1949; Sherman & Morrison 1950, Annals of Mathematical Statistics 21.
#pragma once

#include "fluid/cpu/basis.h"

#include <array>
#include <span>

namespace windrow::cpu {

/// A ring of one cell is its own neighbour on both sides: its second difference is 0, as between two walls.
[[nodiscard]] inline bool is_cyclic(const std::array<EndRule, 2>& ends, int rows) {
    return ends[0] == EndRule::periodic && rows > 1;
}

/// Fills `pivot`, one a row; for a periodic column `vector` too, one a row, and the factors on the first and the last row by
/// which it is taken off. `base` is -2 plus the eigenvalues of the other axes, less the shift.
void factor_column(double base, const std::array<EndRule, 2>& ends, std::span<double> pivot, std::span<double> vector,
                   std::array<double, 2>& factors);

} // namespace windrow::cpu
