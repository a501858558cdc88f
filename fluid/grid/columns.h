// Columns of a box as tridiagonal systems, factored once for many right-hand sides:
//
//   x[j-1] + b[j] x[j] + x[j+1] = d[j],   b[j] = base + what the ends add,   pivot[j] = 1 / (b[j] - pivot[j-1])
//
// A periodic column is solved by Sherman and Morrison: the system without its corners, and a correction along `vector`.
// Based on: Thomas 1949; Sherman & Morrison 1950, Annals of Mathematical Statistics 21.
#pragma once

#include "fluid/api.h"
#include "fluid/grid/basis.h"
#include "fluid/rows.h"

#include <array>
#include <span>
#include <vector>

namespace windrow {

/// A ring of one cell is its own neighbour in both directions: its second difference is 0, as between two walls.
[[nodiscard]] inline bool is_cyclic(const std::array<EndRule, 2>& ends, int rows) {
    return ends[0] == EndRule::periodic && rows > 1;
}

// Rows of unequal thickness e (in cells) with links c = 1 / distance between centres: row j times e,
//
//   c[j] p[j-1] + (e lambda - c[j] - c[j+1]) p[j] + c[j+1] p[j+1] = e d[j],
//
// is symmetric. With p = s x, s[0] = c[1]^(-1/2), s[j+1] = 1 / (c[j+1] s[j]), and the row times s, the off-diagonals are 1 again:
// the right-hand side is s e d, and b = s^2 (e lambda - c[j] - c[j+1]).
struct WINDROW_INTERNAL ColumnRows {
    ColumnRows() = default;
    explicit ColumnRows(const RowTable& rows, double cell_size);

    [[nodiscard]] bool empty() const { return thickness.empty(); }
    std::vector<double> thickness; ///< e
    std::vector<double> links;     ///< c by face, one more
    std::vector<double> scales;    ///< s
};

/// Fills `pivot`, one a row; for a periodic column `vector` too, one a row, and the factors on the first and the last row by
/// which it is taken off. `base` is -2 plus the eigenvalues of the other axes, less the shift. `rows`: empty where all are equal.
WINDROW_INTERNAL void factor_column(double base, const std::array<EndRule, 2>& ends, const ColumnRows& rows,
                                    std::span<double> pivot, std::span<double> vector, std::array<double, 2>& factors);

} // namespace windrow
