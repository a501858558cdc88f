// Clouds of shells: edge, base, cover, drift with the wind.
#include "tests/fields.h"
#include "tests/figure.h"
#include "vegetation/fur/cloud_shell.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <string>

namespace windrow::vegetation::fur {
namespace {

using windrow::test::Random;

float inside(const CloudShellBlock& cloud, glm::vec2 place, float h) {
    return numerics::windrow_cloud_inside(cloud, place, h, numerics::windrow_cloud_heap(cloud, place));
}

TEST(CloudShell, EndsBeforeItsRim) {
    for (const bool round_rim : {false, true}) {
        const CloudShellBlock cloud = block({.cover = 1.0f, .half_size = {100.0f, 60.0f}, .round_rim = round_rim});
        Random random(1);
        int beyond = 0, within = 0;
        double jump = 0.0;
        for (int n = 0; n < 50'000; ++n) {
            const double turn = random.real(0.0, 6.2831853);
            const glm::dvec2 way(std::cos(turn), std::sin(turn));
            const double to_rim = round_rim ? 1.0 / glm::length(way / glm::dvec2(100.0, 60.0))
                                            : std::min(100.0 / std::abs(way.x), 60.0 / std::abs(way.y));
            beyond += inside(cloud, glm::vec2(1.0001 * to_rim * way), random.uniform(-1.0f, 1.0f)) > 0.0f;
            within += inside(cloud, glm::vec2(0.3 * to_rim * way), 0.0f) > 0.0f;
            const float near = numerics::windrow_cloud_heap(cloud, glm::vec2(0.9999 * to_rim * way));
            jump = std::max(jump, static_cast<double>(near));
        }
        const std::string name = round_rim ? "shells/cloud/round_rim" : "shells/cloud/square_rim";
        EXPECT_EQ(beyond, 0) << name;
        WINDROW_EXPECT_FIGURE(name + "/heap_beside_it", jump, 1e-5); // no more than the rim leaves there
        EXPECT_GT(windrow::test::figure(name + "/within", within / 50'000.0), 0.9);
    }
}

TEST(CloudShell, LayersNestAndBasesAreFlat) {
    const CloudShellSettings settings{.base = 0.25f, .billow = 0.0f};
    const CloudShellBlock cloud = block(settings);
    Random random(2);
    int rises = 0;
    double off = 0.0, highest = 0.0;
    for (int n = 0; n < 5'000; ++n) {
        const glm::vec2 place(random.uniform(-60.0f, 60.0f), random.uniform(-60.0f, 60.0f));
        const float heap = numerics::windrow_cloud_heap(cloud, place);
        float last = 2.0f;
        for (int k = 0; k <= 20; ++k) {
            const float now = inside(cloud, place, static_cast<float>(k) / 20.0f);
            rises += now > last;
            last = now;
        }
        const double top = static_cast<double>(numerics::windrow_cloud_top(heap));
        highest = std::max(highest, top);
        if (top > 0.0) // as far below as its quarter
            off = std::max({off, std::abs(static_cast<double>(inside(cloud, place, static_cast<float>(-0.25 * top)))),
                            std::abs(static_cast<double>(inside(cloud, place, static_cast<float>(top))))});
    }
    EXPECT_EQ(rises, 0);
    WINDROW_EXPECT_FIGURE("shells/cloud/top_and_base_off", off, 1e-5);
    EXPECT_GT(windrow::test::figure("shells/cloud/highest", highest), 0.9);
    EXPECT_LE(highest, 1.0);
}

TEST(CloudShell, CoverIsAboutTheShareOfTheSky) {
    double last = -1.0;
    for (const float cover : {0.0f, 0.2f, 0.45f, 0.7f, 1.0f}) {
        const CloudShellBlock cloud = block({.cover = cover, .size = 10.0f, .half_size = glm::vec2(1e4f), .fading = 1.0f});
        Random random(3);
        int covered = 0;
        for (int n = 0; n < 20'000; ++n)
            covered += numerics::windrow_cloud_heap(cloud, {random.uniform(-5e3f, 5e3f), random.uniform(-5e3f, 5e3f)}) > 0.0f;
        const double share =
            windrow::test::figure("shells/cloud/covered_at_" + std::to_string(cover).substr(0, 4), covered / 20'000.0);
        EXPECT_NEAR(share, static_cast<double>(cover), 0.08);
        EXPECT_GT(share, last);
        last = share;
    }
}

// A drift is the pattern's shift, to the bit where floats hold the places: a quarter metre is dyadic.
TEST(CloudShell, DriftIsAShift) {
    const CloudShellSettings settings{.half_size = glm::vec2(1e4f), .fading = 1.0f};
    const glm::dvec2 drift(37.25, -512.5);
    const CloudShellBlock still = block(settings), moved = block(settings, drift);
    Random random(4);
    for (int n = 0; n < 5'000; ++n) {
        const glm::vec2 place(0.25f * static_cast<float>(random.integer(-400, 400)),
                              0.25f * static_cast<float>(random.integer(-400, 400)));
        const float h = random.uniform(-1.0f, 1.0f);
        ASSERT_EQ(inside(moved, place + glm::vec2(drift), h), inside(still, place, h));
    }
}

// Of a slab, whose heap is 1 everywhere: 3 / soft for each half height that lies deeper than the edge.
TEST(CloudShell, SunComesThroughWhatLiesTowardIt) {
    const CloudShellSettings settings{.cover = 1.0f, .billow = 0.0f, .soft = 0.15f, .half_size = glm::vec2(1e4f), .fading = 1.0f};
    const CloudShellBlock cloud = block(settings);
    Random random(5);
    int slabs = 0;
    double off = 0.0;
    for (int n = 0; n < 5'000; ++n) {
        const glm::vec2 place(random.uniform(-500.0f, 500.0f), random.uniform(-500.0f, 500.0f));
        const auto upward = [&](float h) { return numerics::windrow_cloud_sunward(cloud, place, h, glm::vec2(0.0f), 1.0f); };
        const float top = numerics::windrow_cloud_top(numerics::windrow_cloud_heap(cloud, place));
        EXPECT_EQ(upward(1.0f), 0.0f) << "nothing above the cloud";
        EXPECT_GE(upward(0.1f), upward(0.4f));
        EXPECT_GE(upward(0.4f), upward(0.7f));
        if (top < 0.95f)
            continue;
        ++slabs;
        off = std::max(off, std::abs(static_cast<double>(upward(0.0f)) / (3.0 * 0.75 / 0.15) - 1.0));
    }
    EXPECT_GT(slabs, 100);
    WINDROW_EXPECT_FIGURE("shells/cloud/slab_depth_off", off, 1e-4);
}

TEST(CloudShell, SoftEdgeBeginsAtNothingAndThinEdgesGlow) {
    EXPECT_EQ(numerics::windrow_cloud_thickness(0.2f, 0.0f, 0.01f), 0.0f);
    EXPECT_EQ(numerics::windrow_cloud_thickness(0.2f, -1.0f, 0.01f), 0.0f);
    EXPECT_NEAR(numerics::windrow_cloud_thickness(0.2f, 0.1f, 0.01f), 3.0f * 0.01f / 0.2f * 0.5f, 1e-6f);
    EXPECT_NEAR(numerics::windrow_cloud_thickness(0.2f, 0.7f, 0.01f), 3.0f * 0.01f / 0.2f, 1e-6f) << "beyond the edge";
    float last = 2.0f;
    for (const float depth : {0.0f, 0.5f, 2.0f, 8.0f, 30.0f}) {
        const float glow = numerics::windrow_cloud_glow(depth, -1.0f);
        EXPECT_LT(glow, last);
        EXPECT_GT(glow, 0.0f);
        last = glow;
    }
    EXPECT_GT(numerics::windrow_cloud_glow(0.2f, 1.0f), 1.2f) << "against the sun";
    EXPECT_LT(numerics::windrow_cloud_glow(8.0f, 1.0f), 0.3f);
}

TEST(CloudShell, RejectsWhatIsOutOfRange) {
    EXPECT_TRUE(validate(CloudShellSettings{}));
    for (const float value : {std::nanf(""), INFINITY, -1e9f, 1e9f})
        for (const auto field :
             {&CloudShellSettings::cover, &CloudShellSettings::size, &CloudShellSettings::base, &CloudShellSettings::billow,
              &CloudShellSettings::soft, &CloudShellSettings::fading, &CloudShellSettings::height}) {
            CloudShellSettings settings;
            settings.*field = value;
            EXPECT_FALSE(validate(settings));
        }
    EXPECT_FALSE(validate(CloudShellSettings{.octaves = 0}));
    EXPECT_FALSE(validate(CloudShellSettings{.seed = -1}));
    EXPECT_FALSE(validate(CloudShellSettings{.half_size = {0.0f, 1.0f}}));
}

} // namespace
} // namespace windrow::vegetation::fur
