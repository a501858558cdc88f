// Position of the box in the world, in whole cells of 64 bits: exact at any distance.
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>

namespace windrow {

using CellIndex = glm::vec<3, std::int64_t>;

struct Window {
    glm::ivec3 cells{0};
    float cell_size = 1.0f;
    /// World cell that cell (0, 0, 0) of the box is; its low corner is at origin_cells * cell_size.
    CellIndex origin_cells{0};

    /// [m] World position of the low corner.
    [[nodiscard]] glm::dvec3 origin() const { return glm::dvec3(origin_cells) * static_cast<double>(cell_size); }
    /// A world position in cells from the low corner, in double.
    [[nodiscard]] glm::dvec3 local(glm::dvec3 position) const {
        return position / static_cast<double>(cell_size) - glm::dvec3(origin_cells);
    }
    /// The same, rounded to 1/65536 of a cell: the digits that a position 10^6 m away still has. So one scene gives the same
    /// bits wherever it stands.
    [[nodiscard]] glm::dvec3 local_rounded(glm::dvec3 position) const;
    /// [m] World position of a cell's centre.
    [[nodiscard]] glm::dvec3 centre(int i, int j, int k) const {
        return (glm::dvec3(origin_cells) + glm::dvec3(i + 0.5, j + 0.5, k + 0.5)) * static_cast<double>(cell_size);
    }
    /// Origin for `point` to be the box's centre, to the nearest whole cell.
    [[nodiscard]] CellIndex centred_on(glm::dvec3 point) const;
};

/// Moves the box by `shift` cells over a field: cell x takes what was at x + shift, cells from outside take `fresh`. In place.
void shift_field(std::span<glm::vec4> field, glm::ivec3 cells, CellIndex shift, glm::vec4 fresh);

namespace detail {
/// Origin of shaders' positions: an anchor that is not finite counts as 0.
[[nodiscard]] inline glm::dvec3 usable_anchor(glm::dvec3 anchor) {
    return std::isfinite(anchor.x) && std::isfinite(anchor.y) && std::isfinite(anchor.z) ? anchor : glm::dvec3(0.0);
}
} // namespace detail

} // namespace windrow
