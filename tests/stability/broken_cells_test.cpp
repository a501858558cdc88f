// NaN, infinity, speeds and steps that a float can just hold: harmless after one step.

#include "tests/stability/watch.h"

#include <cstddef>

namespace {

using namespace windrow;
using namespace windrow::test;

TEST(BrokenCells, DoNoMoreThanAmbientOnesWould) {
    Worst worst;
    for (const float bad : {k_nan, k_infinity, -k_infinity}) {
        Wind wind = made({.ambient = {2.0f, 0.0f, 0.0f}}), mended = made({.ambient = {2.0f, 0.0f, 0.0f}});
        Field field = smooth_noise({32, 16, 32}, 3.0f, 37);
        const double speed = largest_speed(field); // above the wind outside, which what is repaired gets
        for (const std::size_t cell : {std::size_t{0}, std::size_t{5000}, field.size() - 1})
            field[cell] = {bad, 1.0f, bad, 0.0f};
        ASSERT_TRUE(wind.set_velocity(field));
        for (const std::size_t cell : {std::size_t{0}, std::size_t{5000}, field.size() - 1})
            field[cell] = {2.0f, 0.0f, 0.0f, 0.0f};
        ASSERT_TRUE(mended.set_velocity(field));
        Watch watch(wind, speed);
        for (int n = 0; n < 10; ++n) {
            watch.step(0.05, n == 0 ? 3 : 0); // asks that so many are reported
            mended.step(0.05);
            ASSERT_EQ(cells_that_differ(wind.field(), mended.field()), 0u);
        }
        worst.meet(watch);
    }
    worst.judge("nonfinite_cells", {k_input_energy, k_opposed_factor});
}

// The guard meets them wherever they are: with gusts the wind is solved less a given part, in a thin box all is rim.
TEST(BrokenCells, InEveryStepOfEveryKindOfBox) {
    for (const glm::ivec3 cells : {glm::ivec3(12, 8, 10), glm::ivec3(12, 1, 10), glm::ivec3(1, 1, 1)})
        for (const Scheme scheme : {Scheme::second_order, Scheme::stable_fluids}) {
            Worst worst;
            for (const BoundaryKind kind : k_kinds)
                for (const float gusts : {0.0f, 0.4f}) {
                    Wind wind = made({.cells = cells,
                                      .boundaries = Boundaries::all(kind),
                                      .ambient = {6.0f, 0.0f, 2.0f},
                                      .gusts = {.intensity = gusts},
                                      .scheme = scheme});
                    drive(wind, glm::dvec3(0.0), {1.0f, 1.0f, 0.0f}, 20.0f);
                    // Gusts are given, and count twice (input.h).
                    const AmbientWind around = wind.view().ambient();
                    const double gust = around.gusting() ? double(around.gust_strength() * around.tile()->bound()) : 0.0;
                    Watch watch(wind, 20.0 + 2.0 * gust);
                    Random random(39);
                    for (int n = 0; n < shortened(200); ++n) {
                        Field field = copy(wind.field());
                        field[static_cast<std::size_t>(random.integer(0, static_cast<int>(field.size()) - 1))]
                             [random.integer(0, 2)] = n % 3 == 0   ? k_nan
                                                      : n % 3 == 1 ? k_infinity
                                                                   : -k_infinity;
                        ASSERT_TRUE(wind.set_velocity(field));
                        watch.step(n % 2 == 0 ? 0.05 : 0.5, 1);
                    }
                    worst.meet(watch);
                }
            worst.judge("broken_in_every_step_" + std::to_string(cells.x) + 'x' + std::to_string(cells.y) + 'x' +
                            std::to_string(cells.z) + (scheme == Scheme::stable_fluids ? "_stable_fluids" : ""),
                        {k_input_energy, k_opposed_factor});
        }
}

TEST(BrokenCells, HugeFiniteSpeedsStayFinite) {
    for (const float huge : {1e6f, 1e12f, 1e18f, 1e20f, 1e30f, 3e38f})
        for (const double dt : {1e-6, 1.0 / 60.0, 1.0}) {
            Wind wind = made({.cells = {12, 8, 10}});
            Field field = white_noise({12, 8, 10}, 1.0f, 38);
            for (glm::vec4& u : field)
                u *= huge;
            ASSERT_TRUE(wind.set_velocity(field));
            bool finite = true;
            for (int n = 0; n < 5; ++n) {
                wind.step(dt);
                finite = finite && all_finite(wind.field());
            }
            EXPECT_TRUE(finite) << huge << " m/s, dt " << dt;
            float largest = 0.0f; // of the components: squares would overflow
            for (const glm::vec4& u : wind.field())
                largest = std::max({largest, std::abs(u.x), std::abs(u.y), std::abs(u.z)});
            EXPECT_LE(double(largest), k_speed_factor * std::sqrt(3.0) * double(huge)) << "dt " << dt;
        }
}

TEST(BrokenCells, StepsOfAnyFiniteLengthStayFinite) {
    for (const double dt : {1e-37, 1e-20, 1e-9, 1e3, 1e6, 1e12, 1e20, 1e30, 1e38}) {
        Wind wind = made({.cells = {12, 8, 10}, .ambient = {3.0f, 0.0f, 1.0f}, .viscosity = 1e-3f});
        ASSERT_TRUE(wind.motors().add(DirectionalMotor{.law = Drive{20.0f, 1e6f}}));
        ASSERT_TRUE(wind.motors().add(DirectionalMotor{.position = {2.0, 0.0, 0.0}, .law = Force{10.0f}}));
        const MotorId body = added(wind, WakeMotor{});
        bool finite = true;
        for (int n = 0; n < 5; ++n) {
            ASSERT_TRUE(wind.motors().move(body, {0.3 * n, 0.0, 0.0}));
            wind.step(dt);
            finite = finite && all_finite(wind.field());
        }
        EXPECT_TRUE(finite) << "dt " << dt;
    }
}

} // namespace
