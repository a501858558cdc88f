// The noise of places for the renderer: the grass's own.
#pragma once

#include "../grass/grass_numerics.h"

namespace windrow::vegetation::render::numerics {
using windrow::numerics::windrow_dryness;
using windrow::numerics::windrow_place_chance;
using windrow::numerics::windrow_place_noise;
} // namespace windrow::vegetation::render::numerics
