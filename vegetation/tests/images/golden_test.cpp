// Small scenes as pictures, held to references that were looked at: vegetation/tests/images/golden/NAME.png.
//
//     WINDROW_ACCEPT_IMAGES=1 build/release/windrow_images_tests --gtest_filter='*Golden*'    writes the references again
//
// To add a scene: a file in vegetation/tests/images/scenes and a line in k_scenes. Look at a picture before you accept it.
#include "tests/figure.h"
#include "vegetation/tests/images/drawn.h"

#include <cstdlib>

namespace windrow::vegetation::program {
namespace {

struct GoldenScene {
    const char* name;
    Show show;
};

constexpr GoldenScene k_scenes[] = {
    {"steady_trail", Show::plants}, {"gusts_fan", Show::plants}, {"wind_slice", Show::slice},    {"far_hills", Show::plants},
    {"grove", Show::plants},        {"fur_ball", Show::plants},  {"shell_strips", Show::plants},
};

// One machine draws the same bytes each time (repeat_test.cpp). Measured with lavapipe of Mesa 22.3.6: 1 or 4 threads
// (LP_NUM_THREADS), and vectors of 128 or 256 bits (LP_NATIVE_VECTOR_WIDTH), 0; instructions of a processor without AVX and FMA
// (GALLIUM_OVERRIDE_CPU_CAPS=sse2), a mean of 4.3e-4 and 9 at most in one channel. Other compilers shift blades by rounding as
// well, hence fifty times that. A sun turned by 3 degrees is a mean of 0.037 (the slice, whose ground alone is lit) to 1.6, a
// wind turned by 10 degrees 1.8 to 10.
constexpr double k_golden_mean = 0.02;  // [8-bit steps]
constexpr double k_golden_far = 0.0005; // ten pixels

class Golden : public testing::TestWithParam<GoldenScene> {};

TEST_P(Golden, IsWhatWasAccepted) {
    const std::string name = GetParam().name;
    const auto scene = test::read_scene(name);
    ASSERT_TRUE(scene) << scene.error();
    const auto drawn = test::last_picture(*scene, {.show = GetParam().show});
    ASSERT_TRUE(drawn) << drawn.error();
    const std::filesystem::path golden =
        std::filesystem::path(WINDROW_SOURCE_DIR) / "vegetation/tests/images/golden" / (name + ".png");
    if (std::getenv("WINDROW_ACCEPT_IMAGES") != nullptr) {
        const auto written = pictures::write_png(*drawn, golden);
        ASSERT_TRUE(written) << written.error();
        std::printf("accepted: %s\n", golden.c_str());
        return;
    }
    const std::filesystem::path here = test::left_behind(name);
    ASSERT_TRUE(pictures::write_png(*drawn, here));
    const std::string how = "\ndrawn: " + here.string() +
                            "\naccept it: WINDROW_ACCEPT_IMAGES=1 windrow_images_tests --gtest_filter='*Golden*" + name + "*'";
    const auto wanted = pictures::read_png(golden);
    ASSERT_TRUE(wanted) << wanted.error() << how;
    ASSERT_TRUE(wanted->width == drawn->width && wanted->height == drawn->height)
        << golden << " is " << wanted->width << " x " << wanted->height << " px, the scene " << drawn->width << " x "
        << drawn->height << how;
    const test::Apart off = test::apart(*drawn, *wanted);
    WINDROW_EXPECT_FIGURE("images/golden/" + name + "/mean", off.mean, k_golden_mean);
    WINDROW_EXPECT_FIGURE("images/golden/" + name + "/far_fraction", off.far, k_golden_far);
    windrow::test::figure("images/golden/" + name + "/most", off.max);
    const std::filesystem::path file = test::left_behind(name, "difference");
    std::filesystem::remove(file);
    if (HasFailure()) {
        ASSERT_TRUE(pictures::write_png(test::difference(*drawn, *wanted), file));
        ADD_FAILURE() << name << " is not " << golden.string() << how << "\ndifference, times 8: " << file.string();
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Golden, testing::ValuesIn(k_scenes),
                         [](const auto& scene) { return std::string(scene.param.name); });

} // namespace
} // namespace windrow::vegetation::program
