// The debug views' colours of speed are those of the slices that `windrow run` draws.
#include "cli/drawing/slice.h"
#include "tests/figure.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <gtest/gtest.h>

namespace windrow::cli {
namespace {

namespace shader {
using namespace glm;
#define WINDROW_FN inline
#include "vegetation/shaders/numerics/speed_colour.glsl"
#undef WINDROW_FN
} // namespace shader

double encoded(double linear) {
    return 255.0 * (linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055);
}

TEST(SpeedColour, TheShadersStopsAreTheSlices) {
    double at_stops = 0.0, between = 0.0;
    for (int n = 0; n <= 100; ++n) {
        const float share = static_cast<float>(n) / 100.0f;
        const glm::vec3 here = shader::windrow_speed_colour(share);
        const Rgb8 there = speed_colour(share);
        double off = 0.0;
        for (int channel = 0; channel < 3; ++channel)
            off = std::max(off, std::abs(encoded(static_cast<double>(here[channel])) - there[static_cast<std::size_t>(channel)]));
        double& worst = n % 20 == 0 ? at_stops : between;
        worst = std::max(worst, off);
    }
    WINDROW_EXPECT_FIGURE("unit/speed_colour/at_stops", at_stops, 3.0); // of 255: three digits of linear light
    WINDROW_EXPECT_FIGURE("unit/speed_colour/between", between, 25.0);  // lines in linear light, not in OKLab
}

} // namespace
} // namespace windrow::cli
