// The formulas of strands as C++: the same text of shaders/numerics that the shells' shaders include. Hash, noise and stems are
// those of the plants and the grass, light on a leaf is the renderer's.
#pragma once

#include "../render/light_numerics.h"

#include <glm/ext/vector_int3.hpp>
#include <glm/vector_relational.hpp>

#define WINDROW_FN inline
namespace windrow::numerics {
using namespace glm;
#include "../../shaders/numerics/turn_sine.glsl"
} // namespace windrow::numerics
namespace windrow::vegetation::fur::numerics {
using namespace glm;
using render::numerics::windrow_half_lambert;
using windrow::numerics::windrow_fraction;
using windrow::numerics::windrow_mask_power;
using windrow::numerics::windrow_plant_hash;
using windrow::numerics::windrow_sine_fraction;
using windrow::numerics::windrow_turn_cosine;
using windrow::numerics::windrow_turn_sine;
#include "../shaders/numerics/cloud_shells.glsl"
#include "../shaders/numerics/strand_light.glsl"
} // namespace windrow::vegetation::fur::numerics
#undef WINDROW_FN
