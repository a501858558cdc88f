#include "fluid/window.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>

namespace windrow {

namespace {

glm::dvec3 rounded(glm::dvec3 cells) {
    return glm::floor(cells * 65536.0 + 0.5) / 65536.0;
}

} // namespace

glm::dvec3 Window::local_rounded(glm::dvec3 position) const {
    return rounded(position / units() - glm::dvec3(origin_cells));
}

CellIndex Window::centred_on(glm::dvec3 point) const {
    const glm::dvec3 corner = rows ? (point - 0.5 * size()) / units() : point / units() - 0.5 * glm::dvec3(cells);
    // Rounded first, so that steps whose sum is slightly below half a cell move the box in the same step.
    return CellIndex(glm::floor(rounded(corner) + 0.5));
}

// Rows move as a whole. In the order against the shift, each row is read before it is overwritten.
void shift_field(std::span<glm::vec4> field, glm::ivec3 cells, CellIndex shift, glm::vec4 fresh) {
    const auto beyond = [&](int axis) { return std::abs(shift[axis]) >= cells[axis]; };
    if (beyond(0) || beyond(1) || beyond(2)) {
        std::fill(field.begin(), field.end(), fresh);
        return;
    }
    const glm::ivec3 by(shift);
    const std::ptrdiff_t nx = cells.x;
    const auto row = [&](int j, int k) { return field.begin() + (static_cast<std::ptrdiff_t>(k) * cells.y + j) * nx; };
    for (int kk = 0; kk < cells.z; ++kk) {
        const int k = by.z >= 0 ? kk : cells.z - 1 - kk;
        for (int jj = 0; jj < cells.y; ++jj) {
            const int j = by.y >= 0 ? jj : cells.y - 1 - jj;
            const int source_j = j + by.y, source_k = k + by.z;
            const auto to = row(j, k);
            if (source_j < 0 || source_j >= cells.y || source_k < 0 || source_k >= cells.z) {
                std::fill(to, to + nx, fresh);
                continue;
            }
            const auto from = row(source_j, source_k);
            if (by.x >= 0) {
                std::copy(from + by.x, from + nx, to);
                std::fill(to + (nx - by.x), to + nx, fresh);
            } else {
                std::copy_backward(from, from + nx + by.x, to + nx);
                std::fill(to, to - by.x, fresh);
            }
        }
    }
}

void lift_field(std::span<glm::vec4> field, glm::ivec3 cells, const RowTable& rows, std::int64_t steps,
                const ParallelFor& parallel_for, const std::function<glm::vec4(int, int, int)>& fresh) {
    std::array<double, k_max_rows> places;
    for (int j = 0; j < cells.y; ++j)
        places[static_cast<std::size_t>(j)] = rows.place_before(j, static_cast<double>(steps) * rows.step());
    parallel_for(cells.z, [&](int k) {
        std::array<glm::vec4, k_max_rows> column;
        for (int i = 0; i < cells.x; ++i) {
            const auto cell = [&](int j) -> glm::vec4& {
                return field[(static_cast<std::size_t>(k) * static_cast<std::size_t>(cells.y) + static_cast<std::size_t>(j)) *
                                 static_cast<std::size_t>(cells.x) +
                             static_cast<std::size_t>(i)];
            };
            for (int j = 0; j < cells.y; ++j)
                column[static_cast<std::size_t>(j)] = cell(j);
            for (int j = 0; j < cells.y; ++j) {
                const double place = places[static_cast<std::size_t>(j)];
                if (std::isnan(place)) {
                    cell(j) = fresh(i, j, k);
                    continue;
                }
                const double from = std::clamp(place - 0.5, 0.0, cells.y - 1.0);
                const int below = std::min(static_cast<int>(from), cells.y - 2);
                const auto t = static_cast<float>(from - below);
                const auto apart = [&](int row) {
                    return column[static_cast<std::size_t>(below + row)] - column[static_cast<std::size_t>(below)];
                };
                const glm::vec4 change =
                    below < 1 || below + 2 >= cells.y
                        ? t * apart(1)
                        : t * ((t - 1.0f) * (t - 2.0f) * (-1.0f / 6.0f) * apart(-1) + (t + 1.0f) * (t - 2.0f) * -0.5f * apart(1) +
                               (t + 1.0f) * (t - 1.0f) * (1.0f / 6.0f) * apart(2));
                cell(j) = column[static_cast<std::size_t>(below)] + change;
            }
        }
    });
}

} // namespace windrow
