// The noise of places for the renderer: the grass's own.
#pragma once

#include "vegetation/grass/grass_numerics.h"

namespace render::numerics {
using windrow::numerics::windrow_dryness;
using windrow::numerics::windrow_place_chance;
using windrow::numerics::windrow_place_noise;
} // namespace render::numerics
