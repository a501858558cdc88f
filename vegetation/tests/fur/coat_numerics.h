// The formulas of coats as C++: the same text of shaders/numerics that their shaders include.
#pragma once

#include "coupling/shell_numerics.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#define WINDROW_FN inline
namespace windrow::vegetation::fur::numerics {
using namespace windrow::numerics;
#include "vegetation/shaders/numerics/coat_lean.glsl"
#include "vegetation/shaders/numerics/coat_room.glsl"
#include "vegetation/shaders/numerics/lamp.glsl"
} // namespace windrow::vegetation::fur::numerics
#undef WINDROW_FN
