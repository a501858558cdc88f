// Lamps that shine on coats beside the sun: a few points of light, without shadows of their own.
#pragma once

#include "fluid/result.h"
#include "fluid/setting.h"

#include <glm/vec3.hpp>
#include <span>

namespace windrow::vegetation::fur {

struct Lamp {
    glm::dvec3 position{0.0, 3.0, 0.0};
    glm::vec3 colour{1.0f};
    float reach = 20.0f;

    static constexpr auto settings() {
        return std::tuple{
            Setting("position", &Lamp::position, {-1e9, 1e9, "m"}, "Where it is."),
            Setting("colour", &Lamp::colour, {0.0, 1e6}, "Irradiance across the beam at 1 m, in the picture's units."),
            Setting("reach", &Lamp::reach, Range::above(0.0, 1e4, "m"), "Beyond it falls smoothly to nothing."),
        };
    }
};
inline constexpr std::size_t k_most_lamps = 8;

[[nodiscard]] windrow::Result<void> validate(std::span<const Lamp> lamps);

} // namespace windrow::vegetation::fur
