// Air that has settled and on which nothing acts sleeps: a step costs microseconds, and waking is, to the bit, what a fresh
// solver does.

#include "fluid/thread_pool.h"
#include "tests/winds.h"

#include <chrono>

namespace {

using namespace windrow;
using namespace windrow::test;

/// Stirs the air for half a second, then lets it settle; returns the steps until it sleeps.
int stir_until_asleep(Wind& wind, int most = 20'000) {
    const MotorId fan = added(wind, DirectionalMotor{.position = wind.config().centre, .law = Drive{6.0f, 8.0f}});
    for (int n = 0; n < 30; ++n)
        EXPECT_FALSE(wind.step(1.0 / 60.0).asleep);
    EXPECT_TRUE(wind.motors().remove(fan));
    for (int n = 1; n <= most; ++n)
        if (wind.step(1.0 / 60.0).asleep)
            return n;
    ADD_FAILURE() << "never slept";
    return most;
}

std::vector<NamedConfig> places() {
    const Config small{.cells = {16, 8, 16}, .relaxation_time = 2.0f}, windy = with(small, [](Config&c) {
                                                                           c.ambient = {3.0f, 0.0f, 1.0f};
                                                                       });
    const Config floor = with(small, [](Config& c) {
        c.boundaries = Boundaries::open_over_floor();
        c.ambient = {4.0f, 0.0f, 0.0f};
    });
    const Config profile = with(floor, [](Config& c) { c.profile = LogProfile{}; });
    return {{"still_air", {.relaxation_time = 2.0f}},
            {"mean_wind", windy},
            {"over_floor", with(floor, [](Config& c) { c.ambient.x = 2.0f; })},
            {"profile", profile},
            {"gusts", with(windy, [](Config& c) { c.gusts.intensity = 0.3f; })},
            {"gusts_over_a_profile", with(profile, [](Config& c) { c.gusts.intensity = 0.2f; })},
            {"stable_fluids", {.cells = {16, 8, 16}, .relaxation_time = 1.0f, .scheme = Scheme::stable_fluids}}};
}

TEST(Sleep, TheStepThatFallsAsleepReportsTheAirThatIsLeft) {
    for (const auto& [name, config] : places()) {
        Wind wind = made(config);
        const MotorId fan = added(wind, DirectionalMotor{.law = Drive{6.0f, 8.0f}});
        wind.step(0.1);
        ASSERT_TRUE(wind.motors().remove(fan));
        Diagnostics falls;
        for (int n = 0; n < 20'000 && !falls.asleep; ++n)
            falls = wind.step(1.0 / 60.0);
        ASSERT_TRUE(falls.asleep) << name;
        const Diagnostics sleeps = wind.step(1.0 / 60.0);
        EXPECT_EQ(falls.max_speed, sleeps.max_speed) << name;
        EXPECT_EQ(falls.energy, sleeps.energy) << name;
        EXPECT_EQ(falls.divergence_rms, sleeps.divergence_rms) << name;
        EXPECT_GT(falls.substeps, 0) << name; // it was a step all the same
    }
}

TEST(Sleep, WakingEqualsAFreshSolverToTheBit) {
    for (const auto& [name, config] : places()) {
        Wind slept = made(config);
        const int steps = 30 + stir_until_asleep(slept);
        for (int n = 0; n < 100; ++n)
            ASSERT_TRUE(slept.step(1.0 / 60.0).asleep) << name;
        Wind fresh = made(config);
        for (int n = 0; n < steps + 100; ++n) // the gusts of the same moment
            ASSERT_EQ(fresh.step(1.0 / 60.0).asleep, n >= 4 || fresh.view().ambient().uniform()) << name;
        EXPECT_EQ(cells_that_differ(slept.field(), fresh.field()), 0u) << name;
        std::size_t differing = 0;
        for (Wind* wind : {&slept, &fresh})
            ASSERT_TRUE(wind->motors().add(VortexMotor{.position = {1.0, 0.0, -0.5}}));
        for (int n = 0; n < 60; ++n) {
            ASSERT_FALSE(slept.step(1.0 / 60.0).asleep);
            fresh.step(1.0 / 60.0);
            differing += cells_that_differ(slept.field(), fresh.field());
        }
        WINDROW_EXPECT_FIGURE("sleep_cells_that_differ_on_waking_" + name, double(differing), 0.0);
    }
}

TEST(Sleep, FollowsAndIsSampledInItsSleep) {
    for (const auto& [name, config] : places()) {
        Wind wind = made(config);
        stir_until_asleep(wind);
        for (int n = 1; n < 50; ++n) {
            ASSERT_TRUE(wind.follow({1.3 * n, 0.7 * n, -2.1 * n}));
            ASSERT_TRUE(wind.step(1.0 / 60.0).asleep) << name;
        }
        Config there = config;
        there.centre = {1.3 * 49, config.boundaries.y_low.solid() ? 0.0 : 0.7 * 49, -2.1 * 49};
        EXPECT_EQ(wind.origin(), made(there).origin()) << name;
        if (!wind.view().ambient().gusting()) {
            EXPECT_EQ(cells_that_differ(wind.field(), made(there).field()), 0u) << name;
        }
        EXPECT_LT(off_ambient(wind), 1e-5) << name;
    }
}

TEST(Sleep, WhatActsWakesIt) {
    const Config config{.cells = {16, 8, 16}, .ambient = {1.0f, 0.0f, 0.0f}, .relaxation_time = 1.0f};
    const auto asleep = [&](const Config& each) {
        Wind wind = made(each);
        stir_until_asleep(wind);
        return wind;
    };
    Wind moved = asleep(config);
    const MotorId body = added(moved, WakeMotor{});
    EXPECT_TRUE(moved.step(0.02).asleep) << "a body that stands does nothing";
    ASSERT_TRUE(moved.motors().move(body, {1.0, 0.0, 0.0}));
    EXPECT_FALSE(moved.step(0.02).asleep);

    Wind gusty = asleep(config);
    ASSERT_TRUE(gusty.set_gusts({.intensity = 0.2f}));
    EXPECT_GT(gusty.step(0.02).substeps, 0) << "a step that looks whether anything is left to do";
    EXPECT_LT(off_ambient(gusty), 1e-5);

    Wind set = asleep(config);
    set.set_velocity([](glm::dvec3) { return glm::vec3(0.0f, 1.0f, 0.0f); });
    EXPECT_FALSE(set.step(0.02).asleep);

    Wind new_wind = asleep(config);
    ASSERT_TRUE(new_wind.set_ambient({2.0f, 0.0f, 0.0f}));
    EXPECT_EQ(largest_off(new_wind.field(), {2.0f, 0.0f, 0.0f}), 0.0);
    EXPECT_EQ(new_wind.step(0.02).max_speed, 2.0f);

    Wind blast = asleep(config);
    ASSERT_TRUE(blast.motors().add(PressureMotor{}));
    EXPECT_FALSE(blast.step(0.02).asleep);
}

TEST(Sleep, StaysAwakeWhereItMust) {
    for (const auto& [name, config] : {NamedConfig{"never_settles", {.cells = {16, 8, 16}, .relaxation_time = 0.0f}},
                                       {"switched_off", {.cells = {16, 8, 16}, .sleep_speed = 0.0f}},
                                       {"viscous", {.cells = {16, 8, 16}, .viscosity = 1.0f}}}) {
        Wind wind = made(config);
        for (int n = 0; n < 50; ++n)
            EXPECT_FALSE(wind.step(1.0 / 60.0).asleep) << name;
    }
    // Slow air is not settled air while it is faster than the bound.
    Wind slow = made({.cells = {16, 8, 16}});
    slow.set_velocity([](glm::dvec3 p) { return glm::vec3(0.0f, 0.0f, 0.01f * float(std::sin(p.x))); });
    EXPECT_FALSE(slow.step(1.0 / 60.0).asleep);
}

// In gusts the air sleeps too: they are a known pattern. Frames between ticks show them at their own moment, and the step that
// wakes begins with them as they are.
TEST(Sleep, GustsBlowOnThroughFramesOfAirThatSleeps) {
    const Config config{.ambient = {5.0f, 0.0f, 2.0f}, .gusts = {.intensity = 0.3f}};
    Wind sleeps = made(config), wakes = made(config),
         never = made({.ambient = config.ambient, .gusts = config.gusts, .sleep_speed = 0.0f});
    double frames_apart = 0.0, awake_apart = 0.0;
    for (int n = 0; n < 200; ++n) {
        const double dt = n % 5 == 0 ? 0.041 : 0.007;
        for (Wind* wind : {&sleeps, &wakes, &never}) {
            ASSERT_TRUE(wind->follow({0.1 * n, 0.0, 0.05 * n}));
            wind->advance(dt);
        }
        if (n % 40 == 20) { // a body's step, far from where it is looked at
            const MotorId wake = added(wakes, WakeMotor{.position = {0.1 * n - 12.0, 0.0, -12.0}, .radius = 0.3f});
            ASSERT_TRUE(wakes.motors().move(wake, {0.1 * n - 12.0, 0.001, -12.0}));
            wakes.advance(0.0);
        }
        if (n % 3 != 0) // who does not look pays nothing
            continue;
        const glm::dvec3 place(0.1 * n + 3.3, -1.2, 0.05 * n + 2.1);
        frames_apart = std::max(frames_apart, double(glm::length(sleeps.velocity(place) - never.velocity(place))));
        awake_apart = std::max(awake_apart, double(glm::length(wakes.velocity(place) - never.velocity(place))));
        if (n > 20) { // it slept at both ticks around the frame
            EXPECT_LT(off_ambient(sleeps), 1e-5);
        }
    }
    // Of a frame between two ticks, 1/30 s apart: straight between them, or where the pattern is.
    WINDROW_EXPECT_FIGURE("sleep_frames_in_gusts_off_those_awake_m_per_s", frames_apart, 0.02);
    WINDROW_EXPECT_FIGURE("sleep_frames_of_a_wind_that_wakes_and_sleeps_m_per_s", awake_apart, 0.02);
}

TEST(Sleep, NothingThatIsSeenJumpsAsItFallsAsleep) {
    Wind wind = made({.relaxation_time = 2.0f});
    const MotorId fan = added(wind, DirectionalMotor{});
    take_steps(wind, 30, 1.0 / 60.0);
    ASSERT_TRUE(wind.motors().remove(fan));
    Field before;
    do
        before = copy(wind.field());
    while (!wind.step(1.0 / 60.0).asleep);
    WINDROW_EXPECT_FIGURE("sleep_jump_m_per_s", largest_apart(wind.field(), before), 2e-3);
}

/// Not a timing test: the work that a sleeping step does is counted by what it may not touch, the field. The ratio is stated.
TEST(Sleep, CostsNextToNothing) {
    Wind wind = made({.relaxation_time = 2.0f});
    stir_until_asleep(wind);
    double asleep = 1e9, awake = 1e9;
    for (int n = 0; n < 200; ++n) {
        const auto start = std::chrono::steady_clock::now();
        wind.step(1.0 / 60.0);
        asleep = std::min(asleep, std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count());
    }
    Wind busy = made({.sleep_speed = 0.0f});
    for (int n = 0; n < 50; ++n)
        awake = std::min(awake, 1e3 * busy.step(1.0 / 60.0).times_ms.total);
    figure("sleep_step_us", asleep);
    figure("sleep_awake_step_us", awake);
    figure("sleep_awake_over_asleep", awake / asleep);
}

} // namespace
