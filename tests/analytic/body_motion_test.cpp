// What is motion and what is not: respawns, and turns that two poses do not show.
#include "tests/figure.h"
#include "tests/winds.h"

#include <cmath>
#include <numbers>

namespace {

using namespace windrow;
using namespace windrow::test;

// An obstacle and a wake are moved faster than Config::jump_speed: the air between the two places stays still. Slower, the obstacle
// pushes the air at the speed of the move.
TEST(BodiesThatMove, AJumpPushesNoAir) {
    for (const bool ticks : {false, true})
        for (const double way : {1.0, 3.0, 10.0, 1000.0}) {
            Wind wind = made({.cells = {48, 12, 12}});
            const ObstacleId body = *wind.obstacles().add({.position = {-15.0, 0.0, 0.0}, .shape = Sphere{2.0f}});
            const MotorId wake = *wind.motors().add(WakeMotor{.position = {-15.0, 3.0, 0.0}});
            constexpr double k_frame = 1.0 / 60.0;
            const auto go = [&] {
                if (ticks)
                    (void)wind.advance(k_frame);
                else
                    (void)wind.step(k_frame);
            };
            go();
            ASSERT_TRUE(wind.obstacles().move(body, {-15.0 + way, 0.0, 0.0}));
            ASSERT_TRUE(wind.motors().move(wake, {-15.0 + way, 3.0, 0.0}));
            int jumps = 0;
            float fastest = 0.0f;
            for (int n = 0; n < 4; ++n) {
                go();
                jumps = std::max(jumps, wind.diagnostics().jumps);
                fastest = std::max(fastest, wind.diagnostics().max_speed);
            }
            const bool jumped = way > 2.0;
            EXPECT_EQ(jumps > 0, jumped) << way;
            EXPECT_LT(fastest, jumped ? 1e-6f : 100.0f) << way;
            EXPECT_EQ(fastest > 1.0f, !jumped) << way;
        }
}

/// [N m] Mean about the axis on a blade that turns at so many revolutions a minute, by its spin or by its poses alone.
struct Turning {
    double rpm, frame; // [1/min], [s]
    bool with_spin = true, ticks = false;
    glm::vec2 blade{1.5f, 0.3f}; // [m] half its length and width
};
double moment_of(const Turning& turning, int* fast = nullptr) {
    Wind wind = made({.cells = {32, 32, 16}, .cell_size = 0.25f, .relaxation_time = 0.0f});
    const ObstacleId blade = *wind.obstacles().add({.shape = Block{{turning.blade.x, turning.blade.y, 0.4f}}});
    const double rate = turning.rpm * 2.0 * std::numbers::pi / 60.0, seconds = turning.rpm > 1000.0 ? 0.4 : 1.6;
    const int frames = static_cast<int>(std::lround(seconds / turning.frame));
    double sum = 0.0;
    int count = 0;
    for (int n = 1; n <= frames; ++n) {
        const auto angle = static_cast<float>(std::fmod(rate * turning.frame * n, 2.0 * std::numbers::pi));
        const glm::quat turned = glm::angleAxis(angle, glm::vec3(0.0f, 0.0f, 1.0f));
        EXPECT_TRUE(turning.with_spin ? wind.obstacles().move(blade, {}, turned, {0.0f, 0.0f, static_cast<float>(rate)})
                                      : wind.obstacles().move(blade, {}, turned));
        if (turning.ticks)
            (void)wind.advance(turning.frame);
        else
            (void)wind.step(turning.frame);
        if (10 * n > 3 * frames) {
            sum += static_cast<double>(wind.force_on(blade)->moment.z);
            ++count;
        }
        if (fast != nullptr)
            *fast += wind.diagnostics().fast_turns;
    }
    return sum / count;
}

TEST(BodiesThatMove, APropellerHasTheMomentOfFineSteps) {
    const double fine = moment_of({.rpm = 300.0, .frame = 1.0 / 240.0});
    const Turning turnings[] = {{300.0, 1.0 / 60.0}, {300.0, 1.0 / 24.0, true, true}, {300.0, 1.0 / 144.0, true, true}};
    for (const Turning& turning : turnings) {
        const std::string name = std::string("propeller/") + (turning.ticks ? "ticks_at_" : "steps_at_") +
                                 std::to_string(std::lround(1.0 / turning.frame)) + "_hz";
        WINDROW_EXPECT_FIGURE(name, std::abs(moment_of(turning) / fine - 1.0), 0.05);
    }
}

// The blade that had half of its moment, 9.6 by 2.4 cells: counted where its tips pass a cell a step; else within what the moment on so
// few cells differs by anyway, from place to place.
TEST(BodiesThatMove, WhatStepsDoNotResolveIsCounted) {
    for (const double rpm : {10.0, 60.0, 300.0}) {
        const glm::vec2 blade(1.2f, 0.3f);
        int fast = 0;
        const double fine = moment_of({.rpm = rpm, .frame = 1.0 / 240.0, .blade = blade}),
                     here = moment_of({.rpm = rpm, .frame = 1.0 / 60.0, .blade = blade}, &fast);
        EXPECT_EQ(fast, rpm > 100.0 ? 96 : 0);
        if (fast == 0) {
            WINDROW_EXPECT_FIGURE("propeller/uncounted_at_" + std::to_string(std::lround(rpm)) + "_rpm",
                                  std::abs(here / fine - 1.0), 0.2);
        }
    }
}

// At 3000 revolutions a minute two poses 1/60 s apart are those of a blade that turns slowly backwards, at 3600 of one at rest.
TEST(BodiesThatMove, APropellerTurnsAsOftenAsItsSpin) {
    const double fine = moment_of({.rpm = 3000.0, .frame = 1.0 / 1800.0});
    EXPECT_LT(fine, 0.0);
    int fast = 0;
    const double here = moment_of({.rpm = 3000.0, .frame = 1.0 / 60.0}, &fast);
    EXPECT_EQ(fast, 24) << "each step is counted";
    WINDROW_EXPECT_FIGURE("propeller/3000_rpm_in_steps_of_300_degrees", std::abs(here / fine - 1.0), 0.25);
    EXPECT_GT(moment_of({.rpm = 3000.0, .frame = 1.0 / 60.0, .with_spin = false}), 0.0) << "backwards";
    EXPECT_LT(moment_of({.rpm = 3600.0, .frame = 1.0 / 60.0}), 0.5 * fine) << "poses that are equal";
}

TEST(BodiesThatMove, APropellerStopsWithItsHost) {
    Wind wind = made({.cells = {12, 12, 8}});
    const ObstacleId blade = *wind.obstacles().add({.shape = Block{{3.0f, 1.0f, 1.0f}}});
    for (int n = 0; n < 3; ++n) {
        ASSERT_TRUE(wind.obstacles().move(blade, {}, glm::quat(1, 0, 0, 0), {0.0f, 0.0f, 20.0f}));
        (void)wind.step(0.01);
        EXPECT_TRUE(wind.obstacles().in_reach()[0].moves());
    }
    (void)wind.step(0.01);
    EXPECT_FALSE(wind.obstacles().in_reach()[0].moves());
    EXPECT_EQ(wind.obstacles().move(blade, {}, glm::quat(1, 0, 0, 0), {0.0f, std::nanf(""), 0.0f}).error(),
              "obstacle.spin is (0, nan, 0) rad/s: give each component -1e6 to 1e6 rad/s.");
}

} // namespace
