// Patches and paths: how much they leave bare, where, and that they only take.
#include "tests/figure.h"
#include "vegetation/grass/mask_patterns.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <string>

namespace windrow::vegetation::grass {
namespace {

PlacementMask even(float alpha = 1.0f) {
    auto mask = PlacementMask::create({601, 601}, {300.0f, 300.0f}, alpha);
    EXPECT_TRUE(mask) << mask.error();
    return *std::move(mask);
}

double bare_fraction(const PlacementMask& mask) {
    const auto bare = std::count_if(mask.values().begin(), mask.values().end(), [](float alpha) { return alpha < 0.5f; });
    return static_cast<double>(bare) / static_cast<double>(mask.values().size());
}

TEST(MaskPatterns, PatchesLeaveAboutTheirShareBare) {
    double before = 0.0;
    for (const float share : {0.25f, 0.5f, 0.75f, 0.95f}) {
        PlacementMask mask = even();
        ASSERT_TRUE(thin_out(mask, {.share = share, .size = 4.0f}));
        const double measured = bare_fraction(mask);
        WINDROW_EXPECT_FIGURE("grass/mask/bare_" + std::to_string(static_cast<int>(100.0f * share)),
                              std::abs(measured - static_cast<double>(share)), 0.1);
        EXPECT_GT(measured, before);
        before = measured;
    }
}

TEST(MaskPatterns, PathIsBareInItsMiddleAndWholeAside) {
    PlacementMask mask = even();
    ASSERT_TRUE(tread(mask, {.width = 2.0f, .at = 150.0f}));
    for (float z = 0.0f; z <= 300.0f; z += 0.5f) {
        int bare = 0;
        for (float x = 146.0f; x <= 154.0f; x += 0.5f)
            bare += mask.alpha({x, z}) == 0.0f ? 1 : 0;
        EXPECT_GE(bare, 2) << z; // 1.25 m of the 2 m are bare whatever the rim's noise, in steps of half a metre
        EXPECT_EQ(mask.alpha({145.5f, z}), 1.0f) << z;
        EXPECT_EQ(mask.alpha({154.5f, z}), 1.0f) << z;
    }
}

TEST(MaskPatterns, TakeAndNeverGive) {
    PlacementMask mask = even(0.4f);
    ASSERT_TRUE(thin_out(mask, {.share = 0.5f}));
    ASSERT_TRUE(tread(mask, {.width = 3.0f, .at = 100.0f}));
    EXPECT_LE(*std::max_element(mask.values().begin(), mask.values().end()), even(0.4f).values()[0]);
}

TEST(MaskPatterns, ZeroIsNoPatternAndSeedsDiffer) {
    PlacementMask none = even(), one = even(), other = even();
    ASSERT_TRUE(thin_out(none, {}));
    ASSERT_TRUE(tread(none, {}));
    EXPECT_EQ(bare_fraction(none), 0.0);
    ASSERT_TRUE(thin_out(one, {.share = 0.5f, .seed = 1}));
    ASSERT_TRUE(thin_out(other, {.share = 0.5f, .seed = 2}));
    EXPECT_FALSE(std::equal(one.values().begin(), one.values().end(), other.values().begin()));
}

TEST(MaskPatterns, RejectBadValuesAndTouchNothing) {
    constexpr float k_nan = std::numeric_limits<float>::quiet_NaN(), k_inf = std::numeric_limits<float>::infinity();
    PlacementMask mask = even();
    for (const float bad : {k_nan, k_inf, -0.1f, 0.96f})
        EXPECT_FALSE(thin_out(mask, {.share = bad})) << bad;
    for (const float bad : {k_nan, k_inf, 0.0f, -4.0f, 1001.0f})
        EXPECT_FALSE(thin_out(mask, {.share = 0.5f, .size = bad})) << bad;
    for (const float bad : {k_nan, k_inf, -1.0f, 21.0f})
        EXPECT_FALSE(tread(mask, {.width = bad})) << bad;
    for (const float bad : {k_nan, k_inf, -1e6f})
        EXPECT_FALSE(tread(mask, {.width = 1.0f, .at = bad})) << bad;
    EXPECT_EQ(bare_fraction(mask), 0.0);
    EXPECT_EQ(thin_out(mask, {.share = 2.0f}).error(), "mask.bare is 2: give 0 (no patches) to 0.95.");
}

} // namespace
} // namespace windrow::vegetation::grass
