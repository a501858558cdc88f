// The ground's draws: every cell that a view sees is drawn, and once; level tiles are four vertices, and only where no gap opens.
#include "tests/figure.h"
#include "vegetation/render/frame_block.h"
#include "vegetation/render/terrain_tiles.h"

#include <cmath>
#include <gtest/gtest.h>

namespace windrow::vegetation::render {
namespace {

constexpr int k_tile = TerrainTiles::k_side;
constexpr glm::ivec2 k_hill_corners{151, 118}; // no multiple of a tile
constexpr glm::vec3 k_first_corner{-70.0f, -2.0f, -60.0f};

// Hills beside a plain that slopes.
HeightMap half_hills() {
    return *HeightMap::create(k_hill_corners, 1.0f, [](glm::vec2 p) {
        return 0.05f * p.x + (p.x < 40.0f ? 3.0f * std::sin(0.2f * p.x) * std::cos(0.17f * p.y) : 0.0f);
    });
}

// How often each cell is drawn.
std::vector<int> times_drawn(const TerrainTiles& tiles, const TerrainTiles::Draws& draws, glm::ivec2 cells) {
    std::vector<int> times(static_cast<std::size_t>(cells.x * cells.y));
    const auto add = [&](glm::ivec2 first, glm::ivec2 end) {
        for (int z = first.y; z < std::min(end.y, cells.y); ++z)
            for (int x = first.x; x < std::min(end.x, cells.x); ++x)
                ++times[static_cast<std::size_t>(z * cells.x + x)];
    };
    for (const TerrainDraw& draw : draws.strips) {
        const glm::ivec2 first(draw.first_vertex / 2, draw.first_instance);
        add(first, first + glm::ivec2(draw.vertices / 2 - 1, draw.instances));
    }
    for (const TerrainDraw& draw : draws.level)
        for (std::uint32_t n = 0; n < draw.instances; ++n) {
            const int tile = static_cast<int>(draw.first_instance + n);
            const glm::ivec2 first = k_tile * glm::ivec2(tile % tiles.tiles().x, tile / tiles.tiles().x);
            add(first, first + k_tile);
        }
    return times;
}

TEST(TerrainTiles, DrawEachCellThatIsSeenOnce) {
    const HeightMap heights = half_hills();
    const TerrainTiles tiles(heights);
    const glm::ivec2 cells = k_hill_corners - 1;
    int drawn = 0, left_out = 0;
    for (int turn = 0; turn < 12; ++turn) {
        Camera camera;
        camera.position = {3.0 * turn - 20.0, 4.0 + turn, 10.0};
        camera.target = camera.position + glm::dvec3(std::sin(0.5 * turn), -0.3, std::cos(0.5 * turn));
        const glm::mat4 view = view_projection(camera, 1.6f, glm::dvec3(0.0));
        TerrainTiles::Draws draws;
        tiles.find_seen(view, k_first_corner, draws);
        const std::vector<int> times = times_drawn(tiles, draws, cells);
        const glm::vec2 eye(glm::vec3(camera.position) - k_first_corner);
        tiles.sort_strips({eye.x, static_cast<float>(camera.position.z) - k_first_corner.z}, draws);
        ASSERT_EQ(times_drawn(tiles, draws, cells), times) << "sorted strips are other cells";
        for (int z = 0; z < cells.y; ++z)
            for (int x = 0; x < cells.x; ++x) {
                const int here = times[static_cast<std::size_t>(z * cells.x + x)];
                ASSERT_LE(here, 1);
                (here == 1 ? drawn : left_out) += 1;
                const glm::vec2 place(static_cast<float>(x) + 0.5f, static_cast<float>(z) + 0.5f);
                const glm::vec4 clip =
                    view * glm::vec4(k_first_corner + glm::vec3(place.x, heights.drawn_height(place), place.y), 1.0f);
                const bool seen = std::abs(clip.x) < clip.w && std::abs(clip.y) < clip.w && clip.z > 0.0f && clip.z < clip.w;
                ASSERT_TRUE(here == 1 || !seen) << "cell " << x << ", " << z << " of view " << turn;
            }
    }
    windrow::test::figure("render/terrain/cells_drawn_of_hills", drawn / static_cast<double>(drawn + left_out));
    EXPECT_GT(left_out, drawn); // a view of 50 degrees from within
}

TEST(TerrainTiles, AreLevelWhereTheirNeighboursAreInTheirPlane) {
    const TerrainTiles tiles(half_hills());
    EXPECT_EQ(tiles.tiles(), glm::ivec2(5, 4));
    EXPECT_FALSE(tiles.level({0, 0}));
    EXPECT_FALSE(tiles.level({1, 2}));
    EXPECT_TRUE(tiles.level({2, 1})) << "a slope is a plane";
    EXPECT_TRUE(tiles.level({4, 3})) << "a tile that the rim cuts";
    // A bump in the corner beyond the rim: the tile's rectangle reaches it.
    for (const int away : {1, 2}) {
        std::vector<float> heights(static_cast<std::size_t>(97 * 97), 0.0f);
        heights[static_cast<std::size_t>(40 * 97 + 64 + away)] = 0.01f;
        EXPECT_EQ(TerrainTiles(*HeightMap::create({97, 97}, 1.0f, heights)).level({1, 1}), away == 2) << away;
    }
}

TEST(TerrainTiles, OfALevelPlainAreFourVerticesEach) {
    const TerrainTiles tiles(*HeightMap::create({501, 501}, 1.0f, std::vector<float>(501 * 501, 0.0f)));
    const glm::vec3 corner(-250.0f, 0.0f, -250.0f);
    TerrainTiles::Draws draws;
    glm::mat4 all(0.0f); // from above
    all[0][0] = all[2][1] = 1e-3f;
    all[3] = {0.0f, 0.0f, 0.5f, 1.0f};
    tiles.find_seen(all, corner, draws);
    EXPECT_EQ(draws.vertices(), 4u * 16u * 16u);
    EXPECT_TRUE(draws.strips.empty());
    Camera camera;
    camera.position = {0.0, 1.7, 0.0};
    camera.target = {0.0, 0.8, -10.0};
    tiles.find_seen(view_projection(camera, 16.0f / 9.0f, glm::dvec3(0.0)), corner, draws);
    // Without tiles six vertices a cell, 1,500,000.
    WINDROW_EXPECT_FIGURE("render/terrain/vertices_of_a_level_plain", static_cast<double>(draws.vertices()), 400.0);
}

} // namespace
} // namespace windrow::vegetation::render
