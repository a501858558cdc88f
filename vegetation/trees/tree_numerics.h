// The trees' formulas as C++: the same text of shaders/numerics that the shaders include. Chances and noise are the grass's own.
#pragma once

#include "vegetation/grass/grass_numerics.h"

#define WINDROW_FN inline
namespace windrow::vegetation::trees::numerics {
using namespace glm;
using windrow::numerics::windrow_fraction;
using windrow::numerics::windrow_place_noise;
using windrow::numerics::windrow_plant_chance;
using windrow::numerics::windrow_plant_hash;
#include "vegetation/shaders/numerics/tree_levels.glsl"
} // namespace windrow::vegetation::trees::numerics
#undef WINDROW_FN
