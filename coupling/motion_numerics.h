// The formulas of plants in motion as C++: the same text that the shaders include.
#pragma once

#include "fluid/portable_math.h"

#include <cstddef>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace windrow::numerics {

/// Ground texels where C++ finds them: n x n, in slots, x fastest.
struct GroundTexels {
    const glm::vec4* texels = nullptr;
    int n = 0;
};

inline glm::vec4 windrow_ground_texel(const GroundTexels& ground, glm::ivec2 slot) {
    return ground
        .texels[static_cast<std::size_t>(slot.y) * static_cast<std::size_t>(ground.n) + static_cast<std::size_t>(slot.x)];
}

} // namespace windrow::numerics

#define WINDROW_FN inline
#define WINDROW_GROUND const GroundTexels&
namespace windrow::numerics {
using namespace glm;
#include "shaders/numerics/cascade.glsl"
#include "shaders/numerics/direction_memory.glsl"
#include "shaders/numerics/ground_texels.glsl"
} // namespace windrow::numerics
#undef WINDROW_GROUND
#undef WINDROW_FN
