// Models of trees at rest: bounds on what they cost, and that nothing in them is bent out of shape by extreme settings.
#include "coupling/tree_places.h"
#include "tests/fields.h"
#include "tests/figure.h"
#include "vegetation/trees/crown_light.h"
#include "vegetation/trees/tree_model.h"
#include "vegetation/trees/tree_presets.h"
#include "vegetation/trees/tree_wind.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace windrow::vegetation::trees {
namespace {

using windrow::test::Random;
constexpr std::uint32_t k_none = windrow::Tree::PartIndices::k_none;

TreeModel model_of(const TreeSettings& settings) {
    auto made = build(settings);
    EXPECT_TRUE(made) << made.error();
    return *std::move(made);
}

// Finite, of unit normals, of parts and indices that are there, with shares of light that are shares.
void expect_sound(const TreeModel& model) {
    float longest = 0.0f;
    for (const ModelVertex& v : model.vertices) {
        for (int axis = 0; axis < 4; ++axis)
            ASSERT_TRUE(std::isfinite(v.position[axis]) && std::isfinite(v.normal[axis]) && std::isfinite(v.centre[axis]) &&
                        std::isfinite(v.open[axis]) && std::isfinite(v.home[axis]));
        longest = std::max(longest, std::abs(glm::length(glm::vec3(v.normal)) - 1.0f));
        ASSERT_TRUE(v.parts.x == k_none || v.parts.x < model.parts.size());
        ASSERT_TRUE(v.parts.y == k_none || v.parts.y < model.parts.size());
        ASSERT_GE(v.open.w, 0.0f);
        ASSERT_LE(v.open.w, 1.00001f);
    }
    ASSERT_LE(longest, 1e-5f);
    for (const std::uint32_t index : model.indices)
        ASSERT_LT(index, model.vertices.size());
    for (std::uint32_t n = 0; n < model.parts.size(); ++n) {
        const auto judged = windrow::validate(model.part(n), "part");
        ASSERT_TRUE(judged) << n << ": " << judged.error();
        ASSERT_GT(model.part(n).stiffness, 0.0f);
    }
}

// The crowns that slow the air are those that are drawn: 96 % of the leaves' vertices by height, and 98 % by distance from the trunk.
TEST(TreeModel, CrownsOfDragAreThoseDrawn) {
    ASSERT_EQ(preset_names().size(), windrow::k_tree_crowns.size());
    for (std::size_t n = 0; n < preset_names().size(); ++n) {
        const windrow::TreeCrown& crown = windrow::k_tree_crowns[n];
        ASSERT_EQ(crown.kind, preset_names()[n]);
        const TreeModel model = model_of(preset(crown.kind)->tree);
        std::vector<double> heights, distances;
        for (std::uint32_t at = model.leaves.first; at < model.leaves.first + model.leaves.count; ++at) {
            const glm::vec4 place = model.vertices[model.indices[at]].position;
            heights.push_back(static_cast<double>(place.y));
            distances.push_back(static_cast<double>(std::hypot(place.x, place.z)));
        }
        std::sort(heights.begin(), heights.end());
        std::sort(distances.begin(), distances.end());
        const auto at = [](const std::vector<double>& sorted, double share) {
            return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
        };
        const auto height = static_cast<double>(crown.height), radius = static_cast<double>(crown.radius);
        const std::string figure = "trees/" + std::string(crown.kind) + "/crown_";
        WINDROW_EXPECT_FIGURE(figure + "top", std::abs(at(heights, 0.98) / height - 1.0), 0.05);
        WINDROW_EXPECT_FIGURE(figure + "base", std::abs(at(heights, 0.02) - static_cast<double>(crown.base)) / height, 0.05);
        WINDROW_EXPECT_FIGURE(figure + "radius", std::abs(at(distances, 0.98) / radius - 1.0),
                              0.15); // a birch differs most by its seed
    }
}

TEST(TreeModel, PresetsAreSoundAndWithinTheirBounds) {
    for (const std::string_view name : preset_names()) {
        const TreeKind kind = *preset(name);
        const TreeModel model = model_of(kind.tree);
        expect_sound(model);
        const std::string figure = "trees/" + std::string(name) + "/";
        WINDROW_EXPECT_FIGURE(figure + "vertices", static_cast<double>(model.vertices.size()), k_max_vertices);
        EXPECT_EQ(static_cast<double>(model.vertices.size()), vertex_bound(kind.tree)); // rejected by the same number
        const LevelBlock levels = level_block(kind.levels, static_cast<int>(model.leaf_parts.size()));
        std::uint32_t most = 0;
        for (float distance = kind.levels.far; distance < 4.0f * kind.levels.far; distance += 1.0f)
            most = std::max(most, model.drawn(levels, distance).vertices);
        WINDROW_EXPECT_FIGURE(figure + "vertices_afar", most, k_max_far_vertices);
        EXPECT_TRUE(windrow::Tree::create(wind_classes(kind.tree)));
        EXPECT_TRUE(validate(kind.look));
        EXPECT_TRUE(validate(kind.levels));
    }
}

TEST(TreeModel, ExtremeSettingsGiveSoundTrees) {
    Random random(1);
    int built = 0;
    for (int n = 0; n < 150; ++n) {
        TreeSettings s;
        const auto pick = [&](float low, float high) { // often an end of the range
            const int end = random.integer(0, 2);
            return end == 0 ? low : end == 1 ? high : random.uniform(low, high);
        };
        s.height = pick(0.3f, 60.0f);
        s.trunk_radius = std::min(pick(0.005f, 3.0f), 0.2f * s.height);
        s.trunk_wander = pick(0.0f, 0.2f);
        s.crown_base = pick(0.0f, 0.9f);
        s.form = static_cast<CrownForm>(random.integer(0, 4));
        s.limbs = random.integer(1, 40);
        s.whorl = random.integer(0, 12);
        s.limb_crowding = pick(0.3f, 5.0f);
        s.limb_length = pick(0.05f, 30.0f);
        s.limb_low_deg = pick(0.0f, 150.0f);
        s.limb_high_deg = pick(0.0f, 150.0f);
        s.limb_rise = pick(-1.0f, 1.0f);
        s.wander = pick(0.0f, 1.0f);
        s.branches = random.integer(0, 4);
        s.branch_deg = pick(0.0f, 150.0f);
        s.branch_fraction = pick(0.02f, 1.0f);
        s.branch_rise = pick(-1.0f, 1.0f);
        s.clusters = random.integer(1, 3);
        s.cluster_length = pick(0.02f, 3.0f);
        s.leaves = random.integer(1, 4);
        s.leaf_length = pick(0.01f, 3.0f);
        s.leaf_width = pick(0.005f, 3.0f);
        s.leaf_droop = pick(0.0f, 1.0f);
        s.leaf_form = static_cast<LeafForm>(random.integer(0, 1));
        s.wood = pick(1e8f, 5e10f);
        s.seed = random.bits();
        ASSERT_TRUE(validate(s)) << validate(s).error();
        expect_sound(model_of(s));
        ASSERT_FALSE(HasFatalFailure()) << "tree " << n;
        ASSERT_TRUE(windrow::Tree::create(wind_classes(s))) << windrow::Tree::create(wind_classes(s)).error();
        ++built;
    }
    windrow::test::figure("trees/extreme/built", built);
}

TEST(TreeModel, TheSameSeedGivesTheSameTreeAndAnotherAnother) {
    TreeSettings settings;
    const TreeModel one = model_of(settings), again = model_of(settings);
    settings.seed += 1;
    const TreeModel other = model_of(settings);
    ASSERT_EQ(one.vertices.size(), again.vertices.size());
    std::size_t apart = 0;
    for (std::size_t n = 0; n < one.vertices.size(); ++n) {
        ASSERT_EQ(one.vertices[n].position, again.vertices[n].position);
        apart += n < other.vertices.size() && one.vertices[n].position != other.vertices[n].position ? 1u : 0u;
    }
    EXPECT_GT(apart, one.vertices.size() / 2);
}

// The base of a trunk stays fixed to the bit in any wind.
TEST(TreeModel, TheTrunksBaseStaysInAnyWind) {
    const TreeKind kind = *preset("birch");
    const TreeModel model = model_of(kind.tree);
    const auto tree = windrow::Tree::create(wind_classes(kind.tree));
    Random random(2);
    int held = 0;
    for (const ModelVertex& v : model.vertices) {
        if (v.parts.x != k_none || v.position.y > 0.0f)
            continue;
        for (int n = 0; n < 50; ++n) {
            const windrow::PlantVertex rest{.position = glm::vec3(v.position), .normal = glm::vec3(v.normal)};
            const windrow::PlantVertex bent = tree->vertex({.trunk = model.part(0)}, random.vector(60.0f), rest);
            ASSERT_EQ(bent.position, rest.position);
            ASSERT_EQ(bent.normal, rest.normal);
        }
        ++held;
    }
    EXPECT_GE(held, 10); // a ring
}

// Darker within: light from above falls on the way in, and a lone leaf has all of it.
TEST(CrownLight, FallsInward) {
    std::vector<Absorber> leaves;
    Random random(3);
    for (int n = 0; n < 20000; ++n)
        leaves.emplace_back(glm::vec3(random.direction()) * 4.0f * std::cbrt(random.uniform(0.0f, 1.0f)), 0.02f);
    const CrownLight light(leaves);
    float last = 0.0f;
    for (const float radius : {0.0f, 2.0f, 3.0f, 3.8f}) {
        const glm::vec4 fit = light.fit({radius, 0.0f, 0.0f});
        EXPECT_GT(fit.w, last);
        last = fit.w;
        if (radius > 1.0f) {
            EXPECT_GT(glm::normalize(glm::vec3(fit)).x, 0.95f); // points out
        }
    }
    // Even leaf area: a = 20000 * 0.02 / (4/3 pi 4^3) = 1.49 1/m, T from the middle upward = exp(-a 4 / 2) = 0.051. A cell's
    // count of 1.3 leaves strays, over 12 cells on the way by 1 / sqrt(16) of the depth: a fifth with the grid's own edges.
    const double depth = -std::log(static_cast<double>(light.transmittance(glm::vec3(0.0f), {0.0f, 1.0f, 0.0f})));
    WINDROW_EXPECT_FIGURE("trees/crown_light/depth", std::abs(depth - 2.98) / 2.98, 0.35);
    EXPECT_EQ(CrownLight({}).fit(glm::vec3(0.0f)).w, 1.0f);
}

} // namespace
} // namespace windrow::vegetation::trees
