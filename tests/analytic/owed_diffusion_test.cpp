// Viscosity acts in full however short the steps: what a step is too short for is owed to a later one.
//
// A wave of 8 cells in a still periodic box, nu = 0.01 m^2/s, h = 1 m, fades as exp(-nu k^2 t) with the grid's own k^2 = 4
// sin^2(pi/8). Steps at 30, 120 and 1000 Hz have r = 3.3e-4, 8.3e-5 and 1e-5; below 1e-4 a single one is less than what floats
// hold.
#include "fluid/wind.h"
#include "tests/figure.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace windrow {
namespace {

double height_after(double seconds, double hz) {
    const Config config{.cells = {1, 8, 1},
                        .sides = Sides::all(SideKind::periodic),
                        .viscosity = 0.01f,
                        .settling_time = 0.0f,
                        .stages = {.advection = false}};
    auto wind = Wind::create(config);
    EXPECT_TRUE(wind);
    const auto wave = [](double y) { return std::sin(2.0 * std::numbers::pi * y / 8.0); };
    wind->set_velocity([&](glm::dvec3 x) { return glm::vec3(wave(x.y), 0.0f, 0.0f); });
    for (int n = 0; n < static_cast<int>(std::lround(seconds * hz)); ++n)
        (void)wind->step(1.0 / hz);
    double sum = 0.0;
    for (int j = 0; j < 8; ++j)
        sum += wind->field()[j].x * wave(wind->origin().y + j + 0.5) / 4.0;
    return sum;
}

TEST(OwedDiffusion, AWaveFadesAlikeInShortAndInLongSteps) {
    const double half_sine = std::sin(std::numbers::pi / 8.0);
    const double exact = std::exp(-0.01 * 4.0 * half_sine * half_sine * 60.0);
    for (const double hz : {30.0, 120.0, 1000.0}) {
        const double error = std::abs(height_after(60.0, hz) / exact - 1.0);
        WINDROW_EXPECT_FIGURE("owed_diffusion." + std::to_string(static_cast<int>(hz)), error, 2e-3);
    }
}

} // namespace
} // namespace windrow
