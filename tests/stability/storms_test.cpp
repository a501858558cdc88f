// W25: storms that no game should make. Whatever comes, every value stays finite and no speed passes what was put in: the
// largest of the start, the ambient wind, the walls' and the motors' targets, times a stated factor.

#include "fluid/wind.h"
#include "tests/fields.h"
#include "tests/figure.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <string>

namespace {

using namespace windrow;
using namespace windrow::test;

// Jets that meet squeeze air aside faster than either blew: up to 1.8 times was seen, of a chaotic flow.
constexpr double k_factor = 2.5;

Wind made(const Config& config) {
    auto wind = Wind::create(config);
    EXPECT_TRUE(wind) << wind.error();
    return *std::move(wind);
}

/// Largest speed of a run; infinite as soon as a cell is not finite after a step.
double largest_of(Wind& wind, int steps, const std::function<double(int step)>& before_step_gives_dt) {
    double largest = 0.0;
    for (int n = 0; n < steps; ++n) {
        wind.step(before_step_gives_dt(n));
        const double speed = largest_speed(wind.field());
        if (!std::isfinite(speed))
            return std::numeric_limits<double>::infinity();
        largest = std::max(largest, speed);
    }
    return largest;
}

void drive(Wind& wind, glm::dvec3 position, glm::vec3 direction, float speed, float radius = 2.0f, float rate = 1e6f) {
    ASSERT_TRUE(wind.motors().add(
        DirectionalMotor{.position = position, .direction = direction, .region = Sphere{radius}, .law = Drive{speed, rate}}));
}

constexpr SideKind k_kinds[] = {SideKind::open, SideKind::free_slip, SideKind::no_slip, SideKind::periodic};
constexpr const char* k_kind_names[] = {"open", "free_slip", "no_slip", "periodic"};

// --- CFL 100, steps of one second ------------------------------------------------------------------------------------

TEST(Storms, CflHundredWithAndWithoutViscosity) {
    for (const float viscosity : {0.0f, 1e4f})
        for (const bool raw : {false, true}) {
            const glm::ivec3 cells(20, 10, 16);
            Wind wind = made({.cells = cells,
                              .ambient = {100.0f, 0.0f, 0.0f},
                              .viscosity = viscosity,
                              .settling_time = 0.0f,
                              .max_cfl = raw ? 1e6f : 2.0f});
            Field start = white_noise(cells, 20.0f, 31);
            for (glm::vec4& u : start)
                u.x += 100.0f;
            ASSERT_TRUE(wind.set_velocity(start));
            const double speed = largest_speed(wind.field());
            const std::string name =
                std::string("storm_cfl_100_nu_") + (viscosity > 0.0f ? "1e4" : "0") + (raw ? "_raw" : "_limited");
            WINDROW_EXPECT_FIGURE(name, largest_of(wind, 2'000, [](int) { return 1.0; }) / speed, 1.1);
        }
}

TEST(Storms, OpposedMotors) {
    for (int kind = 0; kind < 4; ++kind)
        for (const bool raw : {false, true}) {
            Wind wind = made({.cells = {24, 12, 16}, .sides = Sides::all(k_kinds[kind]), .max_cfl = raw ? 1e6f : 2.0f});
            drive(wind, {-3.0, 0.0, 0.0}, {1.0f, 0.0f, 0.0f}, 50.0f);
            drive(wind, {3.0, 0.0, 0.0}, {-1.0f, 0.0f, 0.0f}, 50.0f);
            drive(wind, {0.0, 2.0, 0.0}, {0.0f, -1.0f, 0.2f}, 50.0f, 1.0f);
            const std::string name = std::string("storm_opposed_") + k_kind_names[kind] + (raw ? "_raw" : "");
            WINDROW_EXPECT_FIGURE(name, largest_of(wind, 2'000, [](int n) { return n % 100 < 50 ? 1.0 / 60.0 : 1.0; }) / 50.0,
                                  k_factor);
        }
}

TEST(Storms, AMotorOfAThousandMetresASecond) {
    for (int kind = 0; kind < 4; ++kind) {
        Wind wind = made({.cells = {24, 12, 16}, .sides = Sides::all(k_kinds[kind])});
        drive(wind, {0.3, 0.2, 0.1}, {1.0f, 0.1f, 0.0f}, 1000.0f, 1.0f);
        WINDROW_EXPECT_FIGURE(std::string("storm_1000_mps_") + k_kind_names[kind],
                              largest_of(wind, 1'000, [](int) { return 1.0 / 60.0; }) / 1000.0, 1.5);
    }
}

TEST(Storms, TheStrongestForceAndTheStrongestWake) {
    // A force has no target; in an open box its air leaves, and the speed limit holds the rest: 2 cells * 8 parts a step, plus
    // the push itself.
    Wind wind = made({.cells = {24, 12, 16}});
    ASSERT_TRUE(wind.motors().add(DirectionalMotor{.law = Force{1e6f}}));
    const double dt = 1.0 / 60.0, limit = 16.0 / dt + 1e6 * dt;
    WINDROW_EXPECT_FIGURE("storm_strongest_force", largest_of(wind, 1'000, [&](int) { return dt; }) / limit, 2.0);

    Wind dragged = made({.cells = {24, 12, 16}});
    const auto body = dragged.motors().add(WakeMotor{.radius = 3.0f, .law = WakeDrive{.per_metre = 1e4f, .entrainment = 2.0f}});
    ASSERT_TRUE(body);
    Random random(32);
    double fastest = 0.0;
    glm::dvec3 last(0.0);
    const double largest = largest_of(dragged, 1'000, [&](int) {
        const glm::dvec3 next = random.point(30.0);
        fastest = std::max(fastest, 2.0 * glm::length(next - last) / dt);
        last = next;
        EXPECT_TRUE(dragged.motors().move(*body, next));
        return dt;
    });
    WINDROW_EXPECT_FIGURE("storm_strongest_wake", largest / fastest, 1.1);
}

// --- Shapes and sides ------------------------------------------------------------------------------------------------

TEST(Storms, BoxesOneCellThick) {
    for (const glm::ivec3 cells :
         {glm::ivec3(1, 12, 16), glm::ivec3(16, 1, 12), glm::ivec3(12, 16, 1), glm::ivec3(1, 1, 24), glm::ivec3(24, 1, 1),
          glm::ivec3(1, 24, 1), glm::ivec3(1, 1, 1), glm::ivec3(2, 2, 2), glm::ivec3(3, 2, 1)}) {
        double worst = 0.0;
        for (int kind = 0; kind < 4; ++kind)
            for (const float viscosity : {0.0f, 1.0f, 1e3f}) {
                Wind wind = made(
                    {.cells = cells, .sides = Sides::all(k_kinds[kind]), .ambient = {3.0f, 1.0f, -2.0f}, .viscosity = viscosity});
                ASSERT_TRUE(wind.set_velocity(white_noise(cells, 5.0f, 33)));
                drive(wind, glm::dvec3(0.1), {1.0f, 1.0f, -1.0f}, 20.0f);
                worst = std::max(worst, largest_of(wind, 300, [](int n) { return n % 10 == 0 ? 1.0 : 0.02; }) / 20.0);
            }
        WINDROW_EXPECT_FIGURE("storm_thin_" + std::to_string(cells.x) + 'x' + std::to_string(cells.y) + 'x' +
                                  std::to_string(cells.z),
                              worst, k_factor);
    }
}

// In a box one cell thick the wind across it is a mere passenger of a flat flow, and a white start leaves cells where that flow
// converges for good. By default it settles; the raw step lets the passenger grow (largest |u| 5.5 of the start was seen).
TEST(Storms, WhiteNoiseInABoxOneCellThick) {
    for (const glm::ivec3 cells : {glm::ivec3(1, 32, 32), glm::ivec3(32, 1, 32), glm::ivec3(32, 32, 1)}) {
        const std::string size = std::to_string(cells.x) + 'x' + std::to_string(cells.y) + 'x' + std::to_string(cells.z);
        double by_default = 0.0, raw = 0.0;
        for (std::uint32_t seed = 1; seed <= 3; ++seed)
            for (const double dt : {0.1, 0.5, 2.0})
                for (const bool settles : {true, false}) {
                    Wind wind = made({.cells = cells,
                                      .sides = Sides::all(SideKind::periodic),
                                      .settling_time = settles ? 20.0f : 0.0f,
                                      .max_cfl = settles ? 2.0f : 1e6f});
                    ASSERT_TRUE(wind.set_velocity(projected(white_noise(cells, 1.0f, seed), wind.box())));
                    const double speed = largest_speed(wind.field());
                    double& largest = settles ? by_default : raw;
                    largest = std::max(largest, largest_of(wind, 1'000, [&](int) { return dt; }) / speed);
                }
        WINDROW_EXPECT_FIGURE("storm_thin_noise_" + size, by_default, 1.5);
        EXPECT_TRUE(std::isfinite(figure("storm_thin_noise_raw_" + size, raw)));
    }
}

Sides random_sides(Random& random, float wall_speed) {
    Sides sides;
    Side* const ordered[6] = {&sides.x_low, &sides.x_high, &sides.y_low, &sides.y_high, &sides.z_low, &sides.z_high};
    for (int axis = 0; axis < 3; ++axis) {
        const bool periodic = random.integer(0, 3) == 0;
        for (int end = 0; end < 2; ++end) {
            Side& side = *ordered[2 * axis + end];
            side.kind = periodic ? SideKind::periodic : static_cast<SideKind>(random.integer(0, 2));
            if (side.kind == SideKind::no_slip) {
                side.wall_velocity = random.vector(wall_speed);
                side.wall_velocity[axis] = 0.0f;
            }
        }
    }
    return sides;
}

TEST(Storms, SidesThatChangeWhileItBlows) {
    Wind wind = made({.cells = {20, 11, 16}, .ambient = {5.0f, 2.0f, -3.0f}, .viscosity = 0.5f});
    drive(wind, {2.0, 1.0, 0.0}, {1.0f, 0.0f, 0.5f}, 20.0f);
    Random random(34);
    const double largest = largest_of(wind, 3'000, [&](int n) {
        if (n % 5 == 0) {
            EXPECT_TRUE(wind.set_sides(random_sides(random, 10.0f)));
        }
        return random.spread(1e-3, 0.5);
    });
    WINDROW_EXPECT_FIGURE("storm_changing_sides", largest / 20.0, k_factor);
}

TEST(Storms, AShiftInEveryStep) {
    Wind wind = made({.cells = {20, 12, 16}, .ambient = {5.0f, 1.0f, -3.0f}});
    drive(wind, {0.0, 0.0, 0.0}, {-1.0f, 0.3f, 0.0f}, 30.0f, 4.0f);
    Random random(35);
    const double largest = largest_of(wind, 10'000, [&](int n) {
        EXPECT_TRUE(wind.follow(random.point(n % 2 == 0 ? 4.0 : 12.0)));
        return n % 3 == 0 ? 0.1 : 1.0 / 60.0;
    });
    WINDROW_EXPECT_FIGURE("storm_shift_every_step", largest / 30.0, k_factor);
}

// --- Viscosity and steps ---------------------------------------------------------------------------------------------

TEST(Storms, ViscosityFromNothingToTenThousand) {
    for (int kind = 0; kind < 4; ++kind)
        for (const double ratio : {0.0, 1e-4, 1e-3, 0.08, 0.0833, 0.084, 0.17, 0.24, 1.0, 100.0, 1e4}) {
            const double dt = 0.1;
            Wind wind = made({.cells = {16, 12, 20},
                              .sides = Sides::all(k_kinds[kind]),
                              .viscosity = static_cast<float>(ratio / dt),
                              .settling_time = 0.0f,
                              .max_cfl = 1e6f});
            ASSERT_TRUE(wind.set_velocity(projected(white_noise({16, 12, 20}, 10.0f, 36),
                                                    wind.box()))); // CFL 1: where a pass after the advection would blow up
            const double energy = energy_of(wind.field()), speed = largest_speed(wind.field());
            double largest_energy = 0.0;
            const double largest = largest_of(wind, 300, [&](int) {
                largest_energy = std::max(largest_energy, energy_of(wind.field()));
                return dt;
            });
            char name[64];
            std::snprintf(name, sizeof name, "storm_viscosity_%g_%s", ratio, k_kind_names[kind]);
            WINDROW_EXPECT_FIGURE(std::string(name) + "_speed", largest / speed, 1.1);
            WINDROW_EXPECT_FIGURE(std::string(name) + "_energy", largest_energy / energy, 1.001);
            if (ratio >= 0.08) { // a wave that a pass turns over instead of damping would stay
                WINDROW_EXPECT_FIGURE(std::string(name) + "_energy_at_end", energy_of(wind.field()) / energy, 1e-3);
            }
        }
}

TEST(Storms, AUniformWindBearsAnyViscosity) {
    // Nothing to diffuse, nothing to project: the stiffest solve must give it back, though ambient is still.
    for (const double ratio : {1.0, 100.0, 1e4, 1e6, 1e8}) {
        Wind wind = made({.cells = {16, 12, 20},
                          .sides = Sides::all(SideKind::periodic),
                          .viscosity = static_cast<float>(ratio),
                          .settling_time = 0.0f});
        wind.set_velocity([](glm::dvec3) { return glm::vec3(1.0f, -0.5f, 0.25f); });
        for (int n = 0; n < 100; ++n)
            wind.step(1.0);
        double worst = 0.0;
        for (const glm::vec4& u : wind.field())
            worst = std::max(worst, double(glm::length(glm::vec3(u) - glm::vec3(1.0f, -0.5f, 0.25f))));
        char name[64];
        std::snprintf(name, sizeof name, "uniform_wind_viscosity_%g_after_100_steps", ratio);
        WINDROW_EXPECT_FIGURE(name, worst, 1e-4);
    }
}

TEST(Storms, StepsThatAlternateByAThousand) {
    for (int kind = 0; kind < 4; ++kind) {
        Wind wind = made({.cells = {20, 12, 16}, .sides = Sides::all(k_kinds[kind]), .viscosity = 0.1f});
        drive(wind, {0.0, 0.0, 0.0}, {1.0f, 0.3f, 0.0f}, 10.0f);
        ASSERT_TRUE(wind.motors().add(
            DirectionalMotor{.position = {4.0, 0.0, 0.0}, .direction = {0.0f, 1.0f, 0.0f}, .law = Force{1.0f}}));
        WINDROW_EXPECT_FIGURE(std::string("storm_alternating_dt_") + k_kind_names[kind],
                              largest_of(wind, 2'000, [](int n) { return n % 2 == 0 ? 1e-3 : 1.0; }) / 10.0, k_factor);
    }
}

} // namespace
