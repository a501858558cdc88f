// Motion vectors as the picture holds them, against the difference of projected positions over two frames; the device's frames
// under the validation layer, if the environment asks for it.
//
// One sample a pixel, so that no two motions are mixed. Positions of blades come from the bends that the wind itself gave in each
// of the two frames, by the CPU's own blades: what the picture says of the last frame is held against what the last frame was.
#include "coupling/blade.h"
#include "tests/figure.h"
#include "vegetation/render/blades.h"
#include "vegetation/render/light_numerics.h"
#include "vegetation/render/renderer.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <optional>
#include <vulkan/vulkan.h>

namespace windrow::vegetation::render {
namespace {

constexpr glm::dvec3 k_anchor{4e5, 0.0, -2.5e5}; // [m]
constexpr int k_width = 320, k_height = 240;
constexpr double k_frame = 1.0 / 30.0; // [s]

struct Stage {
    Stage() : device(engine::must(engine::Device::create())) {
        scene.ground.corner = k_anchor - glm::dvec3(50.0, 0.0, 50.0);
        scene.plants.width = 0.3f; // wide: many pixels each
        scene.plants.stalk.length = 1.0f;
        scene.plants.stalk.rigidity *= 300.0f; // stays nearly upright: no blade hides another, a pixel is a hundredth of one
        scene.plants.length_spread = 0.0f;
        scene.plants.rest_bend = 0.0f;
        scene.plants.rest_bend_spread = 0.0f;
        windrow::Config& config = scene.wind.wind;
        config.cells = {16, 8, 16};
        config.centre = k_anchor + glm::dvec3(0.0, 4.0, -4.0);
        config.boundaries = windrow::Boundaries::open_over_floor();
        config.ambient = {2.0f, 0.0f, 0.7f};
        config.gusts = {.intensity = 0.5f, .length = 6.0f};
        auto made = windrow::vulkan::Wind::create(device->host(), config, {.frames_in_flight = engine::k_frames_in_flight});
        EXPECT_TRUE(made) << made.error();
        wind.emplace(*std::move(made));
        auto drawn = Renderer::create(
            *device, scene, {.width = k_width, .height = k_height, .samples = 1, .shadow_texels = 64, .anchor = k_anchor});
        EXPECT_TRUE(drawn) << drawn.error();
        renderer = *std::move(drawn);
        frames = engine::must(engine::Frames::create(*device));
    }

    // One frame, done when this returns.
    void draw(const Camera& camera) {
        const engine::Frame frame = engine::must(frames->begin());
        renderer->begin(frame);
        engine::must(wind->record(frame.commands, {.dt = k_frame, .slot = frame.slot}));
        const auto recorded = renderer->record(frame, camera, *wind);
        EXPECT_TRUE(recorded) << recorded.error();
        renderer->copy(frame);
        engine::must(frames->finish(frame));
        renderer->clock().collect(frame.slot);
    }

    Scene scene;
    std::unique_ptr<engine::Device> device;
    std::optional<windrow::vulkan::Wind> wind;
    std::unique_ptr<Renderer> renderer;
    std::unique_ptr<engine::Frames> frames; // waits before all else ends
};

Camera camera_at(double x, double turn) {
    Camera camera;
    camera.position = k_anchor + glm::dvec3(x, 1.2, 0.0);
    camera.target = camera.position + glm::dvec3(10.0 * std::sin(turn), -1.0, -10.0 * std::cos(turn));
    return camera;
}

// Place in the picture, 0 to 1.
glm::dvec2 seen(const Camera& camera, glm::dvec3 p) {
    const glm::dvec4 clip =
        glm::dmat4(view_projection(camera, static_cast<float>(k_width) / k_height, k_anchor)) * glm::dvec4(p, 1.0);
    return 0.5 * glm::dvec2(clip) / clip.w + 0.5;
}

glm::dvec2 motion_at(const PictureF& motion, int column, int row) {
    return {static_cast<double>(motion.at(column, row, 0)), static_cast<double>(motion.at(column, row, 1))};
}

double largest(glm::dvec2 v) {
    return std::max(std::abs(v.x), std::abs(v.y));
}

// Ground and sky stand still: what moves them in the picture is the camera.
TEST(Motion, OfGroundAndSkyIsTheCamerasOwn) {
    Stage stage;
    const Camera before = camera_at(0.0, 0.0), now = camera_at(0.03, 0.004);
    stage.draw(before);
    stage.draw(now);
    const PictureF motion = stage.renderer->images().motion_picture();
    const glm::dmat4 back = glm::inverse(glm::dmat4(view_projection(now, static_cast<float>(k_width) / k_height, k_anchor)));
    const glm::dvec3 eye = now.position - k_anchor;
    double worst = 0.0, most = 0.0;
    for (int row = 2; row < k_height; row += 7)
        for (int column = 2; column < k_width; column += 7) {
            const glm::dvec2 place((column + 0.5) / k_width, (row + 0.5) / k_height);
            const glm::dvec4 far = back * glm::dvec4(2.0 * place - 1.0, 1.0, 1.0);
            const glm::dvec3 ray = glm::normalize(glm::dvec3(far) / far.w - eye);
            if (std::abs(ray.y) < 0.03)
                continue; // the ground's rim, 50 m away
            const glm::dvec3 point = ray.y < 0.0 ? eye - ray * (eye.y / ray.y) : eye + 1e7 * ray;
            const glm::dvec2 expected = place - seen(before, point);
            worst = std::max(worst, largest(motion_at(motion, column, row) - expected));
            most = std::max(most, largest(expected));
        }
    // Half floats keep 11 bits, and a device may cut the rest off: 2^-10 of the largest; and float's rounding of places that are
    // about 1.
    WINDROW_EXPECT_FIGURE("render/motion/camera", worst, most / 1024.0 + 4e-6);
    EXPECT_GT(most, 0.005);
}

TEST(Motion, OfBladesIsTheDifferenceOfTheirPlacesInBothFramesWinds) {
    Stage stage;
    std::vector<BladePlace> places;
    for (int n = 0; n < 8; ++n) {
        BladePlace place;
        place.root = {-1.75f + 0.5f * static_cast<float>(n), 0.0f, -3.0f};
        const windrow::PlantKey key = windrow::place_key(place.root.x, place.root.z);
        place.key = {key.x, key.y};
        places.push_back(place);
    }
    const auto grass = engine::must(
        BladeGrid::create(*stage.device, stage.renderer->draw_targets(), stage.scene.plants, stage.scene.look, places));
    stage.renderer->add(*grass);
    for (int n = 0; n < 30; ++n) // a second: gusts have come
        stage.draw(camera_at(0.0, 0.0));
    const Camera before = camera_at(0.0, 0.0), now = camera_at(0.02, -0.003);
    stage.draw(before);
    const std::vector<glm::vec4> bends_before = engine::must(grass->bends());
    stage.draw(now);
    const std::vector<glm::vec4> bends = engine::must(grass->bends());

    // What this frame took for the last one's bend is what the last one had.
    double apart = 0.0, moved = 0.0;
    for (std::size_t n = 0; n < places.size(); ++n)
        for (int axis = 0; axis < 2; ++axis) {
            apart = std::max(apart, static_cast<double>(std::abs(bends[n][2 + axis] - bends_before[n][axis])));
            moved = std::max(moved, static_cast<double>(std::abs(bends[n][axis] - bends_before[n][axis])));
        }
    WINDROW_EXPECT_FIGURE("render/motion/bend_before", apart, 1e-6); // [rad] the same textures, the same text
    EXPECT_GT(moved, 1e-3);

    const auto blades = windrow::Blades::create(stage.scene.plants);
    ASSERT_TRUE(blades) << blades.error();
    const PictureF motion = stage.renderer->images().motion_picture();
    double worst = 0.0, most = 0.0, of_wind = 0.0;
    int compared = 0;
    for (std::size_t n = 0; n < places.size(); ++n)
        for (const float h : {0.2f, 0.4f, 0.6f, 0.8f}) { // rows of the strip
            const windrow::PlantKey key = places[n].key;
            // Shaders count from the anchor, the camera from the world's origin.
            const auto point = [&](glm::vec2 bend, float side) {
                return glm::dvec3(places[n].root) + glm::dvec3(blades->vertex(key, {bend.x, 0.0f, bend.y}, h, side).position);
            };
            const glm::vec2 bend(bends[n]), bend_before(bends_before[n]);
            const glm::dvec3 here = point(bend, 0.0f), there = point(bend_before, 0.0f);
            const glm::dvec2 wide = seen(now, point(bend, 1.0f)) - seen(now, point(bend, -1.0f));
            if (std::abs(wide.x) * k_width < 6.0) // on edge: the pixel may show what lies behind
                continue;
            const glm::dvec2 place = seen(now, here), expected = place - seen(before, there);
            const int column = static_cast<int>(place.x * k_width), row = static_cast<int>(place.y * k_height);
            if (column < 1 || row < 1 || column >= k_width - 1 || row >= k_height - 1)
                continue;
            worst = std::max(worst, largest(motion_at(motion, column, row) - expected));
            most = std::max(most, largest(expected));
            of_wind = std::max(of_wind, largest(seen(now, here) - seen(now, there)));
            ++compared;
        }
    windrow::test::figure("render/motion/compared", compared);
    EXPECT_GE(compared, 8);
    windrow::test::figure("render/motion/of_wind_px", of_wind * k_width);
    // A pixel's middle lies up to 0.7 px from the point, on a blade of some 90 px along which motion grows from the ground's: a
    // fiftieth of the largest.
    WINDROW_EXPECT_FIGURE("render/motion/blades", worst, most / 50.0);
}

TEST(Motion, OfTheFirstFrameIsNone) {
    Stage stage;
    stage.draw(camera_at(0.0, 0.0));
    const PictureF motion = stage.renderer->images().motion_picture();
    EXPECT_TRUE(std::all_of(motion.values.begin(), motion.values.end(), [](float value) { return std::abs(value) < 1e-6f; }));
}

// The stages' times add up to the frame, and a camera that is rejected is told.
TEST(Renderer, TellsItsStagesAndRejectsABadCamera) {
    Stage stage;
    stage.draw(camera_at(0.0, 0.0));
    if (stage.renderer->clock().counts()) {
        std::vector<std::string> names;
        for (const StageTime& time : stage.renderer->clock().times()) {
            names.emplace_back(time.name);
            EXPECT_GE(time.us, 0.0);
        }
        EXPECT_EQ(names, (std::vector<std::string>{"wind", "prepare", "shadow", "colour", "tone", "copy"}));
    }
    const engine::Frame frame = engine::must(stage.frames->begin());
    EXPECT_FALSE(stage.renderer->record(frame, {.view_deg = 0.0f}, *stage.wind));
    engine::must(stage.frames->submit(frame));
}

} // namespace
} // namespace windrow::vegetation::render
