// What a scene rejects, where its ground lies, and shadows that stand still.
#include "tests/figure.h"
#include "vegetation/render/frame_block.h"
#include "vegetation/render/renderer.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>
#include <limits>

namespace windrow::vegetation::render {
namespace {

TEST(Scene, TheDefaultOneIsDrawn) {
    const auto judged = validate(Scene{});
    EXPECT_TRUE(judged) << judged.error();
    EXPECT_TRUE(validate(RenderSettings{}));
}

TEST(Scene, BadInputIsRejectedByName) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN(), infinite = std::numeric_limits<float>::infinity();
    struct SceneFault {
        const char* field;
        std::function<void(Scene&)> spoil;
    };
    const SceneFault cases[] = {
        {"camera.position is (0, nan, 0) m", [](Scene& s) { s.camera.position.y = static_cast<double>(nan); }},
        {"camera.target", [](Scene& s) { s.camera.target = s.camera.position + glm::dvec3(0.0, 5.0, 0.0); }},
        {"camera.target", [](Scene& s) { s.camera.target = s.camera.position; }},
        {"camera.view_deg", [](Scene& s) { s.camera.view_deg = 0.0f; }},
        {"camera.near", [](Scene& s) { s.camera.near = -1.0f; }},
        {"camera.far", [](Scene& s) { s.camera.far = s.camera.near; }},
        {"camera.exposure", [](Scene& s) { s.camera.exposure = 0.0f; }},
        {"sun.elevation_deg", [](Scene& s) { s.sun.elevation_deg = -3.0f; }},
        {"sun.azimuth_deg", [](Scene& s) { s.sun.azimuth_deg = infinite; }},
        {"sun.irradiance", [](Scene& s) { s.sun.irradiance = 0.0f; }},
        {"sun.haze", [](Scene& s) { s.sun.haze = 7.0f; }},
        {"sun.radius_deg", [](Scene& s) { s.sun.radius_deg = 0.0f; }},
        {"fog.density", [](Scene& s) { s.fog.density = -0.1f; }},
        {"fog.fall", [](Scene& s) { s.fog.fall = nan; }},
        {"fog.base", [](Scene& s) { s.fog.base = 1e300; }},
        {"ground.corner is (-50, 0, 2e+09) m", [](Scene& s) { s.ground.corner.z = 2e9; }},
        {"look.tip is (0.12, 1.5, 0.045)", [](Scene& s) { s.look.tip.g = 1.5f; }},
        {"look has a brightest colour", [](Scene& s) { s.look.dry = glm::vec3(0.6f); }},
        {"look.gloss", [](Scene& s) { s.look.gloss = 0.0f; }},
        {"look.even_from", [](Scene& s) { s.look.even_from = -1.0f; }},
        {"width", [](Scene& s) { s.plants.width = -1.0f; }},
        {"cell_size", [](Scene& s) { s.wind.wind.cell_size = 0.0f; }},
    };
    for (const SceneFault& each : cases) {
        Scene scene;
        each.spoil(scene);
        const auto judged = validate(scene);
        ASSERT_FALSE(judged) << each.field;
        EXPECT_NE(judged.error().find(each.field), std::string::npos) << judged.error();
    }
    EXPECT_FALSE(validate(RenderSettings{.width = 0}));
    EXPECT_FALSE(validate(RenderSettings{.samples = 3}));
    EXPECT_FALSE(validate(RenderSettings{.quality = {.light_bytes = 6}}));
    EXPECT_FALSE(validate(RenderSettings{.near_shadow = 90.0f}));
    EXPECT_FALSE(validate(RenderSettings{.anchor = {static_cast<double>(nan), 0.0, 0.0}}));
}

TEST(Ground, HeightsAreThoseOfTheTrianglesThatAreDrawn) {
    const Ground ground{.corner = {10.0, 100.0, 20.0}, .heights = *HeightMap::create({2, 2}, 2.0f, {0.0f, 1.0f, 3.0f, 8.0f})};
    ASSERT_TRUE(validate(ground));
    EXPECT_DOUBLE_EQ(ground.height(10.0, 20.0), 100.0);
    EXPECT_DOUBLE_EQ(ground.height(12.0, 20.0), 101.0);
    EXPECT_DOUBLE_EQ(ground.height(10.0, 22.0), 103.0);
    EXPECT_DOUBLE_EQ(ground.height(12.0, 22.0), 108.0);
    EXPECT_DOUBLE_EQ(ground.height(11.0, 21.0), 102.0); // the middle lies on the edge between 1 and 3; bilinear would have 103
    EXPECT_DOUBLE_EQ(ground.height(-90.0, 20.0), 100.0);
    EXPECT_DOUBLE_EQ(Ground{}.height(3.0, 4.0), 0.0);
}

// Edges of shadows swim unless the map moves by whole texels: a fixed point keeps its place within its texel.
TEST(Shadow, AFixedPointKeepsItsPlaceInItsTexelWhileTheCameraMovesAndTurns) {
    const SkyBlock sky = sky_block({});
    const glm::dvec3 anchor(4e5, 0.0, -2.5e5);
    constexpr int texels = 1024;
    const glm::vec4 thing(1.3f, 0.4f, -5.0f, 1.0f);
    double worst = 0.0;
    glm::vec2 first(0.0f);
    float first_texel = 0.0f;
    for (int n = 0; n < 50; ++n) {
        Camera camera{.position = anchor + glm::dvec3(0.037 * n, 1.7, 0.11 * n)};
        camera.target = camera.position + glm::dvec3(std::sin(0.05 * n), -0.1, -std::cos(0.05 * n));
        const ShadowView view = shadow_view(camera, 16.0f / 9.0f, anchor, sky, 0.1f, 12.0f, texels);
        const glm::vec4 clip = view.matrix * thing;
        const glm::vec2 at = 0.5f * static_cast<float>(texels) * glm::vec2(clip);
        const glm::vec2 within = at - glm::floor(at);
        if (n == 0) {
            first = within;
            first_texel = view.texel;
        }
        EXPECT_EQ(view.texel, first_texel);
        EXPECT_GT(clip.z, 0.0f);
        EXPECT_LT(clip.z, 1.0f);
        for (int axis = 0; axis < 2; ++axis) {
            const double moved = std::abs(static_cast<double>(within[axis] - first[axis]));
            worst = std::max(worst, std::min(moved, 1.0 - moved));
        }
    }
    WINDROW_EXPECT_FIGURE("render/shadow/swim_texels", worst, 0.01); // float's rounding of 512 texels is 3e-5 of one; sums of it
}

// All that the slice shows lies in the map.
TEST(Shadow, TheMapHoldsTheWholeSlice) {
    const SkyBlock sky = sky_block({});
    const float aspect = 16.0f / 9.0f;
    const Camera camera;
    const ShadowView view = shadow_view(camera, aspect, glm::dvec3(0.0), sky, 0.1f, 12.0f, 1024);
    const glm::vec3 ahead(glm::normalize(camera.target - camera.position)),
        right = glm::normalize(glm::cross(ahead, glm::vec3(0.0f, 1.0f, 0.0f)));
    const glm::vec3 up = glm::cross(right, ahead), eye(camera.position);
    const float tangent = std::tan(glm::radians(0.5f * camera.view_deg));
    double worst = 0.0;
    for (const float distance : {0.1f, 12.0f})
        for (const float x : {-1.0f, 1.0f})
            for (const float y : {-1.0f, 1.0f}) {
                const glm::vec3 p = eye + distance * (ahead + x * aspect * tangent * right + y * tangent * up);
                const glm::vec4 clip = view.matrix * glm::vec4(p, 1.0f);
                worst = std::max({worst, static_cast<double>(std::abs(clip.x)), static_cast<double>(std::abs(clip.y))});
            }
    WINDROW_EXPECT_FIGURE("render/shadow/slice", worst, 1.0 + 2.0 / 1024.0); // the map lies within a texel of the slice's ball
}

} // namespace
} // namespace windrow::vegetation::render
