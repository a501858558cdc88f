// The shared formulas of shaders/numerics as C++: the same text that the shaders include.
#pragma once

#include "fluid/portable_math.h"

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#define WINDROW_FN inline
namespace windrow::numerics {
using namespace glm;
#include "shaders/numerics/canopy.glsl"
#include "shaders/numerics/closed_face.glsl"
#include "shaders/numerics/diffusion.glsl"
#include "shaders/numerics/history.glsl"
#include "shaders/numerics/lee.glsl"
#include "shaders/numerics/levels.glsl"
#include "shaders/numerics/motors.glsl"
#include "shaders/numerics/slip.glsl"
#include "shaders/numerics/splitting.glsl"
#include "shaders/numerics/substeps.glsl"
#include "shaders/numerics/transport.glsl"
#include "shaders/numerics/wall_law.glsl"
#include "shaders/numerics/window.glsl"
} // namespace windrow::numerics
#undef WINDROW_FN
