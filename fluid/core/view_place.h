// Place of a world point among the cells of a box, and the wind there: the sampling of a WindView, for cells kept elsewhere too.
#pragma once

#include "fluid/api.h"
#include "fluid/view.h"

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

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

/// [m/s] Wind at a place among eight cells, x fastest.
[[nodiscard]] WINDROW_INTERNAL glm::vec3 blended(const ViewPlace& place, const std::array<glm::vec4, 8>& corners);

/// Trilinear between the cells around a place, with `cell(i, j, k)` the value of a cell. Not for a fraction of 0.
template <class Cell>
[[nodiscard]] auto between_cells(const ViewPlace& place, const Cell& cell) {
    const auto line = [&](int j, int k) { return glm::mix(cell(place.low.x, j, k), cell(place.high.x, j, k), place.between.x); };
    const auto plane = [&](int k) { return glm::mix(line(place.low.y, k), line(place.high.y, k), place.between.y); };
    return glm::mix(plane(place.low.z), plane(place.high.z), place.between.z);
}

/// [m/s] Wind at a place, with `cell(i, j, k)` the velocity of a cell.
template <class Cell>
[[nodiscard]] glm::vec3 wind_at(const ViewPlace& place, const Cell& cell) {
    if (place.fraction <= 0.0f)
        return place.ambient;
    std::array<glm::vec4, 8> corners;
    for (int n = 0; n < 8; ++n)
        corners[static_cast<std::size_t>(n)] =
            glm::vec4(cell((n & 1) != 0 ? place.high.x : place.low.x, (n & 2) != 0 ? place.high.y : place.low.y,
                           (n & 4) != 0 ? place.high.z : place.low.z),
                      0.0f);
    return blended(place, corners);
}

} // namespace windrow::detail
