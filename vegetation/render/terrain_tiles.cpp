#include "vegetation/render/terrain_tiles.h"

#include "vegetation/render/frame_block.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

namespace windrow::vegetation::render {
namespace {

// [m] What a tile may leave the plane of three of its corners by: rounding of heights, and nothing that is seen.
constexpr float k_level = 1e-4f;

} // namespace

TerrainTiles::TerrainTiles(const HeightMap& heights)
    : cells_(heights.grid().corners - 1), tiles_((cells_ + k_side - 1) / k_side) {
    const glm::vec2 spacing = heights.grid().spacing;
    const auto height = [&](glm::ivec2 corner) {
        return heights.heights()[static_cast<std::size_t>(corner.y * heights.grid().corners.x + corner.x)];
    };
    all_.reserve(static_cast<std::size_t>(tiles_.x * tiles_.y));
    for (int z = 0; z < tiles_.y; ++z)
        for (int x = 0; x < tiles_.x; ++x) {
            const glm::ivec2 first = glm::max(k_side * glm::ivec2(x, z) - 1, glm::ivec2(0)),
                             last = glm::min(k_side * glm::ivec2(x + 1, z + 1) + 1, cells_), across = last - first;
            const float base = height(first), along_x = (height({last.x, first.y}) - base) / static_cast<float>(across.x),
                        along_z = (height({first.x, last.y}) - base) / static_cast<float>(across.y);
            float low = base, high = base, off = 0.0f;
            for (int j = first.y; j <= last.y; ++j)
                for (int i = first.x; i <= last.x; ++i) {
                    const float here = height({i, j});
                    low = std::min(low, here);
                    high = std::max(high, here);
                    const auto dx = static_cast<float>(i - first.x), dz = static_cast<float>(j - first.y);
                    off = std::max(off, std::abs(here - (base + along_x * dx + along_z * dz)));
                }
            const glm::vec3 from(spacing.x * static_cast<float>(first.x), low, spacing.y * static_cast<float>(first.y));
            const glm::vec3 to(spacing.x * static_cast<float>(last.x), high, spacing.y * static_cast<float>(last.y));
            all_.push_back({.middle = 0.5f * (from + to), .radius = 0.5f * glm::length(to - from), .level = off <= k_level});
        }
}

std::uint64_t TerrainTiles::Draws::vertices() const {
    std::uint64_t sum = 0;
    for (const auto* const list : {&strips, &level})
        for (const TerrainDraw& draw : *list)
            sum += std::uint64_t{draw.vertices} * draw.instances;
    return sum;
}

void TerrainTiles::find_seen(const glm::mat4& view, glm::vec3 corner, Draws& draws) const {
    draws.strips.clear();
    draws.level.clear();
    for (int z = 0; z < tiles_.y; ++z) {
        int end = 0; // of the run that the last draw of this row of tiles covers
        bool flat = false;
        for (int x = 0; x < tiles_.x; ++x) {
            const Tile& tile = at({x, z});
            if (!sees(view, corner + tile.middle, tile.radius))
                continue;
            const int cells = std::min(k_side, cells_.x - k_side * x);
            const bool goes_on = end == x && x > 0 && flat == tile.level;
            if (tile.level && goes_on)
                ++draws.level.back().instances;
            else if (tile.level)
                draws.level.push_back(
                    {.vertices = 4, .instances = 1, .first_instance = static_cast<std::uint32_t>(z * tiles_.x + x)});
            else if (goes_on)
                draws.strips.back().vertices += 2 * static_cast<std::uint32_t>(cells);
            else
                draws.strips.push_back({.vertices = 2 * static_cast<std::uint32_t>(cells + 1),
                                        .instances = static_cast<std::uint32_t>(std::min(k_side, cells_.y - k_side * z)),
                                        .first_vertex = static_cast<std::uint32_t>(2 * k_side * x),
                                        .first_instance = static_cast<std::uint32_t>(k_side * z)});
            end = x + 1;
            flat = tile.level;
        }
    }
}

void TerrainTiles::sort_strips(glm::vec2 eye, Draws& draws) const {
    constexpr auto k_step = static_cast<std::uint32_t>(2 * k_side); // vertices between tiles of a row
    std::vector<TerrainDraw> tiles;
    for (const TerrainDraw& run : draws.strips)
        for (std::uint32_t first = 0; first + 2 < run.vertices; first += k_step) {
            TerrainDraw tile = run;
            tile.first_vertex += first;
            tile.vertices = std::min(run.vertices - first, k_step + 2);
            tiles.push_back(tile);
        }
    const auto away = [&](const TerrainDraw& tile) {
        const std::size_t x = tile.first_vertex / k_step, z = tile.first_instance / static_cast<std::uint32_t>(k_side);
        const glm::vec3 middle = all_[z * static_cast<std::size_t>(tiles_.x) + x].middle;
        return glm::distance(eye, glm::vec2(middle.x, middle.z));
    };
    std::stable_sort(tiles.begin(), tiles.end(), [&](const auto& a, const auto& b) { return away(a) < away(b); });
    draws.strips = std::move(tiles);
}

} // namespace windrow::vegetation::render
