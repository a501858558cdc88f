// Feet, hands and wheels that press strands aside, radially and at once: what a coat has of who touches it in this frame. Unlike
// the ground's memory (coupling/ground_memory.h) it keeps no trail.
#pragma once

#include "fluid/result.h"

#include <glm/vec3.hpp>
#include <span>

namespace windrow::vegetation::fur {

struct Foot {
    glm::dvec3 position{0.0}; ///< [m] in the world: of its sole
    float radius = 0.3f;      ///< [m] within which strands lean away, above 0 to 1e3
    float weight = 1.0f;      ///< share of CoatSettings::foot_push, 0 to 1
};
inline constexpr std::size_t k_most_feet = 8;

[[nodiscard]] windrow::Result<void> validate(std::span<const Foot> feet);

} // namespace windrow::vegetation::fur
