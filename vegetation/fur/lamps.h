// Lamps that shine on coats beside the sun: a few points of light, without shadows of their own.
#pragma once

#include "fluid/result.h"

#include <glm/vec3.hpp>
#include <span>

namespace windrow::vegetation::fur {

struct Lamp {
    glm::dvec3 position{0.0, 3.0, 0.0}; ///< [m]
    glm::vec3 colour{1.0f};             ///< irradiance across the beam at 1 m, in the picture's units, each 0 to 1e6
    float reach = 20.0f;                ///< [m] beyond it falls smoothly to nothing, above 0 to 1e4
};
inline constexpr std::size_t k_most_lamps = 8;

[[nodiscard]] windrow::Result<void> validate(std::span<const Lamp> lamps);

} // namespace windrow::vegetation::fur
