// The sheet of clouds, on the CPU: the text that the shaders include.
#include "tests/figure.h"
#include "vegetation/render/frame_block.h"
#include "vegetation/render/light_numerics.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace windrow::vegetation::render {
namespace {

using namespace numerics;

const glm::vec3 k_sun = glm::normalize(glm::vec3(0.5f, 0.6f, -0.4f));

WindrowClouds shared(const Clouds& clouds, double time = 0.0) {
    const CloudBlock block = cloud_block(clouds, {1.0e5, 20.0, -3.0e4}, time);
    return {block.place, block.form};
}

// Places of a square of 6 km.
template <class Each>
void over_places(Each each) {
    for (int row = 0; row < 60; ++row)
        for (int column = 0; column < 60; ++column)
            each(glm::vec2(100.0f * static_cast<float>(column) - 3000.0f, 100.0f * static_cast<float>(row) - 3000.0f));
}

TEST(CloudLayer, NoCoverIsNoCloudToTheBit) {
    const WindrowClouds none = shared({});
    over_places([&](glm::vec2 place) {
        EXPECT_EQ(windrow_cloud_depth(none, place, 5), 0.0f);
        EXPECT_EQ(windrow_cloud_light(none, k_sun, {place.x, 0.0f, place.y}), 1.0f);
    });
    const glm::vec4 sky =
        windrow_cloud_radiance(none, k_sun, glm::vec3(0.0f), glm::vec3(0.0f, 1.0f, 0.0f), glm::vec3(1.0f), glm::vec3(1.0f));
    EXPECT_EQ(sky, glm::vec4(0.0f, 0.0f, 0.0f, 1.0f));
}

TEST(CloudLayer, CoverIsTheShareOfSkyThatIsCovered) {
    double before = -1.0;
    for (const float cover : {0.1f, 0.3f, 0.5f, 0.7f, 0.9f}) {
        const WindrowClouds clouds = shared({.cover = cover});
        double covered = 0.0;
        over_places([&](glm::vec2 place) { covered += windrow_cloud_depth(clouds, place, 5) > 0.1f ? 1.0 / 3600.0 : 0.0; });
        EXPECT_GT(covered, before) << cover;
        WINDROW_EXPECT_FIGURE("render/clouds/cover_off_" + std::to_string(static_cast<int>(100.0f * cover + 0.5f)),
                              std::abs(covered - static_cast<double>(cover)), 0.2); // a word, not a measure
        before = covered;
    }
}

TEST(CloudLayer, TheyDriftWithTheWindUpThere) {
    const Clouds clouds{.cover = 0.5f, .drift = {8.0f, -3.0f}};
    const WindrowClouds now = shared(clouds, 0.0), later = shared(clouds, 40.0);
    double worst = 0.0;
    over_places([&](glm::vec2 place) {
        const float moved = windrow_cloud_depth(later, place + 40.0f * clouds.drift, 5);
        worst = std::max(worst, std::abs(static_cast<double>(moved - windrow_cloud_depth(now, place, 5))));
    });
    WINDROW_EXPECT_FIGURE("render/clouds/drift", worst, 5e-3); // of a depth of 3: places of 1e5 m in float cells
}

TEST(CloudLayer, TheyTakeLightAndNeverAddToTheBeam) {
    const WindrowClouds clouds = shared({.cover = 0.7f, .depth = 10.0f});
    float least = 1.0f, most = 0.0f;
    over_places([&](glm::vec2 place) {
        const float light = windrow_cloud_light(clouds, k_sun, {place.x, 3.0f, place.y});
        least = std::min(least, light);
        most = std::max(most, light);
        const glm::vec3 ray = glm::normalize(glm::vec3(place.x, 900.0f, place.y));
        const glm::vec4 seen = windrow_cloud_radiance(clouds, k_sun, glm::vec3(0.0f), ray, glm::vec3(1.0f), glm::vec3(0.2f));
        EXPECT_TRUE(seen.a >= 0.0f && seen.a <= 1.0f && seen.r >= 0.0f && seen.r < 2.0f) << seen.r << ' ' << seen.a;
    });
    EXPECT_LE(most, 1.0f);
    EXPECT_LT(least, 0.5f);
    EXPECT_GE(least, 0.3f);
    EXPECT_EQ(windrow_cloud_light(clouds, k_sun, {0.0f, 5000.0f, 0.0f}), 1.0f); // above them
}

TEST(CloudLayer, ValuesThatMakeNoSenseAreNamed) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const Clouds& bad : {Clouds{.cover = 1.5f}, Clouds{.cover = nan}, Clouds{.size = 0.0f}, Clouds{.depth = -1.0f},
                              Clouds{.drift = {nan, 0.0f}}, Clouds{.height = std::numeric_limits<double>::infinity()}}) {
        const auto judged = validate(bad);
        ASSERT_FALSE(judged);
        EXPECT_NE(judged.error().find("clouds."), std::string::npos) << judged.error();
    }
    EXPECT_TRUE(validate(Clouds{}));
}

} // namespace
} // namespace windrow::vegetation::render
