// Levels of detail split exactly at their distance; neither the split nor the cut-off is visible.
#include "coupling/blade.h"
#include "tests/figure.h"
#include "vegetation/tests/grass/fields.h"

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

namespace windrow::vegetation::grass {
namespace {

using namespace windrow::numerics;
using windrow::test::Random;

Block default_block(int far_vertices = GrassSettings{}.far_vertices) {
    const HeightMap ground = *HeightMap::create({17, 17}, 1.0f, [](glm::vec2) { return 0.0f; });
    return block_of({.far_vertices = far_vertices}, ground, *PlacementMask::create({17, 17}, ground.extent(), 1.0f));
}

int far_rows(const Block& block) {
    return static_cast<int>(block.ground.w);
}

// The far vertex that one of the 15 near ones comes to lie on: rows 0 to 6 onto 0, 0, 1, 1, 2, 2, 2, or 0, 0, 0, 0, 1, 1, 1; tip on
// tip.
std::size_t far_twin(const Block& block, int vertex) {
    const int rows = far_rows(block), row = std::min(vertex / 2 / (8 / rows), rows - 1);
    return static_cast<std::size_t>(vertex == 14 ? 2 * rows : 2 * row + vertex % 2);
}

// The strip of one blade, as grass_blade.glsl draws it.
std::vector<WindrowVertex> strip(const Block& block, glm::uvec2 hash, glm::vec3 wind, float distance, int level) {
    const glm::vec3 up(0.0f, 1.0f, 0.0f), view = glm::normalize(glm::vec3(0.3f, -0.2f, 0.93f));
    const WindrowBlade kind = windrow_grass_class(block, 1.0f, distance);
    const WindrowBladePlant plant = windrow_blade_plant(kind, up, hash, windrow_blade_load(kind, up, hash, wind), view);
    const float morph = windrow_grass_ramp(distance, block.reach.x, block.reach.y);
    std::vector<WindrowVertex> made;
    for (int vertex = 0; vertex < (level == WINDROW_GRASS_NEAR ? 15 : 2 * far_rows(block) + 1); ++vertex) {
        const glm::vec2 row = windrow_grass_row(vertex, level, far_rows(block), morph);
        made.push_back(windrow_blade_vertex(kind, plant, row.x, row.y));
    }
    return made;
}

TEST(GrassLevels, SplitExactlyAtTheDistance) {
    const Block block = default_block();
    const float split = block.reach.y, cut = block.reach.w;
    const auto below = [](float x) { return std::nextafter(x, 0.0f); };
    EXPECT_EQ(windrow_grass_level(0.0f, block.reach), WINDROW_GRASS_NEAR);
    EXPECT_EQ(windrow_grass_level(below(split * split), block.reach), WINDROW_GRASS_NEAR);
    EXPECT_EQ(windrow_grass_level(split * split, block.reach), WINDROW_GRASS_FAR);
    EXPECT_EQ(windrow_grass_level(below(cut * cut), block.reach), WINDROW_GRASS_FAR);
    EXPECT_EQ(windrow_grass_level(cut * cut, block.reach), WINDROW_GRASS_NONE);
    EXPECT_EQ(windrow_grass_level(std::numeric_limits<float>::quiet_NaN(), block.reach), WINDROW_GRASS_NONE);
}

class GrassFarRows : public testing::TestWithParam<int> {};

TEST_P(GrassFarRows, AgreeVertexByVertexAtTheSplit) {
    const Block block = default_block(GetParam());
    const std::string figures = "grass/levels/" + std::to_string(GetParam()) + "_vertices/";
    Random random(3);
    double position = 0.0, normal = 0.0, unmorphed = 0.0;
    for (int n = 0; n < 10'000; ++n) {
        const glm::uvec2 hash{random.bits(), random.bits()};
        const glm::vec3 wind = static_cast<float>(random.spread(0.1, 40.0)) * glm::vec3(random.direction());
        const auto fine = strip(block, hash, wind, block.reach.y, WINDROW_GRASS_NEAR);
        const auto coarse = strip(block, hash, wind, block.reach.y, WINDROW_GRASS_FAR);
        for (int vertex = 0; vertex < 15; ++vertex) {
            const std::size_t twin = far_twin(block, vertex);
            const WindrowVertex& a = fine[static_cast<std::size_t>(vertex)];
            position = std::max(position, static_cast<double>(glm::length(a.position - coarse[twin].position)));
            normal = std::max(normal, static_cast<double>(glm::length(a.normal - coarse[twin].normal)));
        }
        // What the eye would see jump without the morph: how far the far strip's edge lies from the near one's rows.
        const auto sharp = strip(block, hash, wind, std::nextafter(block.reach.x, 0.0f), WINDROW_GRASS_NEAR);
        for (int v = 0; v < 14; ++v) {
            const int last = far_rows(block) - 1;
            const float h = static_cast<float>(v / 2) / 7.0f * static_cast<float>(far_rows(block));
            const int low = std::min(static_cast<int>(h), last);
            const float t = h - static_cast<float>(low);
            const glm::vec3 from = coarse[static_cast<std::size_t>(2 * low + v % 2)].position,
                            to = low == last ? coarse.back().position
                                             : coarse[static_cast<std::size_t>(2 * low + 2 + v % 2)].position;
            unmorphed =
                std::max(unmorphed,
                         static_cast<double>(glm::length(from + t * (to - from) - sharp[static_cast<std::size_t>(v)].position)));
        }
    }
    WINDROW_EXPECT_FIGURE(figures + "position_jump_at_the_split_m", position, 0.0);
    WINDROW_EXPECT_FIGURE(figures + "normal_jump_at_the_split", normal, 0.0);
    // What there would be to see of it without: 50 degrees on 1080 rows have 1158 pixels a radian.
    windrow::test::figure(figures + "far_strip_from_the_curve_m", unmorphed);
    windrow::test::figure(figures + "far_strip_from_the_curve_pixels_at_the_split",
                          1158.0 * unmorphed / static_cast<double>(block.reach.y));
}

INSTANTIATE_TEST_SUITE_P(Far, GrassFarRows, testing::Values(5, 7));

// An eye that comes nearer by a centimetre moves no vertex by more than its part of morph and fade.
TEST(GrassLevels, NothingJumpsAlongTheWay) {
    const Block block = default_block();
    Random random(5);
    double largest = 0.0, at_the_cut = 0.0;
    constexpr float k_step = 0.01f; // [m]
    for (int n = 0; n < 50; ++n) {
        const glm::uvec2 hash{random.bits(), random.bits()};
        const glm::vec3 wind = static_cast<float>(random.spread(0.1, 40.0)) * glm::vec3(random.direction());
        std::vector<WindrowVertex> before;
        for (int step = 0; static_cast<float>(step) * k_step < block.reach.w + 1.0f; ++step) {
            const float distance = 1.0f + static_cast<float>(step) * k_step;
            const int level = windrow_grass_level(distance * distance, block.reach);
            std::vector<WindrowVertex> now;
            if (level != WINDROW_GRASS_NONE)
                now = strip(block, hash, wind, distance, level);
            if (now.empty()) { // the last one seen had shrunk into its root
                if (!before.empty())
                    for (const WindrowVertex& v : before)
                        at_the_cut = std::max(at_the_cut, static_cast<double>(glm::length(v.position)));
                before.clear();
                continue;
            }
            for (std::size_t v = 0; v < 15 && !before.empty(); ++v) {
                // Both strips by the far one's vertices, where the level changes.
                const bool changed = now.size() != before.size();
                const std::size_t twin = !changed ? v : far_twin(block, static_cast<int>(v));
                if (v < before.size() && twin < now.size())
                    largest = std::max(largest, static_cast<double>(glm::length(now[twin].position - before[v].position)));
            }
            before = std::move(now);
        }
    }
    // A metre of way moves a vertex by at most: 0.19 of a blade of 0.39 m over the morph's 10 m, or, over the fade's 22.5 m, a
    // whole blade and 1.2 more by the bend that goes with the third power of the length (3 times 0.4 rad a unit of ln Ca): 0.04
    // m.
    WINDROW_EXPECT_FIGURE("grass/levels/largest_step_over_1_cm_of_way_m", largest, 4e-4);
    // A step before the cut, 0.01 / 22.5 of a blade is left.
    WINDROW_EXPECT_FIGURE("grass/levels/size_at_the_cut_m", at_the_cut, 0.4 * 0.01 / 22.5);
}

TEST(GrassLevels, NearRowsNeverCross) {
    for (const int far_rows : {2, 3})
        for (float morph = 0.0f; morph <= 1.0f; morph += 1.0f / 64.0f) {
            float before = 0.0f;
            for (int vertex = 0; vertex < 15; vertex += 2) {
                const float h = windrow_grass_row(vertex, WINDROW_GRASS_NEAR, far_rows, morph).x;
                EXPECT_GE(h, before);
                before = h;
            }
            EXPECT_EQ(before, 1.0f);
        }
}

// The view-dependent bend at the field's own default: seen from above, blades lie over.
TEST(GrassLevels, KeepTheViewBend) {
    const Block block = default_block();
    EXPECT_EQ(block.blade.own.z, 0.5f);
}

} // namespace
} // namespace windrow::vegetation::grass
