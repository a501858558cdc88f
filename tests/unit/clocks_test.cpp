// Clocks on every system: times of stages are of a clock that never goes back, and fine enough for a step of a millisecond.
#include "fluid/cpu/stopwatch.h"
#include "fluid/wind.h"

#include <chrono>
#include <gtest/gtest.h>
#include <thread>

namespace {

using namespace windrow;

TEST(Clocks, AStopwatchMeasuresWhatTheSystemSleeps) {
    double milliseconds = 0.0;
    const auto start = std::chrono::steady_clock::now();
    {
        const cpu::Stopwatch watch("windrow test", milliseconds);
        std::this_thread::sleep_for(std::chrono::milliseconds(30));
    }
    const double outside = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    EXPECT_GE(milliseconds, 29.0); // a timer may end one tick early
    EXPECT_LE(milliseconds, outside);
}

TEST(Clocks, AreSteadyAndFine) {
    static_assert(std::chrono::steady_clock::is_steady);
    auto last = std::chrono::steady_clock::now();
    const auto start = last;
    std::chrono::steady_clock::duration least = std::chrono::hours(1);
    while (last - start < std::chrono::milliseconds(20)) {
        const auto now = std::chrono::steady_clock::now();
        ASSERT_GE(now, last);
        if (now > last)
            least = std::min(least, now - last);
        last = now;
    }
    EXPECT_LE(least, std::chrono::microseconds(20)); // what a waiting thread looks for work
}

TEST(Clocks, AStepTellsItsTime) {
    auto wind = Wind::create({.cells = {24, 12, 24}, .ambient = {3.0f, 0.0f, 0.0f}});
    ASSERT_TRUE(wind) << wind.error();
    (void)wind->motors().add(DirectionalMotor{});
    const auto start = std::chrono::steady_clock::now();
    const Diagnostics done = wind->step(1.0 / 60.0);
    const double outside = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    EXPECT_GT(done.times_ms.total, 0.0);
    EXPECT_GT(done.times_ms.advection, 0.0);
    EXPECT_LE(done.times_ms.total, outside);
}

} // namespace
