// Chances that belong to a plant: the same seed gives the same plant on every machine.
#pragma once

#include "../fluid/portable_math.h"

#include <cstdint>
#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#define WINDROW_FN inline
namespace windrow::numerics {
using namespace glm;
#include "../shaders/numerics/place_noise.glsl"
} // namespace windrow::numerics
#undef WINDROW_FN

namespace windrow::detail {

class Chance {
  public:
    /// `stream` parts the chances of one thing from those of another.
    Chance(std::uint32_t seed, std::uint32_t stream) : key_{seed, stream * 0x9e3779b9u} {}

    /// 0 to 1, 1 left out.
    float share() {
        ++count_;
        return numerics::windrow_fraction(
            numerics::windrow_plant_hash(glm::uvec2(key_.x ^ (count_ * 0x85ebca6bu), key_.y + count_)).x);
    }
    float between(float low, float high) { return low + (high - low) * share(); }
    /// -spread to spread.
    float around(float spread) { return spread * (2.0f * share() - 1.0f); }
    glm::vec3 vector(float spread) {
        const float x = around(spread), y = around(spread), z = around(spread);
        return {x, y, z};
    }

  private:
    glm::uvec2 key_;
    std::uint32_t count_ = 0;
};

} // namespace windrow::detail
