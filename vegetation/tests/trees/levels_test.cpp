// How trees thin out with distance: nothing pops.
#include "tests/figure.h"
#include "vegetation/trees/tree_model.h"
#include "vegetation/trees/tree_presets.h"
#include "vegetation/trees/tree_shape.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace windrow::vegetation::trees {
namespace {

// [m] From a point to a triangle.
float distance_to(glm::vec3 p, glm::vec3 a, glm::vec3 b, glm::vec3 c) {
    const auto to_edge = [&](glm::vec3 from, glm::vec3 to) {
        const glm::vec3 along = to - from;
        const float t = std::clamp(glm::dot(p - from, along) / glm::dot(along, along), 0.0f, 1.0f);
        return glm::length(p - from - t * along);
    };
    float least = std::min({to_edge(a, b), to_edge(b, c), to_edge(c, a)});
    const glm::vec3 normal = glm::cross(b - a, c - a);
    const auto side = [&](glm::vec3 from, glm::vec3 to) { return glm::dot(glm::cross(to - from, p - from), normal); };
    const float size = glm::length(normal);
    if (size > 0.0f && side(a, b) >= 0.0f && side(b, c) >= 0.0f && side(c, a) >= 0.0f)
        least = std::min(least, std::abs(glm::dot(p - a, normal)) / size);
    return least;
}

TEST(TreeLevels, LeavesShrinkBeforeTheyGo) {
    for (const std::string_view name : preset_names()) {
        const TreeKind kind = *preset(name);
        const TreeModel model = *build(kind.tree);
        const auto leaves = static_cast<std::uint32_t>(model.leaf_parts.size());
        const LevelBlock levels = level_block(kind.levels, static_cast<int>(leaves));
        float left_out = 0.0f, jump = 0.0f;
        std::vector<float> last(leaves, 1.0f);
        for (float distance = 5.0f; distance < 300.0f; distance *= 1.001f) {
            const std::uint32_t drawn = model.drawn(levels, distance).leaves.count / 6u;
            for (std::uint32_t n = 0; n < leaves; ++n) {
                const float scale = leaf_scale(levels, distance, static_cast<float>(n) / static_cast<float>(leaves));
                if (n >= drawn)
                    left_out = std::max(left_out, scale);
                jump = std::max(jump, std::abs(scale - last[n]));
                last[n] = scale;
            }
        }
        const std::string figure = "trees/levels/" + std::string(name) + "/";
        WINDROW_EXPECT_FIGURE(figure + "left_out", left_out, 0.0); // what is not drawn has no size
        // A thousandth farther: a leaf shrinks by p / 1000 of keep over a band of a quarter of it, and has grown by keep^-growth.
        const float grown = std::pow(levels.leaves.z, -levels.stems.z);
        const double bound = 1e-3 * static_cast<double>(levels.leaves.y / levels.leaves.w * grown) * 1.3;
        WINDROW_EXPECT_FIGURE(figure + "jump", jump, bound);
    }
}

TEST(TreeLevels, AllLeavesTogetherKeepTheAreaThatGrowthAsks) {
    const LevelBlock half = level_block({.growth = 0.5f}, 4000);
    for (const float distance : {5.0f, 39.0f, 45.0f, 70.0f, 100.0f, 300.0f}) {
        double area = 0.0;
        for (int n = 0; n < 4000; ++n)
            area += std::pow(static_cast<double>(leaf_scale(half, distance, static_cast<float>(n) / 4000.0f)), 2.0) / 4000.0;
        // 34 leaves of full size are a sum, not the integral: half a leaf more or less.
        WINDROW_EXPECT_FIGURE("trees/levels/area_lost", std::abs(area - 1.0), 0.5 / 34.0);
    }
}

TEST(TreeLevels, BranchesShrinkBeforeTheyGo) {
    const TreeKind kind;
    const TreeModel model = *build(kind.tree);
    const LevelBlock levels = level_block(kind.levels, static_cast<int>(model.leaf_parts.size()));
    float left_out = 0.0f;
    for (float distance = 5.0f; distance < 300.0f; distance *= 1.003f) {
        const Drawn drawn = model.drawn(levels, distance);
        const std::uint32_t count =
            drawn.more_wood.count + (drawn.wood.first == model.trunk.first ? drawn.wood.count - model.trunk.count : 0u);
        for (std::size_t n = 0; n < model.stem_radii.size(); ++n)
            if (model.stem_ends[n] > count)
                left_out = std::max(left_out, stem_scale(levels, distance, model.stem_radii[n]));
    }
    WINDROW_EXPECT_FIGURE("trees/levels/stems_left_out", left_out, 0.0);
    EXPECT_EQ(model.drawn(levels, 5.0f).more_wood.count, 0u);
    EXPECT_EQ(model.drawn(levels, 5.0f).vertices, model.vertices.size());
    EXPECT_EQ(model.drawn(levels, 5.0f).parts, model.parts.size());
}

// A crown never floats: whatever goes with distance, the trunk does not.
TEST(TreeLevels, TheTrunkStaysAtAnyDistance) {
    const TreeModel model = *build(TreeKind{}.tree);
    const LevelBlock levels = level_block(TreeKind{}.levels, static_cast<int>(model.leaf_parts.size()));
    for (std::uint32_t n = 0; n < shape::k_trunk_vertices; ++n)
        for (const float distance : {1.0f, 60.0f, 99.0f, 1000.0f, 1e5f})
            ASSERT_EQ(stem_scale(levels, distance, model.vertices[n].position.w), 1.0f) << n << " at " << distance;
}

// Where the coarse trunk takes over, the fine one has become its surface.
TEST(TreeLevels, TheTrunkMorphsIntoTheCoarseOne) {
    for (const std::string_view name : preset_names()) {
        const TreeKind kind = *preset(name);
        const TreeModel model = *build(kind.tree);
        const LevelBlock levels = level_block(kind.levels, static_cast<int>(model.leaf_parts.size()));
        const float from = coarse_trunk_from(levels);
        EXPECT_EQ(model.drawn(levels, 0.999f * from).wood.first, model.trunk.first);
        EXPECT_EQ(model.drawn(levels, from).wood.first, model.coarse_trunk.first);
        EXPECT_EQ(trunk_morph(levels, from), 1.0f);
        EXPECT_EQ(trunk_morph(levels, 0.5f * from), 0.0f);
        float worst = 0.0f, without = 0.0f;
        for (std::size_t n = 0; n < shape::k_trunk_vertices; ++n) {
            float least = 1e9f, min_without = 1e9f;
            const glm::vec3 fine(model.vertices[n].position), morphed = fine + glm::vec3(model.vertices[n].home);
            for (std::uint32_t i = model.coarse_trunk.first; i < model.coarse_trunk.first + model.coarse_trunk.count; i += 3) {
                const auto at = [&](std::uint32_t k) { return glm::vec3(model.vertices[model.indices[i + k]].position); };
                least = std::min(least, distance_to(morphed, at(0), at(1), at(2)));
                min_without = std::min(min_without, distance_to(fine, at(0), at(1), at(2)));
            }
            worst = std::max(worst, least);
            without = std::max(without, min_without);
        }
        const std::string figure = "trees/levels/" + std::string(name) + "/trunk_px";
        constexpr float pixel = 0.00115f; // [rad] of 720 in 45 degrees
        windrow::test::figure(figure + "_without", without / from / pixel);
        // Quads of two triangles are bent a little, where the mean of two neighbours is not on either.
        WINDROW_EXPECT_FIGURE(figure, worst / from / pixel, 0.1);
    }
}

} // namespace
} // namespace windrow::vegetation::trees
