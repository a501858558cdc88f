// The air of a scene on both backends: the same wind at the same places, and the same picture. Their steps are held to each other
// by tests/parity; here it is how a frame places what moves, and what shaders sample.
#include "scene/scene_air.h"
#include "vegetation/program/air.h"
#include "vegetation/program/picture_reader.h"
#include "vegetation/tests/images/drawn.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <string>

namespace windrow::vegetation::program {
namespace {

constexpr int k_frames = 6;
constexpr int k_places = 100;

/// A scene with as many solves of the pressure on both backends: by default the CPU alone takes another where one leaves much.
Result<PictureScene> evenly_solved(const std::string& name) {
    auto scene = read_picture_scene(std::filesystem::path(WINDROW_SOURCE_DIR) / "examples/scenes" / (name + ".json"));
    if (scene)
        scene->air.air.pressure_solves = 2;
    return scene;
}

/// Winds at places of the box, of each frame.
std::vector<std::vector<glm::vec3>> winds_of(const PictureScene& scene, Backend backend) {
    const auto device = engine::must(engine::Device::create());
    const auto frames = engine::must(engine::Frames::create(*device));
    Config config = scene.air.air;
    config.ticks = {.hz = scene.air.tick_hz, .max_per_call = 10};
    Air air = engine::must(Air::create(*device, config, {.backend = backend, .queries = true}));
    scene::SceneAir moved(scene.air);
    engine::must(moved.begin(air.control()));
    // What a device has done is read when the slot's turn comes again.
    const int late = backend == Backend::vulkan ? engine::k_frames_in_flight : 0;
    std::vector<std::vector<glm::vec3>> winds;
    std::vector<std::vector<glm::dvec3>> places;
    for (int n = 0; n < k_frames + late; ++n) {
        engine::must(moved.advance_to(air.control(), (n + 1) / 24.0));
        const auto frame = engine::must(frames->begin());
        engine::must(air.record(frame, 1.0 / 24.0));
        engine::must(frames->finish(frame));
        places.emplace_back();
        for (int i = 0; i < k_places; ++i)
            places.back().push_back(air.control().origin() + glm::dvec3(air.control().box().size()) *
                                                                 (glm::dvec3(i * 37 % k_places, i * 61 % k_places, i) / 100.0));
        if (n < late)
            continue;
        winds.emplace_back(k_places);
        air.reader().velocity(places[static_cast<std::size_t>(n - late)], winds.back());
    }
    return winds;
}

class AirBackends : public testing::TestWithParam<const char*> {};

TEST_P(AirBackends, BlowTheSameWind) {
    const auto scene = evenly_solved(GetParam());
    ASSERT_TRUE(scene) << scene.error();
    const auto cpu = winds_of(*scene, Backend::cpu), device = winds_of(*scene, Backend::vulkan);
    float fastest = 0.0f, apart = 0.0f, changed = 0.0f;
    for (std::size_t n = 0; n < k_frames; ++n)
        for (std::size_t i = 0; i < k_places; ++i) {
            fastest = std::max(fastest, glm::length(cpu[n][i]));
            apart = std::max(apart, glm::length(cpu[n][i] - device[n][i]));
            changed = std::max(changed, glm::length(cpu[n][i] - cpu[0][i]));
        }
    std::printf("%s: %.2g of %.3g m/s, which change by %.2g\n", GetParam(), apart, fastest, changed);
    EXPECT_LE(apart, 1e-5f * fastest) << "as tests/parity asks";
    EXPECT_GE(changed, 1e-3f * fastest) << "a steady wind is the same in all frames, whichever is compared";
}

// Profile, gusts and hills; bodies that move; a box that follows; gusts with detail.
INSTANTIATE_TEST_SUITE_P(Scenes, AirBackends, testing::Values("meadow", "train", "wolf", "wake"),
                         [](const auto& scene) { return std::string(scene.param); });

// looks/low has neither gusts nor motors: what moves its blades is the detail alone.
TEST(Detail, MovesALawnInASteadyWind) {
    auto scene = read_picture_scene(std::filesystem::path(WINDROW_SOURCE_DIR) / "examples/scenes/looks/low.json");
    ASSERT_TRUE(scene) << scene.error();
    const SceneRendererSettings settings{.size = glm::ivec2(64, 36), .frames_per_second = 10.0, .warm_up = 0.0};
    scene->air.duration = 0.3;
    const auto before = test::last_picture(*scene, settings);
    scene->air.duration = 0.6;
    const auto after = test::last_picture(*scene, settings);
    ASSERT_TRUE(before && after);
    EXPECT_GT(test::apart(*before, *after).mean, 0.02) << "more than the references may be off by; without a pattern it is 0";
}

class PictureBackends : public testing::TestWithParam<const char*> {};

// Blurred along the motion vectors, for which shaders sample the textures of the frame before. Where one backend rounds to a half
// and the other truncates, each component is off by up to 2^-10, either way. So the difference may be that of a wind stronger by
// twice that, and the bound of all references. With the textures of this frame as those of the one before, gusts_fan is off by 3.3.
TEST_P(PictureBackends, DrawTheSame) {
    auto scene = test::read_scene(GetParam());
    ASSERT_TRUE(scene) << scene.error();
    scene->air.air.pressure_solves = 2;
    SceneRendererSettings settings{.size = glm::ivec2(128, 72), .shutter_deg = 180.0f, .backend = Backend::vulkan};
    const auto device = test::last_picture(*scene, settings);
    settings.backend = Backend::cpu;
    const auto cpu = test::last_picture(*scene, settings);
    scene->picture.sampling.strength *= 1.0f + 0x1p-9f;
    const auto stronger = test::last_picture(*scene, settings);
    ASSERT_TRUE(device) << device.error();
    ASSERT_TRUE(cpu && stronger);
    const double apart = test::apart(*cpu, *device).mean, bound = test::apart(*cpu, *stronger).mean + 0.02;
    std::printf("%s: mean %.4f, bound %.4f\n", GetParam(), apart, bound);
    EXPECT_LE(apart, bound);
}

INSTANTIATE_TEST_SUITE_P(Scenes, PictureBackends, testing::Values("gusts_fan", "grove", "fur_ball"),
                         [](const auto& scene) { return std::string(scene.param); });

} // namespace
} // namespace windrow::vegetation::program
