// The noise of places as C++: the same text of shaders/numerics that the shaders include.
#pragma once

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#define WINDROW_FN inline
namespace render::numerics {
using namespace glm;
#include "shaders/numerics/place_noise.glsl"
} // namespace render::numerics
#undef WINDROW_FN
