// Motion vectors as the picture holds them, against the difference of projected positions over two frames; the device's frames
// under the validation layer, if the environment asks for it.
//
// One sample a pixel, so that no two motions are mixed. That of blades: grass_layer_test.cpp.
#include "tests/figure.h"
#include "vegetation/tests/render/grass_stage.h"

#include <algorithm>
#include <cmath>

namespace windrow::vegetation::render {
namespace {

constexpr glm::dvec3 k_anchor{4e5, 0.0, -2.5e5}; // [m]
constexpr int k_motion_width = 320, k_motion_height = 240;
constexpr double k_frame = 1.0 / 30.0; // [s]

Scene windy_scene() {
    Scene scene;
    scene.ground.corner = k_anchor - glm::dvec3(50.0, 0.0, 50.0);
    windrow::Config& config = scene.wind.wind;
    config.cells = {16, 8, 16};
    config.centre = k_anchor + glm::dvec3(0.0, 4.0, -4.0);
    config.boundaries = windrow::Boundaries::open_over_floor();
    config.ambient = {2.0f, 0.0f, 0.7f};
    config.gusts = {.intensity = 0.5f, .length = 6.0f};
    return scene;
}

RenderSettings small_picture() {
    return {.width = k_motion_width, .height = k_motion_height, .samples = 1, .shadow_texels = 64, .anchor = k_anchor};
}

Camera camera_at(double x, double turn) {
    Camera camera;
    camera.position = k_anchor + glm::dvec3(x, 1.2, 0.0);
    camera.target = camera.position + glm::dvec3(10.0 * std::sin(turn), -1.0, -10.0 * std::cos(turn));
    return camera;
}

// Place in the picture, 0 to 1.
glm::dvec2 seen(const Camera& camera, glm::dvec3 p) {
    const glm::dvec4 clip =
        glm::dmat4(view_projection(camera, static_cast<float>(k_motion_width) / k_motion_height, k_anchor)) * glm::dvec4(p, 1.0);
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
    test::GrassStage stage(windy_scene(), small_picture());
    const Camera before = camera_at(0.0, 0.0), now = camera_at(0.03, 0.004);
    stage.draw(before, k_frame);
    stage.draw(now, k_frame);
    const PictureF motion = stage.renderer->images().motion_picture();
    const glm::dmat4 back =
        glm::inverse(glm::dmat4(view_projection(now, static_cast<float>(k_motion_width) / k_motion_height, k_anchor)));
    const glm::dvec3 eye = now.position - k_anchor;
    double worst = 0.0, most = 0.0;
    for (int row = 2; row < k_motion_height; row += 7)
        for (int column = 2; column < k_motion_width; column += 7) {
            const glm::dvec2 place((column + 0.5) / k_motion_width, (row + 0.5) / k_motion_height);
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

TEST(Motion, OfTheFirstFrameIsNone) {
    test::GrassStage stage(windy_scene(), small_picture());
    stage.draw(camera_at(0.0, 0.0), k_frame);
    const PictureF motion = stage.renderer->images().motion_picture();
    EXPECT_TRUE(std::all_of(motion.values.begin(), motion.values.end(), [](float value) { return std::abs(value) < 1e-6f; }));
}

// The stages' times add up to the frame, and a camera that is rejected is told.
TEST(Renderer, TellsItsStagesAndRejectsABadCamera) {
    test::GrassStage stage(windy_scene(), small_picture());
    stage.draw(camera_at(0.0, 0.0), k_frame);
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
