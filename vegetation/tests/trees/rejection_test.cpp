// What a host may get wrong is rejected, by a sentence that names field, value and fix; and where trees may stand.
#include "tests/figure.h"
#include "vegetation/trees/stand_settings.h"
#include "vegetation/trees/tree_model.h"

#include <algorithm>
#include <functional>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <limits>

namespace windrow::vegetation::trees {
namespace {

constexpr float k_nan = std::numeric_limits<float>::quiet_NaN(), k_infinity = std::numeric_limits<float>::infinity();

template <class Settings>
struct Wrong {
    const char* field;
    std::function<void(Settings&)> spoil;
};

template <class Settings>
void expect_rejected(const std::vector<Wrong<Settings>>& cases) {
    EXPECT_TRUE(validate(Settings{}));
    for (const Wrong<Settings>& each : cases) {
        Settings settings;
        each.spoil(settings);
        const auto judged = validate(settings);
        ASSERT_FALSE(judged) << each.field;
        EXPECT_NE(judged.error().find(each.field), std::string::npos) << judged.error();
        EXPECT_NE(judged.error().find(": give "), std::string::npos) << judged.error(); // the fix
        EXPECT_EQ(std::count(judged.error().begin(), judged.error().end(), '\n'), 0) << judged.error();
    }
}

TEST(TreeRejections, OfTrees) {
    using S = TreeSettings;
    expect_rejected<S>({{"tree.height", [](S& s) { s.height = k_nan; }},
                        {"tree.height", [](S& s) { s.height = 61.0f; }},
                        {"tree.trunk_radius", [](S& s) { s.trunk_radius = 0.0f; }},
                        {"tree.trunk_radius", [](S& s) { s.trunk_radius = 2.5f; }},
                        {"tree.trunk_wander", [](S& s) { s.trunk_wander = -0.1f; }},
                        {"tree.crown_base", [](S& s) { s.crown_base = 0.95f; }},
                        {"tree.form", [](S& s) { s.form = static_cast<CrownForm>(9); }},
                        {"tree.limbs", [](S& s) { s.limbs = 0; }},
                        {"tree.whorl", [](S& s) { s.whorl = -1; }},
                        {"tree.limb_crowding", [](S& s) { s.limb_crowding = 0.0f; }},
                        {"tree.limb_length", [](S& s) { s.limb_length = k_infinity; }},
                        {"tree.limb_low_deg", [](S& s) { s.limb_low_deg = 151.0f; }},
                        {"tree.limb_high_deg", [](S& s) { s.limb_high_deg = -1.0f; }},
                        {"tree.limb_rise", [](S& s) { s.limb_rise = 1.1f; }},
                        {"tree.wander", [](S& s) { s.wander = 2.0f; }},
                        {"tree.branches", [](S& s) { s.branches = -1; }},
                        {"tree.branch_deg", [](S& s) { s.branch_deg = k_nan; }},
                        {"tree.branch_fraction", [](S& s) { s.branch_fraction = 0.0f; }},
                        {"tree.branch_rise", [](S& s) { s.branch_rise = -2.0f; }},
                        {"tree.clusters", [](S& s) { s.clusters = 0; }},
                        {"tree.cluster_length", [](S& s) { s.cluster_length = 0.0f; }},
                        {"tree.leaves", [](S& s) { s.leaves = 17; }},
                        {"tree.leaf_length", [](S& s) { s.leaf_length = 0.0f; }},
                        {"tree.leaf_width", [](S& s) { s.leaf_width = 4.0f; }},
                        {"tree.leaf_droop", [](S& s) { s.leaf_droop = -1.0f; }},
                        {"tree.leaf_form", [](S& s) { s.leaf_form = static_cast<LeafForm>(2); }},
                        {"tree.wood", [](S& s) { s.wood = 0.0f; }},
                        {"of 30000", [](S& s) { s.leaves = 16; }}});
    TreeSettings many;
    many.leaves = 16;
    EXPECT_FALSE(build(many));
}

TEST(TreeRejections, OfLooksAndLevels) {
    using L = TreeLook;
    expect_rejected<L>({{"look.bark is (0.15, 1.5, 0.088)", [](L& l) { l.bark.g = 1.5f; }},
                        {"look.furrow is (0.045, 0.035, nan)", [](L& l) { l.furrow.b = k_nan; }},
                        {"look.bark_lines", [](L& l) { l.bark_lines = 2.0f; }},
                        {"look.leaf is (-0.1, 0.082, 0.024)", [](L& l) { l.leaf.r = -0.1f; }},
                        {"channel g", [](L& l) { l.young.g = 0.5f; }},
                        {"look.variation", [](L& l) { l.variation = 1.0f; }},
                        {"look.gloss", [](L& l) { l.gloss = 0.0f; }}});
    using V = TreeLevels;
    expect_rejected<V>({{"levels.near", [](V& l) { l.near = 0.0f; }},
                        {"levels.far", [](V& l) { l.far = l.near; }},
                        {"levels.far_leaves", [](V& l) { l.far_leaves = 3; }},
                        {"levels.growth", [](V& l) { l.growth = 0.6f; }},
                        {"levels.min_angle", [](V& l) { l.min_angle = 0.0f; }}});
    EXPECT_FALSE(preset("palm"));
    EXPECT_NE(preset("palm").error().find("oak, birch, spruce, bush"), std::string::npos);
}

TEST(TreeRejections, OfStands) {
    using S = TreeStandSettings;
    expect_rejected<S>({{"stand.variants", [](S& s) { s.variants = 0; }},
                        {"stand.places[1].size",
                         [](S& s) {
                             s.places = {{}, {.size = 0.0f}};
                         }},
                        {"stand.places[0].base is (nan, 0, 0)",
                         [](S& s) {
                             s.places = {{.base = {std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0}}};
                         }},
                        {"stand.places[0].yaw_deg", [](S& s) { s.places = {{.yaw_deg = 400.0f}}; }},
                        {"tree.height", [](S& s) { s.kind.tree.height = 61.0f; }},
                        {"scatter.count", [](S& s) { s.scatter.count = -1; }},
                        {"scatter.high.x", [](S& s) { s.scatter.high.x = s.scatter.low.x; }},
                        {"scatter.apart", [](S& s) { s.scatter.apart = -1.0; }},
                        {"scatter.groves", [](S& s) { s.scatter.groves = 2.0f; }},
                        {"scatter.grove_length", [](S& s) { s.scatter.grove_length = 0.0; }},
                        {"scatter.size_spread", [](S& s) { s.scatter.size_spread = 1.0f; }},
                        {"scatter.clear[0].radius", [](S& s) {
                             s.scatter.clear = {{{0.0, 0.0}, -1.0}};
                         }}});
}

// The number of a cell there is beyond 2^63: signed, it is undefined.
TEST(TreeScatter, StandsApartFarFromTheOrigin) {
    const TreeScatter far{.count = 100, .low = {-9e8, 2e6}, .high = {-9e8 + 80.0, 2e6 + 80.0}, .apart = 4.0, .seed = 3};
    const auto places = scatter(far, [](double, double) { return 0.0; });
    ASSERT_TRUE(places) << places.error();
    ASSERT_EQ(places->size(), 100u);
    for (std::size_t n = 0; n < places->size(); ++n)
        for (std::size_t m = 0; m < n; ++m)
            EXPECT_GE(glm::distance((*places)[n].base, (*places)[m].base), 4.0);
}

TEST(TreeScatter, StandsOnTheGroundApartAndOutOfTheCircles) {
    TreeStandSettings stand;
    stand.places = {{.base = {1.0, 2.0, 3.0}}};
    stand.scatter = {.count = 200, .apart = 6.0, .seed = 5, .clear = {{{20.0, 10.0}, 30.0}, {{-60.0, -60.0}, 12.0}}};
    const GroundHeight ground = [](double x, double z) { return 0.1 * x - 0.05 * z; };
    const auto places = places_of(stand, ground);
    ASSERT_TRUE(places) << places.error();
    ASSERT_EQ(places->size(), 201u);                            // the region holds that many
    EXPECT_EQ(places->front().base, glm::dvec3(1.0, 2.0, 3.0)); // a given one stays as it is
    double nearest = 1e9, cleared = 1e9;
    for (std::size_t n = 1; n < places->size(); ++n) {
        const glm::dvec3 base = (*places)[n].base;
        ASSERT_EQ(base.y, ground(base.x, base.z));
        ASSERT_TRUE(std::abs(base.x) <= 100.0 && std::abs(base.z) <= 100.0);
        for (const ClearCircle& circle : stand.scatter.clear)
            cleared = std::min(cleared, glm::distance(circle.centre, glm::dvec2(base.x, base.z)) - circle.radius);
        for (std::size_t m = 1; m < n; ++m)
            nearest = std::min(nearest, glm::distance(base, glm::dvec3((*places)[m].base.x, base.y, (*places)[m].base.z)));
    }
    EXPECT_GE(windrow::test::figure("trees/scatter/nearest", nearest, 6.0), 6.0);
    EXPECT_GE(windrow::test::figure("trees/scatter/beyond_circles", cleared, 0.0), 0.0);
    const auto again = places_of(stand, ground);
    for (std::size_t n = 0; n < places->size(); ++n)
        ASSERT_EQ((*places)[n].base, (*again)[n].base);
    stand.scatter.apart = 60.0; // no room for 200
    EXPECT_LT(places_of(stand, ground)->size(), 60u);
}

} // namespace
} // namespace windrow::vegetation::trees
