// The blur of an open shutter, on the device: a bar that moves before the ground, whose blurred picture is known.
//
// A bar that moves by v px a frame under a shutter open for the fraction f is seen on a ramp at each edge, f v px wide: the
// fraction of that time for which the bar covers a pixel. What it covers in all is its width, whatever the shutter.
#include "tests/figure.h"
#include "vegetation/render/bodies.h"
#include "vegetation/render/light_numerics.h"
#include "vegetation/render/renderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <optional>

namespace windrow::vegetation::render {
namespace {

constexpr int k_width = 320, k_height = 180;
constexpr float k_distance = 6.0f; // [m] of the bar from the eye
constexpr float k_view_deg = 40.0f;

float metres_a_pixel() {
    return 2.0f * k_distance * std::tan(glm::radians(0.5f * k_view_deg)) / k_height;
}

struct Shutter {
    float open_deg = 180.0f;
    int samples = 1;
};

/// A bar upright before a far ground and the sky, turned by `turn` [rad] about the line of sight.
class Stage {
  public:
    explicit Stage(Shutter shutter, float turn = 0.0f) : device_(engine::must(engine::Device::create())), turn_(turn) {
        Scene scene;
        scene.sun.elevation_deg = 40.0f;
        scene.sun.azimuth_deg = 80.0f; // on the bar's face
        scene.fog.density = 0.0f;
        scene.wind.wind.cells = {8, 8, 8};
        wind_.emplace(engine::must(
            windrow::vulkan::Wind::create(device_->host(), scene.wind.wind, {.frames_in_flight = engine::k_frames_in_flight})));
        renderer_ = engine::must(Renderer::create(*device_, scene,
                                                  {.width = k_width,
                                                   .height = k_height,
                                                   .samples = shutter.samples,
                                                   .shadow_texels = 64,
                                                   .near_shadow = 1.0f,
                                                   .far_shadow = 2.0f,
                                                   .shutter_deg = shutter.open_deg}));
        const glm::vec3 half(15.0f * metres_a_pixel(), 40.0f, 0.01f); // 30 px wide, beyond the picture above and below
        bar_ = engine::must(Bodies::create(*device_, renderer_->draw_targets(), std::array{box(half, glm::vec3(0.9f))}));
        renderer_->add(*bar_);
        frames_ = engine::must(engine::Frames::create(*device_));
    }

    /// Light of a frame with the bar's middle at `across` [px] from the picture's.
    PictureF light(glm::vec2 across) {
        draw(across);
        return renderer_->images().light_picture();
    }
    /// The same where the bar has been there for a frame.
    PictureF at_rest(glm::vec2 across) {
        draw(across);
        return light(across);
    }
    Picture8 picture(glm::vec2 across) {
        draw(across);
        return renderer_->images().picture();
    }
    std::vector<StageTime> times() const { return renderer_->clock().times(); }

  private:
    void draw(glm::vec2 across) {
        const engine::Frame frame = engine::must(frames_->begin());
        renderer_->begin(frame);
        engine::must(wind_->record(frame.commands, {.dt = 0.0, .slot = frame.slot}));
        Camera camera;
        camera.position = {0.0, 3.0, 0.0};
        camera.target = {0.0, 3.0, -1.0};
        camera.view_deg = k_view_deg;
        const float metre = metres_a_pixel();
        const glm::vec3 place(across.x * metre, 3.0f - across.y * metre, -k_distance); // y down, as in the picture
        bar_->place(0, glm::rotate(glm::translate(glm::mat4(1.0f), place), turn_, glm::vec3(0.0f, 0.0f, 1.0f)));
        engine::must(renderer_->record(frame, camera, *wind_));
        renderer_->copy(frame);
        engine::must(frames_->finish(frame));
        renderer_->clock().collect(frame.slot);
    }

    std::unique_ptr<engine::Device> device_;
    float turn_;
    std::optional<windrow::vulkan::Wind> wind_;
    std::unique_ptr<Renderer> renderer_;
    std::unique_ptr<Bodies> bar_;
    std::unique_ptr<engine::Frames> frames_; // waits before all else ends
};

/// Fraction of the bar in each column, over rows of ground: from the light of a frame, of one without the bar, and of one whose
/// middle it covers.
std::vector<double> coverage(const PictureF& seen, const PictureF& behind, const PictureF& before) {
    std::vector<double> covered(k_width);
    for (int column = 0; column < k_width; ++column) {
        double more = 0.0, most = 0.0;
        for (int row = 110; row < 170; ++row) {
            const auto ground = static_cast<double>(behind.at(column, row, 0));
            more += static_cast<double>(seen.at(column, row, 0)) - ground;
            most += static_cast<double>(before.at(k_width / 2, row, 0)) - ground;
        }
        covered[column] = more / most;
    }
    return covered;
}

/// [px] Of an edge: from the place where a straight ramp through 1/4 and 3/4 begins to where it ends.
double ramp(const std::vector<double>& covered) {
    const auto crossing = [&](double level) {
        for (int column = 1; column < k_width; ++column)
            if (covered[column - 1] < level && covered[column] >= level)
                return column - 1 + (level - covered[column - 1]) / (covered[column] - covered[column - 1]);
        return -1.0;
    };
    return 2.0 * (crossing(0.75) - crossing(0.25));
}

double sum_of(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values)
        sum += value;
    return sum;
}

struct Case {
    float pixels_a_frame;
    Shutter shutter;
};

class MotionBlurWidth : public testing::TestWithParam<Case> {};

TEST_P(MotionBlurWidth, OfABarIsItsMotionTimesTheShutter) {
    const auto [speed, shutter] = GetParam();
    Stage stage(shutter);
    const PictureF behind = stage.at_rest({5000.0f, 0.0f});
    const PictureF before = stage.at_rest({0.0f, 0.0f});
    (void)stage.light({-speed, 0.0f});
    const std::vector<double> covered = coverage(stage.light({0.0f, 0.0f}), behind, before);
    const std::string name = "render/motion_blur/" + std::to_string(static_cast<int>(speed)) + "_px_" +
                             std::to_string(static_cast<int>(shutter.open_deg)) + "_deg_" + std::to_string(shutter.samples);
    const double width = static_cast<double>(std::abs(speed) * shutter.open_deg / 360.0f);
    WINDROW_EXPECT_FIGURE(name + "/width_off_px", std::abs(ramp(covered) - width), 1.0);
    WINDROW_EXPECT_FIGURE(name + "/covered_off", std::abs(sum_of(covered) / sum_of(coverage(before, behind, before)) - 1.0),
                          0.005);
    // Nothing is seen where the bar never was while the shutter was open, and the bar is whole where it always was.
    const int reach = static_cast<int>(std::ceil(0.5 * width)) + 1;
    for (int column = 0; column < k_width; ++column) {
        const int from_edge = 15 - std::abs(column - k_width / 2);
        if (std::abs(from_edge) > reach + 1) {
            EXPECT_NEAR(covered[column], from_edge > 0 ? 1.0 : 0.0, 0.004) << name << ", column " << column;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Speeds, MotionBlurWidth,
                         testing::Values(Case{16.0f, {180.0f, 1}}, Case{-16.0f, {180.0f, 4}}, Case{10.0f, {360.0f, 4}}),
                         [](const auto& one) {
                             const Case& of = one.param;
                             return std::string(of.pixels_a_frame < 0.0f ? "left" : "right") +
                                    std::to_string(static_cast<int>(std::abs(of.pixels_a_frame))) + "_open" +
                                    std::to_string(static_cast<int>(of.shutter.open_deg)) + "_samples" +
                                    std::to_string(of.shutter.samples);
                         });

// A bar that moves along itself looks as at rest: its edges stay sharp. A vector whose one component has the wrong sign, or whose
// components are mixed up, would blur them.
TEST(MotionBlur, AlongABarLeavesItsEdges) {
    constexpr float turn = -0.6f;
    const glm::vec2 along = 12.0f * glm::vec2(std::sin(-turn), std::cos(-turn) * -1.0f);
    Stage still({0.0f, 4}, turn), blurred({180.0f, 4}, turn);
    (void)still.light(-along);
    (void)blurred.light(-along);
    const PictureF a = still.light({0.0f, 0.0f}), b = blurred.light({0.0f, 0.0f});
    double most = 0.0, contrast = 0.0, off = 0.0;
    for (int row = 60; row < 120; ++row)
        for (int column = 60; column < k_width - 60; ++column) {
            off += std::abs(static_cast<double>(a.at(column, row, 0) - b.at(column, row, 0)));
            most = std::max(most, static_cast<double>(a.at(column, row, 0)));
            contrast += static_cast<double>(a.at(column, row, 0));
        }
    // A blur across it of 6 px would change some 3 px of the 30 at each of two edges by half: a tenth. Samples at whole pixels
    // move an edge by half a pixel at most, and a pixel that it cuts has light of both: a hundredth.
    WINDROW_EXPECT_FIGURE("render/motion_blur/along", off / contrast, 0.01);
    EXPECT_GT(most, 0.0);
}

// The bits of a still scene are those of a picture without a shutter.
TEST(MotionBlur, OfAStillSceneIsNone) {
    Stage still({0.0f, 4}), blurred({180.0f, 4});
    (void)still.light({3.0f, 0.0f});
    (void)blurred.light({3.0f, 0.0f});
    EXPECT_EQ(still.light({3.0f, 0.0f}).values, blurred.light({3.0f, 0.0f}).values);
    EXPECT_EQ(still.picture({3.0f, 0.0f}).values, blurred.picture({3.0f, 0.0f}).values);
    const std::vector<StageTime> none = still.times(), one = blurred.times();
    const auto blurs = [](const StageTime& time) { return std::string(time.name) == "blur"; };
    EXPECT_TRUE(std::none_of(none.begin(), none.end(), blurs)) << "a shutter that is shut costs nothing";
    EXPECT_TRUE(one.empty() || std::any_of(one.begin(), one.end(), blurs));
}

// Weights along a line of samples cover a pixel for the whole time, whatever the length of the streak.
TEST(MotionBlur, CoversForTheWholeTimeBetweenLongStreaks) {
    for (const float half_length : {0.6f, 1.0f, 3.3f, 9.0f}) {
        double covered = 0.0;
        for (float away = -20.0f; away <= 20.0f; away += 0.25f)
            covered += static_cast<double>(numerics::windrow_blur_covers(half_length, std::abs(away), 0.25f));
        EXPECT_NEAR(covered, 1.0, 0.25 / static_cast<double>(half_length)) << half_length;
    }
    EXPECT_EQ(numerics::windrow_blur_covers(0.0f, 0.0f, 1.0f), 0.0f);
    const glm::vec2 cut = numerics::windrow_blur_streak({0.3f, 0.4f}, {100.0f, 100.0f}, 1.0f, 10.0f);
    EXPECT_NEAR(cut.x, 6.0f, 1e-5f);
    EXPECT_NEAR(cut.y, 8.0f, 1e-5f);
}

} // namespace
} // namespace windrow::vegetation::render
