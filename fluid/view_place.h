// Place of a world point among the cells of a box, and the wind there: the sampling of a WindView, for cells kept elsewhere too.
#pragma once

#include "fluid/api.h"
#include "fluid/view.h"

#include <glm/common.hpp>

namespace windrow::detail {

/// Distance from the place where the box's wind has faded, on an axis end where it does not fade.
inline constexpr float k_never_fades = 1e30f;

struct ViewPlace {
    glm::ivec3 low{0}, high{0}; ///< cells around the point
    glm::vec3 between{0.0f};    ///< of the way from the low to the high one
    float fraction = 0.0f;      ///< weight of the box's wind; 0: the cells are unset
    glm::vec3 ambient{0.0f};    ///< [m/s] ambient wind there; unset where the fraction is 1
};

/// A point that is not finite gets the mean wind.
[[nodiscard]] WINDROW_INTERNAL ViewPlace place_in(const Box& box, const Window& window, const BlendZone& blend_zone,
                                                  const AmbientWind& ambient, glm::dvec3 position);

/// [m/s] Wind at a place, with `cell(i, j, k)` the velocity of a cell.
template <class Cell>
[[nodiscard]] glm::vec3 wind_at(const ViewPlace& place, const Cell& cell) {
    const auto& [low, high, between, fraction, ambient] = place;
    if (fraction <= 0.0f)
        return ambient;
    const auto line = [&place, &cell](int j, int k) {
        return glm::mix(cell(place.low.x, j, k), cell(place.high.x, j, k), place.between.x);
    };
    const auto plane = [&place, &line](int k) { return glm::mix(line(place.low.y, k), line(place.high.y, k), place.between.y); };
    const glm::vec3 inside = glm::mix(plane(low.z), plane(high.z), between.z);
    return fraction == 1.0f ? inside : glm::mix(ambient, inside, fraction);
}

} // namespace windrow::detail
