// The renderer's formulas of light as C++: the same text of shaders/numerics that its shaders include.
#pragma once

#include "../grass/grass_numerics.h"

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#define WINDROW_FN inline
namespace windrow::vegetation::render::numerics {
using namespace glm;
using windrow::numerics::windrow_place_noise; // of the clouds
#include "../shaders/numerics/cloud_layer.glsl"
#include "../shaders/numerics/leaf_light.glsl"
#include "../shaders/numerics/motion_blur.glsl"
#include "../shaders/numerics/motion_vector.glsl"
#include "../shaders/numerics/sky.glsl"
#include "../shaders/numerics/speed_colour.glsl"
} // namespace windrow::vegetation::render::numerics
#undef WINDROW_FN
