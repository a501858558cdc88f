// Which cells are on the side of a point: those that open faces join to its own. What is put into the air there passes no wall.
#include "fluid/solids/body_view.h"

#include <algorithm>
#include <limits>

namespace windrow {

// The cell of air that a point is in: its own, or where the centre of that is inside an obstacle, the nearest that none hides from the
// point. x is -1 where there is none, as for a point inside.
glm::ivec3 Solids::air_cell_at(glm::dvec3 place, glm::ivec3 first, glm::ivec3 end) const {
    const auto is_air = [&](glm::ivec3 cell) { return !inside(index(cell)); };
    const glm::ivec3 own(glm::floor(glm::clamp(place, glm::dvec3(-1.0), glm::dvec3(box_.cells))));
    if (glm::all(glm::greaterThanEqual(own, first)) && glm::all(glm::lessThan(own, end)) && is_air(own))
        return own;
    glm::ivec3 nearest(-1);
    float least = std::numeric_limits<float>::infinity();
    const glm::vec3 from(place);
    Reach{first, end}.for_each([&](glm::ivec3 cell) {
        const glm::vec3 to = glm::vec3(cell) + 0.5f;
        const float away = glm::distance(from, to);
        const auto hides = [&](const PlacedObstacle& body) {
            const View view(body, glm::ivec3(0), box_);
            return view.distance(from) < 0.0f || detail::blocks(body.shape, view.own_place(from), view.own_place(to));
        };
        if (away < least && is_air(cell) && std::none_of(bodies_.begin(), bodies_.end(), hides)) {
            least = away;
            nearest = cell;
        }
    });
    return nearest;
}

// Sweeps there and back until one adds none.
void Solids::find_joined(glm::dvec3 place, glm::ivec3 first, glm::ivec3 end, std::span<std::uint8_t> joined) const {
    const Reach reach{first, end};
    bool walls = false;
    for (int k = first.z; k < end.z; ++k)
        for (int j = first.y; j < end.y; ++j)
            walls = walls || any_blocked(index({first.x, j, k}), end.x - first.x);
    const glm::ivec3 own = walls ? air_cell_at(place, first, end) : glm::ivec3(-1);
    reach.for_each([&](glm::ivec3 cell) { joined[index(cell)] = own.x < 0 || cell == own ? 1 : 0; });
    const auto is_joined = [&](glm::ivec3 cell) {
        for (int axis = 0; axis < 3; ++axis)
            for (const int side : {-1, 1}) {
                glm::ivec3 low = cell, other = cell;
                other[axis] += side;
                low[axis] += std::min(side, 0);
                if (reach.holds(other) && joined[index(other)] != 0 && !blocked(index(low), axis))
                    return true;
            }
        return false;
    };
    bool added = own.x >= 0;
    for (bool back = false; added; back = !back) {
        added = false;
        reach.for_each([&](glm::ivec3 at) {
            const glm::ivec3 cell = back ? first + end - 1 - at : at;
            if (std::uint8_t& here = joined[index(cell)]; here == 0 && is_joined(cell)) {
                here = 1;
                added = true;
            }
        });
    }
}

} // namespace windrow
