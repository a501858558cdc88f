// One scene file, one picture: drawn twice, to the byte.
#include "vegetation/tests/images/drawn.h"

#include <gtest/gtest.h>
#include <string>

namespace windrow::vegetation::program {
namespace {

class Repeat : public testing::TestWithParam<const char*> {};

TEST_P(Repeat, IsTheSameToTheByte) {
    const auto scene = test::read_scene(GetParam());
    ASSERT_TRUE(scene) << scene.error();
    const ShootSettings settings{.show = std::string(GetParam()) == "wind_slice" ? Show::slice : Show::plants};
    const auto first = test::last_picture(*scene, settings);
    const auto second = test::last_picture(*scene, settings);
    ASSERT_TRUE(first) << first.error();
    ASSERT_TRUE(second) << second.error();
    EXPECT_EQ(first->values, second->values);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Repeat, testing::Values("steady_trail", "gusts_fan", "wind_slice", "far_hills", "grove"),
                         [](const auto& scene) { return std::string(scene.param); });

} // namespace
} // namespace windrow::vegetation::program
