// Hard cases stay finite: storms that no game should make. Every value stays finite and no speed passes what was put in: the
// largest of the start, the ambient wind, the walls' and the motors' targets, times a stated factor (input.h).

#include "tests/stability/watch.h"

#include <cstdint>

namespace {

using namespace windrow;
using namespace windrow::test;

// --- CFL 100, steps of one second ------------------------------------------------------------------------------------

TEST(Storms, CflHundredWithAndWithoutViscosity) {
    for (const float viscosity : {0.0f, 1e4f})
        for (const bool raw : {false, true}) {
            const glm::ivec3 cells(20, 10, 16);
            Wind wind = made({.cells = cells,
                              .ambient = {100.0f, 0.0f, 0.0f},
                              .viscosity = viscosity,
                              .relaxation_time = 0.0f,
                              .max_cfl = raw ? 1e6f : 2.0f});
            Field start = white_noise(cells, 20.0f, 31);
            for (glm::vec4& u : start)
                u.x += 100.0f;
            ASSERT_TRUE(wind.set_velocity(start));
            // Not the start's own energy: what leaves through the low side is replaced by wind from outside.
            Watch watch(wind, largest_speed(wind.field()));
            watch.run(2'000, 1.0);
            watch.judge(std::string("cfl_100_nu_") + (viscosity > 0.0f ? "1e4" : "0") + (raw ? "_raw" : "_limited"),
                        {k_input_energy, 1.1});
        }
}

TEST(Storms, TheStrongestForceAndTheStrongestWake) {
    // A force has no target; in an open box its air leaves, and the speed limit holds the rest: 2 cells * 8 parts a step, plus
    // the push itself.
    const double dt = 1.0 / 60.0;
    Wind wind = made({.cells = {24, 12, 16}});
    added(wind, DirectionalMotor{.law = Force{1e6f}});
    Watch pushed(wind, 16.0 / dt + 1e6 * dt);
    pushed.run(1'000, dt);
    pushed.judge("strongest_force", {k_input_energy, 2.0});

    Wind dragged = made({.cells = {24, 12, 16}, .jump_speed = 0.0f});
    const MotorId body = added(dragged, WakeMotor{.radius = 3.0f, .law = WakeDrive{.per_metre = 1e4f, .entrainment = 2.0f}});
    Random random(32);
    std::vector<glm::dvec3> path{{0.0, 0.0, 0.0}};
    double fastest = 0.0;
    for (int n = 0; n < shortened(1'000); ++n) {
        path.push_back(random.point(30.0));
        fastest = std::max(fastest, 2.0 * glm::length(path[n + 1] - path[n]) / dt);
    }
    Watch watch(dragged, fastest);
    for (std::size_t n = 1; n < path.size(); ++n) {
        EXPECT_TRUE(dragged.motors().move(body, path[n]));
        watch.step(dt);
    }
    watch.judge("strongest_wake", {k_input_energy, 1.1});
}

// --- All at once -----------------------------------------------------------------------------------------------------

// CFL 100 and more, steps of a second among short ones, motors of 1000 m/s against each other, a cell without a number now and
// then, a shift in every step, walls that come and go.
void expect_bounded_with_all_at_once(const std::string& name, glm::ivec3 cells, float viscosity) {
    Wind wind = made({.cells = cells,
                      .ambient = {5.0f, 1.0f, -3.0f},
                      .gusts = {.intensity = 0.3f},
                      .viscosity = viscosity,
                      .jump_speed = 0.0f});
    const float speed = 1000.0f;
    drive(wind, {-3.0, 0.0, 0.0}, {1.0f, 0.0f, 0.0f}, speed);
    drive(wind, {3.0, 0.0, 0.0}, {-1.0f, 0.0f, 0.0f}, speed);
    const MotorId body = added(wind, WakeMotor{.radius = 2.0f, .law = WakeDrive{.per_metre = 1.0f}});
    Watch watch(wind, double(speed)); // the wind outside and the walls are slower, and so is the body
    Random random(36);
    const float bad[] = {k_nan, k_infinity, -k_infinity};
    for (int n = 0; n < shortened(10'000); ++n) {
        ASSERT_TRUE(wind.follow(random.point(n % 200 == 0 ? 1e6 : 3.0)));
        ASSERT_TRUE(wind.motors().move(body, random.point(1.0)));
        if (n % 50 == 0) {
            Boundaries boundaries;
            boundaries.y_low.kind = boundaries.x_high.kind = k_kinds[(n / 50) % 3];
            boundaries.z_low.kind = boundaries.z_high.kind = k_kinds[(n / 150) % 4];
            ASSERT_TRUE(wind.set_boundaries(boundaries));
        }
        const bool broken = n % 20 == 7;
        if (broken) {
            Field field = copy(wind.field());
            const auto cell = static_cast<std::size_t>(random.integer(0, static_cast<int>(field.size()) - 1));
            field[cell][random.integer(0, 2)] = bad[random.integer(0, 2)];
            ASSERT_TRUE(wind.set_velocity(field));
        }
        watch.step(n % 4 == 3 ? 1.0 : 1.0 / 60.0, broken ? 1 : 0);
    }
    EXPECT_GT(watch.capped_steps(), 0);
    watch.judge(name, {k_input_energy, k_opposed_factor});
}

TEST(Storms, TenThousandStepsOfAllAtOnce) {
    expect_bounded_with_all_at_once("all_at_once", {16, 8, 12}, 0.0f);
    expect_bounded_with_all_at_once("all_at_once_nu_1e4", {16, 8, 12}, 1e4f);
}

TEST(Storms, TenThousandStepsOfAllAtOnceOneCellThick) {
    expect_bounded_with_all_at_once("all_at_once_16x1x12", {16, 1, 12}, 0.0f);
    expect_bounded_with_all_at_once("all_at_once_1x8x1", {1, 8, 1}, 0.0f);
}

} // namespace
