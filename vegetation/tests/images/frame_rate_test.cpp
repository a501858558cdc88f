// The same second at 30 and at 144 frames ends in the same picture: motors, wakes, gusts, trails, clouds and the box that
// follows.
//
// Air, clouds and cameras do to the byte: the air runs ticks of its own, the others are functions of the time. Blades that a
// walker touches do not: a contact lasts to the end of the frame in which he left, 33 ms or 7 ms, and the spring that lets a
// blade up begins there. That is of first order in a frame's length, and over before he is a step further. Nor do trees that
// swing: their springs are exact for a bend that goes in a line from frame to frame, and the wind's goes with the square of its
// speed. Nor does grass, likewise: at 6 frames a second that shows. Without springs both end alike.
#include "tests/figure.h"
#include "vegetation/tests/images/drawn.h"

namespace windrow::vegetation::program {
namespace {

// Twice what was measured (0.121, 0.0015), in the scene whose middle is the walker: the blades under him cover a hundredth of it.
constexpr double k_touched_mean = 0.25, k_touched_far = 0.003;
// The same for trees that swing (0.200, 0.0027): twigs of a crown that fills a sixth of the picture, some hundredths of a radian.
constexpr double k_swinging_mean = 0.4, k_swinging_far = 0.0055;
// As for one scene on two machines: golden_test.cpp.
constexpr double k_mean = 0.02, k_far = 0.0005;

class FrameRate : public testing::TestWithParam<const char*> {};
class FrameRateUntouched : public testing::TestWithParam<const char*> {};

// Settled, then blown for the scene's second without pictures, then one picture.
test::Apart between_rates(const PictureScene& scene, const std::string& name, double slow_hz = 30.0) {
    const auto slow = test::last_picture(scene, {.frames_per_second = slow_hz}, 1);
    const auto fast = test::last_picture(scene, {.frames_per_second = 144.0}, 1);
    if (!slow || !fast) {
        ADD_FAILURE() << (slow ? fast.error() : slow.error());
        return {.mean = 255.0, .far = 1.0, .max = 255};
    }
    EXPECT_TRUE(pictures::write_png(*slow, test::left_behind(name, "30_hz")));
    EXPECT_TRUE(pictures::write_png(*fast, test::left_behind(name, "144_hz")));
    EXPECT_TRUE(pictures::write_png(test::difference(*slow, *fast), test::left_behind(name, "rates")));
    const test::Apart off = test::apart(*slow, *fast);
    windrow::test::figure("images/frame_rate/" + name + "/most", off.max);
    return off;
}

void make_stiff(PictureScene& scene) {
    for (StandSource& stand : scene.picture.trees)
        stand.springs = false;
    for (GrassSource& layer : scene.picture.grass)
        layer.drawn.springs = false;
}

TEST_P(FrameRate, EndsInTheSamePicture) {
    const std::string name = GetParam();
    const auto scene = test::read_scene(name);
    ASSERT_TRUE(scene) << scene.error();
    const bool touched = !scene->picture.walkers.empty(), swings = !scene->picture.trees.empty();
    const double max_mean = swings ? k_swinging_mean : touched ? k_touched_mean : k_mean;
    const double max_far = swings ? k_swinging_far : touched ? k_touched_far : k_far;
    const test::Apart off = between_rates(*scene, name);
    WINDROW_EXPECT_FIGURE("images/frame_rate/" + name + "/mean", off.mean, max_mean);
    WINDROW_EXPECT_FIGURE("images/frame_rate/" + name + "/far_fraction", off.far, max_far);
}

TEST_P(FrameRateUntouched, EndsInTheSamePicture) {
    const std::string name = GetParam();
    auto scene = test::read_scene(name);
    ASSERT_TRUE(scene) << scene.error();
    scene->picture.walkers.clear(); // their wakes stay
    make_stiff(*scene);
    const test::Apart off = between_rates(*scene, name + "_untouched");
    WINDROW_EXPECT_FIGURE("images/frame_rate/" + name + "_untouched/mean", off.mean, k_mean);
    WINDROW_EXPECT_FIGURE("images/frame_rate/" + name + "_untouched/far_fraction", off.far, k_far);
}

// More ticks a frame than windrow::Ticks runs unless told: no time may be lost.
TEST(FrameRateOfASlideShow, EndsInTheSamePicture) {
    auto scene = test::read_scene("gusts_fan");
    ASSERT_TRUE(scene) << scene.error();
    scene->picture.walkers.clear();
    make_stiff(*scene);
    const test::Apart off = between_rates(*scene, "slide_show", 6.0);
    WINDROW_EXPECT_FIGURE("images/frame_rate/slide_show/mean", off.mean, k_mean);
    WINDROW_EXPECT_FIGURE("images/frame_rate/slide_show/far_fraction", off.far, k_far);
}

std::string named(const testing::TestParamInfo<const char*>& scene) {
    return scene.param;
}

// One that swings, one that is touched; the others are long.
INSTANTIATE_TEST_SUITE_P(Scenes, FrameRate, testing::Values("gusts_fan", "grove"), named);
INSTANTIATE_TEST_SUITE_P(LongScenes, FrameRate, testing::Values("steady_trail", "far_hills"), named);
INSTANTIATE_TEST_SUITE_P(Scenes, FrameRateUntouched, testing::Values("steady_trail"), named);
INSTANTIATE_TEST_SUITE_P(LongScenes, FrameRateUntouched, testing::Values("gusts_fan", "grove"), named);

} // namespace
} // namespace windrow::vegetation::program
