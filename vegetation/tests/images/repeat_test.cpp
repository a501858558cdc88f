// One scene file, one picture: drawn twice, to the byte. So is one that a film goes on with, after frames without a picture: a
// stopped run of windrow-draw --resume leaves the film of an unbroken one.
#include "vegetation/tests/images/drawn.h"

#include <gtest/gtest.h>
#include <string>

namespace windrow::vegetation::program {
namespace {

class Repeat : public testing::TestWithParam<const char*> {};

TEST_P(Repeat, IsTheSameToTheByte) {
    const auto scene = test::read_scene(GetParam());
    ASSERT_TRUE(scene) << scene.error();
    const SceneRendererSettings settings{.show = std::string(GetParam()) == "wind_slice" ? Show::slice : Show::plants};
    const auto first = test::last_picture(*scene, settings);
    const auto second = test::last_picture(*scene, settings);
    ASSERT_TRUE(first) << first.error();
    ASSERT_TRUE(second) << second.error();
    EXPECT_TRUE(first->values == second->values) << "most " << test::apart(*first, *second).max;
}

INSTANTIATE_TEST_SUITE_P(Scenes, Repeat, testing::Values("steady_trail", "gusts_fan", "wind_slice", "far_hills", "grove"),
                         [](const auto& scene) { return std::string(scene.param); });

class Resume : public testing::TestWithParam<const char*> {};

TEST_P(Resume, GivesTheFrameOfAnUnbrokenFilm) {
    auto scene = test::read_scene(GetParam());
    ASSERT_TRUE(scene) << scene.error();
    const SceneRendererSettings settings{
        .size = glm::ivec2(96, 54), .frames_per_second = 24.0, .warm_up = 0.0, .shutter_deg = 180.0f};
    scene->air.duration = 0.25;
    const auto all = test::last_picture(*scene, settings, 7);
    const auto resumed = test::last_picture(*scene, settings, 3);
    ASSERT_TRUE(all) << all.error();
    ASSERT_TRUE(resumed) << resumed.error();
    EXPECT_TRUE(all->values == resumed->values)
        << "most " << test::apart(*all, *resumed).max
        << ": what a drawable keeps from frame to frame must go on in SceneRenderer::swing";
}

INSTANTIATE_TEST_SUITE_P(Scenes, Resume, testing::Values("steady_trail", "grove", "fur_ball"),
                         [](const auto& scene) { return std::string(scene.param); });

} // namespace
} // namespace windrow::vegetation::program
