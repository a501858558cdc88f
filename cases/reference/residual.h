// How wrong a pressure is, evaluated in double: the figure that belongs beside a solver's time. h = 1, open boundaries over a floor.
#pragma once

#include "fluid/box.h"

#include <cmath>
#include <functional>
#include <span>

namespace windrow::reference {

/// phi of a cell; a solver may keep it in rows of its own.
using PressureAt = std::function<double(int i, int j, int k)>;

/// L phi of a cell. Beyond open boundaries phi is 0, the floor (y low) mirrors it.
[[nodiscard]] inline double laplacian(const Box& box, const PressureAt& phi, int i, int j, int k) {
    const double here = phi(i, j, k);
    const auto beyond = [&](int a, int b, int c) {
        const bool inside = a >= 0 && a < box.cells.x && b >= 0 && b < box.cells.y && c >= 0 && c < box.cells.z;
        return inside ? phi(a, b, c) : b < 0 ? here : 0.0;
    };
    return beyond(i - 1, j, k) + beyond(i + 1, j, k) + beyond(i, j - 1, k) + beyond(i, j + 1, k) + beyond(i, j, k - 1) +
           beyond(i, j, k + 1) - 6.0 * here;
}

/// |error| / |whole| over the cells along x up to `end`; both are functions of a cell. 0 where the whole is 0.
template <class Error, class Whole>
[[nodiscard]] double relative_over_cells(const Box& box, int end, const Error& error, const Whole& whole) {
    double off = 0.0, all = 0.0;
    for (int k = 0; k < box.cells.z; ++k)
        for (int j = 0; j < box.cells.y; ++j)
            for (int i = 0; i < end; ++i) {
                const double e = error(i, j, k), w = whole(i, j, k);
                off += e * e;
                all += w * w;
            }
    return all > 0.0 ? std::sqrt(off / all) : 0.0;
}

/// |L phi - rhs| / |rhs|, L the 7-point Laplacian. 0 where rhs is 0.
[[nodiscard]] inline double relative_residual(const Box& box, std::span<const float> rhs, const PressureAt& phi) {
    const auto right = [&](int i, int j, int k) { return static_cast<double>(rhs[box.index(i, j, k)]); };
    return relative_over_cells(
        box, box.cells.x, [&](int i, int j, int k) { return right(i, j, k) - laplacian(box, phi, i, j, k); }, right);
}

/// |d(phi - exact)/dx| / |d exact/dx|. What an iteration leaves is smooth, so its residual flatters it; the wind feels the slope.
[[nodiscard]] inline double relative_gradient_error(const Box& box, const PressureAt& phi, const PressureAt& exact) {
    const auto slope = [&](int i, int j, int k) { return exact(i + 1, j, k) - exact(i, j, k); };
    return relative_over_cells(
        box, box.cells.x - 1, [&](int i, int j, int k) { return phi(i + 1, j, k) - phi(i, j, k) - slope(i, j, k); }, slope);
}

} // namespace windrow::reference
