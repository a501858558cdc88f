// Where cells are from a body: places in its own axes, distances.
#pragma once

#include "fluid/solids/solids.h"

#include <glm/mat3x3.hpp>

namespace windrow {

// Where the cells of the box are from one image of a body.
struct Solids::View {
    static constexpr float k_far = 3.0f;      ///< [cells] from a surface; beyond it a distance need not be right
    static constexpr double k_parts = 4096.0; ///< of a cell, in which a body's place is rounded
    /// Of a part, by which a place is rounded up from below its half: places are whole sixteenths (Window::local_rounded) up to the
    /// rounding of floats. That differs from box to box, and must not choose.
    static constexpr double k_half = 0.5 + 1.0 / 32.0;

    const PlacedObstacle& body;
    float cell_size;
    const RowTable* rows;
    float coarsest; // [cells] distance between two cells
    glm::mat3 to_own = glm::transpose(body.axes);
    glm::vec3 base{0.0f}, part{0.0f}; // [cells] the body's middle: whole cells and the rest

    // From the cell that holds the middle, so that a body has the same cells wherever the box is.
    View(const PlacedObstacle& seen, glm::ivec3 offset, const Box& box)
        : body(seen), cell_size(box.cell_size), rows(box.rows.get()), coarsest(box.coarsest() / box.cell_size) {
        const float h = cell_size;
        const glm::dvec3 middle = glm::dvec3(body.position) / static_cast<double>(h) + glm::dvec3(offset);
        const glm::dvec3 whole = glm::floor(middle);
        base = glm::vec3(whole);
        part = glm::vec3(glm::floor((middle - whole) * k_parts + k_half) / k_parts);
    }
    // `beside`: the rest of a place that no float holds exactly.
    [[nodiscard]] glm::vec3 from_middle(glm::vec3 cell, glm::vec3 beside = glm::vec3(0.0f)) const {
        glm::vec3 away = ((cell - base) - part + beside) * cell_size;
        if (rows != nullptr)
            away.y = static_cast<float>(rows->height_at(static_cast<double>(cell.y + beside.y)) -
                                        static_cast<double>(body.position.y));
        return away;
    }
    [[nodiscard]] glm::vec3 own_place(glm::vec3 cell) const { return to_own * from_middle(cell); }
    [[nodiscard]] float distance(glm::vec3 cell) const { // [cells]
        return detail::distance_to(body.shape, own_place(cell), k_far * coarsest * cell_size) / cell_size;
    }
    // [m] From the middle of another body's view to this one's.
    [[nodiscard]] glm::vec3 from_middle_of(const View& other) const {
        glm::vec3 between = ((base - other.base) + (part - other.part)) * cell_size;
        if (rows != nullptr)
            between.y = body.position.y - other.body.position.y;
        return between;
    }
    [[nodiscard]] glm::vec3 velocity(glm::vec3 away) const { return body.velocity + glm::cross(body.spin, away); }
};

// visit(cell) in the order of Reach::index.
template <class Visit>
void Solids::Reach::for_each(const Visit& visit) const {
    for (int k = low.z; k < high.z; ++k)
        for (int j = low.y; j < high.y; ++j)
            for (int i = low.x; i < high.x; ++i)
                visit(glm::ivec3(i, j, k));
}

template <class Visit>
void Solids::for_each_neighbour(const InsideCell& cell, const Visit& visit) const {
    const std::uint32_t strides[3] = {1, static_cast<std::uint32_t>(box_.cells.x),
                                      static_cast<std::uint32_t>(box_.cells.x * box_.cells.y)};
    for (int axis = 0; axis < 3; ++axis)
        for (const int side : {-1, 1}) {
            std::uint32_t other = 0;
            const int at = cell.place[axis] + side;
            if (at >= 0 && at < box_.cells[axis]) {
                other = side < 0 ? cell.cell - strides[axis] : cell.cell + strides[axis];
            } else {
                glm::ivec3 next;
                if (!neighbour(cell.place, axis, side, next))
                    continue;
                other = index(next);
            }
            visit(other, axis, side < 0 ? other : cell.cell);
        }
}

} // namespace windrow
