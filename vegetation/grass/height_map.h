// The ground that grass grows on: a grid of heights.
//
//     auto hills = grass::HeightMap::create({501, 501}, 1.0f, heights);    // 500 m x 500 m
//     if (!hills)
//         return std::fprintf(stderr, "%s\n", hills.error().c_str()), 1;
//     const float y = hills->height({12.5f, 80.0f});                       // [m] between the corners
//
// Places are [m] along x and z from the grid's first corner. The formulas, for C++ and shaders:
// vegetation/shaders/numerics/height_grid.glsl.
#pragma once

#include "fluid/result.h"
#include "vegetation/grass/grass_numerics.h"

#include <functional>
#include <span>
#include <vector>

namespace windrow::vegetation::grass {

class HeightMap {
  public:
    /// `heights` [m] at the corners, x fastest: corners.x * corners.y of them, each within +-1e5. Rejects fewer than 2 corners or
    /// more than 16384 along an axis, a spacing [m] that is not 1e-3 to 1e3, another number of heights, and heights that are no
    /// numbers or larger.
    [[nodiscard]] static windrow::Result<HeightMap> create(glm::ivec2 corners, float spacing, std::vector<float> heights);
    /// The same from a function of the place [m].
    [[nodiscard]] static windrow::Result<HeightMap> create(glm::ivec2 corners, float spacing,
                                                           const std::function<float(glm::vec2 place)>& height);

    /// Level ground at height 0: 100 m x 100 m, a corner a metre.
    [[nodiscard]] static HeightMap level();

    [[nodiscard]] float height(glm::vec2 place) const;
    /// [m] On the two triangles of a texel that a renderer draws: at most a quarter of the texel's twist away from `height`.
    [[nodiscard]] float drawn_height(glm::vec2 place) const;
    /// Unit vector, continuous over the whole ground.
    [[nodiscard]] glm::vec3 normal(glm::vec2 place) const;
    /// [m] Lowest and highest within a box of places: of the bilinear surface, corners outside of the box included.
    [[nodiscard]] glm::vec2 range(glm::vec2 low, glm::vec2 high) const;

    /// [m] How far it reaches along x and z.
    [[nodiscard]] glm::vec2 extent() const { return glm::vec2(grid_.corners - 1) * grid_.spacing; }
    [[nodiscard]] const windrow::numerics::WindrowGrid& grid() const { return grid_; }
    [[nodiscard]] std::span<const float> heights() const { return heights_; }

  private:
    HeightMap(const windrow::numerics::WindrowGrid& grid, std::vector<float> heights);
    [[nodiscard]] windrow::numerics::GridView view() const { return {heights_.data()}; }

    windrow::numerics::WindrowGrid grid_;
    std::vector<float> heights_;
};

} // namespace windrow::vegetation::grass
