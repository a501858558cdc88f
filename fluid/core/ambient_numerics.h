// The ambient wind's formulas as C++: shaders/numerics/ambient.glsl with the gust tile in plain memory.
#pragma once

#include "fluid/portable_math.h"

#include <cstddef>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace windrow::numerics {

/// The gust tile where C++ finds it: 128 x 16 x 128 texels, x fastest, then y, then z. Null is allowed where nothing reads it.
struct TileView {
    const glm::vec4* texels = nullptr;
};

inline glm::vec3 windrow_tile_texel(const TileView& tile, glm::ivec3 texel) {
    return glm::vec3(tile.texels[(static_cast<std::size_t>(texel.z) * 16 + texel.y) * 128 + texel.x]);
}

} // namespace windrow::numerics

#define WINDROW_FN inline
#define WINDROW_TILE const TileView&
namespace windrow::numerics {
using namespace glm;
#include "shaders/numerics/ambient.glsl"
} // namespace windrow::numerics
#undef WINDROW_TILE
#undef WINDROW_FN
