// Times of frames, and the steps between them.
#include "scene/frame_times.h"

#include <cmath>
#include <gtest/gtest.h>

namespace windrow::scene {
namespace {

TEST(FrameTimes, FramesAreWhereTheyBelong) {
    const FrameTimes film(0.0, 24.0, 60.0);
    for (int n = 0; n < 1000; ++n)
        EXPECT_EQ(film.time_of_frame(n), n / 24.0) << n;
    EXPECT_EQ(film.step_of_frame(1), 3) << "2.5 ticks";
    EXPECT_EQ(film.step_hz(), 72.0);
    const FrameTimes ntsc(0.0, 24000.0 / 1001.0, 60.0);
    for (int n = 0; n < 100'000; n += 997)
        EXPECT_NEAR(ntsc.time_of_frame(n), n * 1001.0 / 24000.0, 1e-15 * (n + 1)) << n;
}

TEST(FrameTimes, StepsAreEqualAndNoLongerThanATick) {
    for (const double fps : {0.3, 10.0, 23.976, 24.0, 24000.0 / 1001.0, 25.0, 29.97, 48.0, 60.0, 120.0, 144.0})
        for (const double from : {0.0, 1.0, 0.21}) {
            const FrameTimes film(from, fps, 60.0);
            double before = 0.0;
            for (std::int64_t step = 1; step <= film.step_of_frame(20); ++step) {
                const double length = film.length_of_step(step), now = film.time_of_step(step);
                EXPECT_LE(length, (1.0 + 1e-9) / 60.0) << fps << " " << from;
                EXPECT_NEAR(now - before, length, 1e-12) << fps << " " << from << " " << step;
                before = now;
            }
            EXPECT_NEAR(film.time_of_frame(20), from + 20.0 / fps, 1e-12);
        }
    EXPECT_EQ(FrameTimes(0.0, 10.0, 60.0).length_of_step(5), 1.0 / 60.0) << "where ticks fit frames, they are the steps";
}

TEST(FrameTimes, APartOfAFilmHasTheStepsOfTheWhole) {
    const FrameTimes whole(0.0, 24.0, 60.0), part(1.5, 24.0, 60.0), off(1.51, 24.0, 60.0);
    EXPECT_EQ(part.step_of_frame(2), whole.step_of_frame(38));
    EXPECT_EQ(part.time_of_frame(2), whole.time_of_frame(38));
    for (int step = 1; step < 200; ++step)
        EXPECT_EQ(part.length_of_step(step), whole.length_of_step(step));
    EXPECT_EQ(off.time_of_frame(0), 1.51);
    EXPECT_NEAR(off.time_of_frame(48), 3.51, 1e-15);
    EXPECT_NEAR(off.length_of_step(off.step_of_frame(0)), 1.51 / 91.0, 1e-15);
    EXPECT_NEAR(off.length_of_step(off.step_of_frame(0) + 1), 1.0 / 72.0, 1e-15);
}

TEST(FrameTimes, CountsFramesUpToATime) {
    EXPECT_EQ(FrameTimes(0.0, 10.0, 60.0).frames_until(0.3), 4) << "0.3 * 10 is a hair below 3";
    EXPECT_EQ(FrameTimes(0.0, 24.0, 60.0).frames_until(2.0), 49);
    EXPECT_EQ(FrameTimes(1.0, 24.0, 60.0).frames_until(2.0), 25);
    EXPECT_EQ(FrameTimes(1.0, 24.0, 60.0).frames_until(1.0), 1);
    EXPECT_EQ(FrameTimes(1.0, 24.0, 60.0).frames_until(0.99), 0);
}

} // namespace
} // namespace windrow::scene
