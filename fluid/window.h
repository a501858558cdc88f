// Position of the box in the world, in whole cells of 64 bits: exact at any distance.
#pragma once

#include "api.h"
#include "parallel.h"
#include "rows.h"

#include <cmath>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>

namespace windrow {

using CellIndex = glm::vec<3, std::int64_t>;

struct WINDROW_API Window {
    glm::ivec3 cells{0};
    float cell_size = 1.0f;
    /// World cell that cell (0, 0, 0) of the box is; its low corner is at origin_cells * units().
    CellIndex origin_cells{0};
    /// Rows of the box, which the wind keeps; null: all are cell_size thick.
    const RowTable* rows = nullptr;
    /// What WindControl::shift_origin has added to origin_cells: less it, the box has moved only where air was left behind.
    CellIndex shifted{0};

    /// [m] Steps by which the box moves: the size of its cells, along y of its lowest ones.
    [[nodiscard]] glm::dvec3 units() const {
        const double h = static_cast<double>(cell_size);
        return {h, rows ? rows->step() : h, h};
    }
    /// [m] World position of the low corner, or of that of a box elsewhere.
    [[nodiscard]] glm::dvec3 origin() const { return origin_at(origin_cells); }
    [[nodiscard]] glm::dvec3 origin_at(CellIndex cells_there) const { return glm::dvec3(cells_there) * units(); }
    /// [m] From the low corner to the high one.
    [[nodiscard]] glm::dvec3 size() const {
        const glm::dvec3 equal = glm::dvec3(cells) * static_cast<double>(cell_size);
        return rows ? glm::dvec3(equal.x, rows->top(), equal.z) : equal;
    }
    /// A world position in cells from the low corner, in double: cell (i, j, k) has its centre at (i, j, k) + 1/2.
    [[nodiscard]] glm::dvec3 local(glm::dvec3 position) const {
        glm::dvec3 place = position / static_cast<double>(cell_size) - glm::dvec3(origin_cells);
        if (rows)
            place.y = rows->place(position.y - origin().y);
        return place;
    }
    /// [units()] From the low corner, rounded to 1/65536: the digits that a position 10^6 m away still has. So one scene gives the
    /// same bits wherever it stands.
    [[nodiscard]] glm::dvec3 local_rounded(glm::dvec3 position) const;
    /// [m] World position of a cell's centre; cells beyond the box too.
    [[nodiscard]] glm::dvec3 centre(int i, int j, int k) const {
        glm::dvec3 centre = (glm::dvec3(origin_cells) + glm::dvec3(i + 0.5, j + 0.5, k + 0.5)) * static_cast<double>(cell_size);
        if (rows)
            centre.y = origin().y + rows->height(j);
        return centre;
    }
    /// Origin for `point` to be the box's centre, to the nearest whole cell.
    [[nodiscard]] CellIndex centred_on(glm::dvec3 point) const;
};

/// Moves the box by `shift` cells over a field: cell x takes what was at x + shift, cells from outside take `fresh`. In place.
WINDROW_API void shift_field(std::span<glm::vec4> field, glm::ivec3 cells, CellIndex shift, glm::vec4 fresh);
/// Moves a box with rows of its own up by some of its lowest rows: the field keeps its heights. Cubic in the row, linear beside the
/// first and the last; cells from outside take fresh(i, j, k). In place.
WINDROW_API void lift_field(std::span<glm::vec4> field, glm::ivec3 cells, const RowTable& rows, std::int64_t steps,
                            const ParallelFor& parallel_for, const std::function<glm::vec4(int, int, int)>& fresh);

namespace detail {
/// Origin of shaders' positions: an anchor that is not finite counts as 0.
[[nodiscard]] inline glm::dvec3 usable_anchor(glm::dvec3 anchor) {
    return std::isfinite(anchor.x) && std::isfinite(anchor.y) && std::isfinite(anchor.z) ? anchor : glm::dvec3(0.0);
}
} // namespace detail

} // namespace windrow
