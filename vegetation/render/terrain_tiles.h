// Draws of the ground for a view: strips of the tiles that are seen, and level tiles as four vertices.
//
// A tile has 32 x 32 cells. Rows of cells are strips, two vertices a corner, without restart: a run of tiles beside one another is
// one draw, whose instances are its rows. A tile is level where it and a cell around it lie in one plane, level or sloped: it is
// drawn as a rectangle that reaches a cell beyond its rim, over its neighbours in the same plane. So no gap opens where an edge of
// one meets corners of the other.
#pragma once

#include "../../fluid/shapes/height_map.h"

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace windrow::vegetation::render {

/// vkCmdDraw's numbers. terrain.glsl makes corners of them: `terrain_strip` and `terrain_level`.
struct TerrainDraw {
    std::uint32_t vertices = 0, instances = 0, first_vertex = 0, first_instance = 0;
};

class TerrainTiles {
  public:
    /// Cells along a tile: 2112 vertices, some times the cost of a draw.
    static constexpr int k_side = 32;

    explicit TerrainTiles(const HeightMap& heights);

    /// Draws of rows of cells, and of level tiles.
    struct Draws {
        std::vector<TerrainDraw> strips{}, level{};
        [[nodiscard]] std::uint64_t vertices() const;
    };
    /// What may be seen in `view`, to clip space from where the corner of the heights is at `corner` [m]. Reuses the vectors' memory.
    void find_seen(const glm::mat4& view, glm::vec3 corner, Draws& draws) const;

    /// Divides strips by tiles, the nearest to `eye` first [m from the corner of the heights].
    void sort_strips(glm::vec2 eye, Draws& draws) const;

    [[nodiscard]] glm::ivec2 tiles() const { return tiles_; }
    [[nodiscard]] bool level(glm::ivec2 tile) const { return at(tile).level; }

  private:
    struct Tile {
        glm::vec3 middle{0.0f}; ///< [m] from the corner of the heights
        float radius = 0.0f;    ///< [m] of the ball around it
        bool level = false;
    };
    [[nodiscard]] const Tile& at(glm::ivec2 tile) const { return all_[static_cast<std::size_t>(tile.y * tiles_.x + tile.x)]; }

    glm::ivec2 cells_{0}, tiles_{0};
    std::vector<Tile> all_{};
};

} // namespace windrow::vegetation::render
