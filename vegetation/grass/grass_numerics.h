// The grass's formulas as C++: the same text of shaders/numerics that its passes include.
#pragma once

#include "../../fluid/height_grid.h"

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#define WINDROW_FN inline
namespace windrow::numerics {
using namespace glm;
#include "../shaders/numerics/grass.glsl"
} // namespace windrow::numerics
#undef WINDROW_FN
