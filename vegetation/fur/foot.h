// Feet, hands and wheels that press strands aside, radially and at once: what a coat has of who touches it in this frame. Unlike
// the ground's memory (coupling/ground_memory.h) it keeps no trail.
#pragma once

#include "fluid/result.h"
#include "fluid/setting.h"

#include <glm/vec3.hpp>
#include <span>

namespace windrow::vegetation::fur {

struct Foot {
    glm::dvec3 position{0.0};
    float radius = 0.3f;
    float weight = 1.0f;

    static constexpr auto settings() {
        return std::tuple{
            Setting("position", &Foot::position, {-1e10, 1e10, "m"}, "Of its sole in the world."),
            Setting("radius", &Foot::radius, Range::above(0.0, 1e3, "m"), "Within which strands lean away."),
            Setting("weight", &Foot::weight, k_fraction_range, "Fraction of CoatSettings::foot_push."),
        };
    }
};
inline constexpr std::size_t k_most_feet = 8;

[[nodiscard]] windrow::Result<void> validate(std::span<const Foot> feet);

} // namespace windrow::vegetation::fur
