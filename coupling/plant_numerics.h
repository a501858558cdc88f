// The plants' formulas as C++: the same text of shaders/numerics that the shaders include.
#pragma once

#include "fluid/portable_math.h"

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#define WINDROW_FN inline
namespace windrow::numerics {
using namespace glm;
#include "shaders/numerics/blade.glsl"
#include "shaders/numerics/flutter.glsl"
#include "shaders/numerics/plant_drag.glsl"
#include "shaders/numerics/plant_hash.glsl"
#include "shaders/numerics/plant_masks.glsl"
#include "shaders/numerics/radial.glsl"
#include "shaders/numerics/shell.glsl"
#include "shaders/numerics/stem.glsl"
#include "shaders/numerics/strand.glsl"
#include "shaders/numerics/tree.glsl"
} // namespace windrow::numerics
#undef WINDROW_FN
