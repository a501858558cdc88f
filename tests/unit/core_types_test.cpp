// The small types that a wind's core is made of: ticks, sleep, window, frames.

#include "fluid/core/frame_history.h"
#include "fluid/core/sleep.h"
#include "fluid/core/tick_clock.h"
#include "fluid/core/window_history.h"

#include <gtest/gtest.h>
#include <vector>

namespace {

using namespace windrow;

TEST(TickClock, SpendsWholeTicksOfAnyFrames) {
    constexpr Ticks k_ticks{.hz = 30.0, .max_per_call = 1000};
    for (const double hz : {7.0, 30.0, 59.94, 144.0, 1000.0}) {
        TickClock clock;
        int ticks = 0;
        const int frames = static_cast<int>(10.0 * hz);
        for (int n = 0; n < frames; ++n) {
            const TickClock::Due due = clock.spend(1.0 / hz, k_ticks);
            EXPECT_EQ(due.dropped, 0.0);
            EXPECT_GE(clock.lead, 0.0);
            EXPECT_LT(clock.factor(k_ticks), 1.0);
            ticks += due.ticks;
        }
        EXPECT_NEAR(ticks / 30.0 + clock.lead, frames / hz, 1e-9) << hz << " Hz";
    }
}

TEST(TickClock, ATickThatIsDueExceptForRoundingIsDue) {
    TickClock clock;
    int ticks = 0;
    for (int n = 0; n < 10; ++n)
        ticks += clock.spend(0.1, {.hz = 1.0, .max_per_call = 4}).ticks; // ten tenths are a hair below 1
    EXPECT_EQ(ticks, 1);
    EXPECT_EQ(clock.lead, 0.0);
}

TEST(TickClock, DropsWholeTicksBeyondTheMost) {
    TickClock clock;
    const TickClock::Due due = clock.spend(1.25, {.hz = 10.0, .max_per_call = 4});
    EXPECT_EQ(due.ticks, 4);
    EXPECT_NEAR(due.dropped, 0.8, 1e-12);
    EXPECT_NEAR(clock.lead, 0.05, 1e-12);
    EXPECT_EQ(clock.spend(1e9, {.hz = 1e4, .max_per_call = 1}).ticks, 1);
    EXPECT_LT(clock.lead, 1e-4);
}

TEST(SleepDepth, GoesDownByFillingAndUpByActing) {
    Sleep sleep;
    sleep.stir();
    EXPECT_FALSE(sleep.calm()) << "nothing makes air calm but filling";
    sleep.fill();
    EXPECT_TRUE(sleep.calm() && !sleep.asleep());
    Diagnostics report{.stepped = true, .max_speed = 2.0f, .substeps = 3, .energy = 5.0, .times_ms = {.total = 1.0}};
    sleep.fall_asleep(report);
    EXPECT_TRUE(sleep.asleep() && sleep.calm() && report.asleep);
    EXPECT_EQ(sleep.at_rest.max_speed, 2.0f);
    EXPECT_EQ(sleep.at_rest.energy, 5.0);
    EXPECT_EQ(sleep.at_rest.times_ms.total, 0.0);
    sleep.fill();
    EXPECT_TRUE(sleep.asleep());
    sleep.stir();
    EXPECT_TRUE(sleep.calm() && !sleep.asleep());
    sleep.wake();
    EXPECT_FALSE(sleep.calm());
}

TEST(SleepDepth, EachConditionKeepsTheAirAwake) {
    const Sleep::Conditions still{.relaxation_time = 20.0f, .sleep_speed = 1e-3f};
    EXPECT_TRUE(Sleep::may_begin(still));
    std::vector<Sleep::Conditions> awake(6, still);
    awake[0].relaxation_time = 0.0f;
    awake[1].sleep_speed = 0.0f;
    awake[2].motors = 1;
    awake[3].source_flow = true;
    awake[4].viscous = true;
    awake[5].wind_among_plants = true;
    for (std::size_t n = 0; n < awake.size(); ++n)
        EXPECT_FALSE(Sleep::may_begin(awake[n])) << n;
}

TEST(WindowHistory, KeepsTheLastTwoSteps) {
    WindowHistory place({.cells = {8, 6, 8}, .cell_size = 0.5f, .centre = {1.0, 0.0, 0.0}});
    EXPECT_EQ(place.window.origin_cells, CellIndex(-2, -3, -4));
    EXPECT_EQ(place.previous.origin_cells, place.window.origin_cells);
    for (int n = 1; n <= 3; ++n) {
        place.point.x = n;
        place.window.origin_cells = place.around(place.point);
        place.note_step();
    }
    EXPECT_EQ(place.stepped.point.x, 3.0);
    EXPECT_EQ(place.previous.point.x, 2.0);
    EXPECT_EQ(place.previous.origin_cells.x, 0);
    EXPECT_FALSE(place.leaves({7, -5, 7}));
    EXPECT_TRUE(place.leaves({0, -6, 0}));
}

TEST(WindowHistory, MovesOnAxesThatFollowAlone) {
    WindowHistory place({.cells = {16, 16, 16}, .boundaries = Boundaries::open_over_floor()});
    EXPECT_EQ(place.follow_axes, glm::bvec3(true, false, true));
    EXPECT_EQ(place.around({3.0, 9.0, -2.0}), CellIndex(-5, 0, -10)) << "on its floor";
    const BlendZone rim = place.blend_zone({0.0, 0.0, 0.0}, 2.0f, 1.0f);
    EXPECT_EQ(rim.reach, glm::vec3(7.0f, 0.0f, 7.0f));
    EXPECT_EQ(place.blend_zone({0.0, 0.0, 0.0}, 7.0f, 1.0f).reach, glm::vec3(0.0f)) << "no room for it";
    EXPECT_EQ(place.blend_zone({0.0, 0.0, 0.0}, 0.0f, 1.0f).reach, glm::vec3(0.0f));
}

TEST(FrameHistory, BlendsTheLastTwoTicks) {
    AmbientWind wind =
        *AmbientWind::create({.mean = {2.0f, 0.0f, 0.0f}, .gusts = {.intensity = 0.2f, .tile = GustTile::standard()}});
    const Window window{.cells = {8, 8, 8}, .cell_size = 1.0f, .origin_cells = {}};
    FrameHistory frames({window, {1.0, 0.0, 0.0}, wind});
    frames.keep({window, {1.0, 0.0, 0.0}, wind});
    wind.advance(1.0);
    const FrameBlend blend = frames.show({window, {3.0, 0.0, 0.0}, wind}, 0.25);
    EXPECT_EQ(blend.factor, 0.25f);
    EXPECT_FALSE(blend.still);
    EXPECT_EQ(frames.shown.blend_centre.x, 1.5);
    EXPECT_NEAR(frames.shown.ambient.phase().x, 0.5, 1e-12);
    EXPECT_EQ(frames.shown_before.blend_centre.x, 1.0);
}

// Cells of the frame before the last one are written over, unless they are those of this frame.
TEST(FrameHistory, OfSleepingAirChangesWithTheWindAlone) {
    AmbientWind wind = *AmbientWind::create({.mean = {2.0f, 0.0f, 0.0f}});
    const Window window{.cells = {8, 8, 8}, .cell_size = 1.0f, .origin_cells = {}};
    const auto now = [&] { return AirNow{window, {}, wind, true}; };
    FrameHistory frames(now());
    frames.keep(now());
    for (int n = 0; n < 4; ++n) {
        const FrameBlend blend = frames.show(now(), 0.5);
        EXPECT_TRUE(blend.still);
        EXPECT_EQ(blend.unchanged, n >= 2) << "both fields are written once";
    }
    ASSERT_TRUE(wind.set_mean({1.0f, 0.0f, 0.0f}));
    EXPECT_FALSE(frames.show(now(), 0.5).unchanged);
}

} // namespace
