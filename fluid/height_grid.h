// Grids of floats over level ground as C++: the text of shaders/numerics/height_grid.glsl.
#pragma once

#include "portable_math.h"

#include <cstddef>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace windrow::numerics {

/// Values of a grid in plain memory, x fastest.
struct GridView {
    const float* values = nullptr;
};

inline float windrow_grid_value(const GridView& grid, glm::ivec2 corner, int across) {
    return grid
        .values[static_cast<std::size_t>(corner.y) * static_cast<std::size_t>(across) + static_cast<std::size_t>(corner.x)];
}

} // namespace windrow::numerics

#define WINDROW_FN inline
#define WINDROW_GRID const GridView&
namespace windrow::numerics {
using namespace glm;
#include "../shaders/numerics/height_grid.glsl"
} // namespace windrow::numerics
#undef WINDROW_GRID
#undef WINDROW_FN
