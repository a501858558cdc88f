// Fixed ticks: states at tick times do not depend on the frame rate, and the wind between them is continuous.

#include "tests/winds.h"

#include <map>

namespace {

using namespace windrow;
using namespace windrow::test;

using FrameTime = std::function<double(int frame)>; // [s]

/// A second and a half of a windy scene in which all that a host can move moves evenly: the air after each tick that ended a
/// frame.
std::map<int, Field> states(const FrameTime& frame_time, double seconds = 1.5) {
    Wind wind = made({.cells = {24, 12, 24},
                      .ambient = {3.0f, 0.0f, 1.0f},
                      .gusts = {.intensity = 0.3f},
                      .ticks = {.hz = 30.0, .max_per_call = 100}});
    EXPECT_TRUE(wind.motors().add(DirectionalMotor{.position = {5.0, 0.0, 2.0}, .direction = {0.0f, 0.0f, 1.0f}}));
    EXPECT_TRUE(wind.motors().add(PressureMotor{.position = {0.0, 0.0, -4.0}, .speed = 8.0f}));
    EXPECT_TRUE(wind.motors().add(VortexMotor{.envelope = {.attack = 0.2f, .hold = 0.3f, .decay = 0.4f}}));
    const MotorId body = added(wind, WakeMotor{.position = {-8.0, 0.0, 0.0}, .radius = 0.8f});
    std::map<int, Field> after;
    int ticks = 0;
    double time = 0.0;
    for (int frame = 0; time < seconds; ++frame) {
        const double dt = frame_time(frame);
        time += dt;
        EXPECT_TRUE(wind.motors().move(body, {-8.0 + 5.0 * time, 0.0, 0.0}));
        EXPECT_TRUE(wind.follow({4.1 * time, 0.0, -1.03 * time}));
        const Advance done = wind.advance(dt);
        ticks += done.ticks;
        if (done.ticks > 0)
            after[ticks] = copy(wind.field());
    }
    return after;
}

TEST(Ticks, StatesAtTickTimesDoNotDependOnTheFrameRate) {
    const auto reference = states([](int) { return 1.0 / 30.0; });
    ASSERT_GE(reference.size(), 44u);
    for (const auto& [name, frame_time] : {std::pair<std::string, FrameTime>{"20_Hz", [](int) { return 0.05; }},
                                           {"60_Hz", [](int) { return 1.0 / 60.0; }},
                                           {"144_Hz", [](int) { return 1.0 / 144.0; }},
                                           {"1000_Hz", [](int) { return 0.001; }},
                                           {"irregular", [](int n) { return 0.004 + 0.03 * double((n * 7919) % 13) / 13.0; }}}) {
        std::size_t common = 0, differing = 0;
        for (const auto& [tick, field] : states(frame_time))
            if (const auto found = reference.find(tick); found != reference.end()) {
                ++common;
                differing += cells_that_differ(field, found->second);
            }
        EXPECT_GE(common, 20u) << name;
        WINDROW_EXPECT_FIGURE("ticks/cells_that_differ_at_tick_times_" + name, double(differing), 0.0);
    }
}

/// The wind at a plant, frame by frame, while a body passes it and a fan blows.
std::vector<glm::vec3> at_plant(double tick_hz, double frame_hz, double seconds) {
    Wind wind =
        made({.ambient = {3.0f, 0.0f, 1.0f}, .gusts = {.intensity = 0.3f}, .ticks = {.hz = tick_hz, .max_per_call = 100}});
    EXPECT_TRUE(wind.motors().add(DirectionalMotor{.position = {2.0, 0.0, 2.0}, .direction = {0.0f, 0.0f, -1.0f}}));
    const MotorId body = added(wind, WakeMotor{.position = {-8.0, 0.0, 0.5}, .radius = 0.8f, .law = WakeDrive{8.0f, 1.0f}});
    std::vector<glm::vec3> seen;
    for (int frame = 1; frame <= int(seconds * frame_hz); ++frame) {
        const double time = frame / frame_hz;
        EXPECT_TRUE(wind.motors().move(body, {-8.0 + 6.0 * time, 0.0, 0.5}));
        EXPECT_TRUE(wind.follow({2.0 * time, 0.0, 0.0}));
        wind.advance(1.0 / frame_hz);
        seen.push_back(wind.velocity({2.0, 0.0, 0.0}));
    }
    return seen;
}

double largest_step(const std::vector<glm::vec3>& seen, std::size_t from) {
    double largest = 0.0;
    for (std::size_t n = from; n < seen.size(); ++n)
        largest = std::max(largest, double(glm::length(seen[n] - seen[n - 1])));
    return largest;
}

TEST(Ticks, ThirtyTicksDrawnAt144HzAreAsSmoothAs144Ticks) {
    const auto coarse = at_plant(30.0, 144.0, 2.5), fine = at_plant(144.0, 144.0, 2.5);
    const double coarse_step = largest_step(coarse, 145), fine_step = largest_step(fine, 145);
    figure("ticks/largest_step_between_frames_30_hz_ticks_m_per_s", coarse_step);
    figure("ticks/largest_step_between_frames_144_hz_ticks_m_per_s", fine_step);
    EXPECT_GT(fine_step, 0.01) << "nothing happened";
    WINDROW_EXPECT_FIGURE("ticks/largest_step_ratio", coarse_step / fine_step, 1.25);
    // A renderer that does not blend sees a whole tick at once.
    double unblended = 0.0;
    for (std::size_t n = 145; n + 5 < fine.size(); ++n)
        unblended = std::max(unblended, double(glm::length(fine[n + 5] - fine[n])));
    figure("ticks/largest_step_without_blending_m_per_s", unblended);
}

TEST(Ticks, AFrameIsTheBlendOfTheLastTwoTicks) {
    Wind wind = made({.cells = {12, 12, 12}, .ambient = {1.0f, 0.0f, 0.0f}, .ticks = {.hz = 10.0}});
    ASSERT_TRUE(wind.set_velocity(smooth_noise({12, 12, 12}, 3.0f, 7)));
    ASSERT_EQ(wind.advance(0.1).ticks, 1);
    const Field before = copy(wind.field());
    ASSERT_EQ(wind.advance(0.1).ticks, 1);
    const Field after = copy(wind.field());
    Field last = copy(wind.view().field());
    EXPECT_EQ(cells_that_differ(last, before), 0u) << "at factor 0 the older tick is shown";
    for (const double share : {0.25, 0.5, 0.75}) {
        const Advance done = wind.advance(0.025);
        EXPECT_EQ(done.ticks, 0);
        EXPECT_NEAR(done.factor, share, 1e-6);
        EXPECT_EQ(wind.window_block({}).factor, done.factor);
        double worst = 0.0;
        for (std::size_t n = 0; n < before.size(); ++n)
            worst = std::max(worst, double(glm::length(wind.view().field()[n] - glm::mix(before[n], after[n], done.factor))));
        EXPECT_LE(worst, 1e-6);
        EXPECT_EQ(cells_that_differ(wind.previous_view().field(), last), 0u) << "the frame before";
        last = copy(wind.view().field());
    }
}

TEST(Ticks, WhatIsDrawnIsContinuousAcrossTicksAndShifts) {
    Wind wind = made({.ambient = {2.0f, 0.0f, 0.5f}, .gusts = {.intensity = 0.3f}, .ticks = {.hz = 30.0}});
    ASSERT_TRUE(wind.motors().add(DirectionalMotor{.position = {3.0, 0.0, 0.0}, .direction = {1.0f, 0.0f, 1.0f}}));
    for (int n = 0; n < 60; ++n)
        wind.advance(1.0 / 30.0);
    Random random(3);
    std::vector<glm::dvec3> points;
    for (int n = 0; n < 500; ++n)
        points.push_back(random.point(20.0) * glm::dvec3(1.0, 0.3, 1.0));
    std::vector<glm::vec3> before(points.size()), now(points.size());
    wind.velocity(points, before);
    double largest = 0.0;
    int shifts = 0;
    glm::dvec3 origin = wind.view().origin();
    for (int frame = 1; frame <= 1000; ++frame) { // a millisecond each: 5 m/s, thirty ticks, five shifts
        ASSERT_TRUE(wind.follow({0.005 * frame, 0.0, 0.0}));
        wind.advance(0.001);
        shifts += wind.view().origin() != origin;
        origin = wind.view().origin();
        wind.velocity(points, now);
        for (std::size_t n = 0; n < points.size(); ++n)
            largest = std::max(largest, double(glm::length(now[n] - before[n])));
        before.swap(now);
    }
    EXPECT_EQ(shifts, 5);
    WINDROW_EXPECT_FIGURE("ticks/largest_change_in_a_millisecond_m_per_s", largest, 0.05);
}

TEST(Ticks, TimeBeyondTheMostIsDroppedAndReported) {
    Wind wind = made({.cells = {8, 8, 8}, .ticks = {.hz = 50.0, .max_per_call = 3}});
    const Advance long_frame = wind.advance(0.2);
    EXPECT_EQ(long_frame.ticks, 3);
    EXPECT_NEAR(long_frame.dropped, 7 * 0.02, 1e-12);
    EXPECT_NEAR(long_frame.factor, 0.0f, 1e-6f);
    EXPECT_TRUE(long_frame.last.stepped);
    const Advance next = wind.advance(0.03);
    EXPECT_EQ(next.ticks, 1);
    EXPECT_EQ(next.dropped, 0.0);
    EXPECT_NEAR(next.factor, 0.5f, 1e-6f);
    const Advance endless = wind.advance(1e12);
    EXPECT_EQ(endless.ticks, 3);
    EXPECT_TRUE(all_finite(wind.view().field()));
}

TEST(Ticks, WhatIsNoTimeDoesNothing) {
    Wind wind = made({.cells = {8, 8, 8}, .ambient = {1.0f, 0.0f, 0.0f}});
    for (const double dt : {-0.1, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        const Advance done = wind.advance(dt);
        EXPECT_EQ(done.ticks, 0);
        EXPECT_FALSE(done.last.stepped);
    }
    EXPECT_EQ(wind.advance(0.0).ticks, 0);
}

TEST(Ticks, AStepEndsTheBlending) {
    Wind wind = made({.cells = {16, 8, 16}, .ambient = {1.0f, 0.0f, 0.0f}});
    wind.advance(0.05);
    ASSERT_TRUE(wind.follow({5.0, 0.0, 0.0}));
    EXPECT_EQ(wind.origin().x, -8.0) << "with advance, the box moves in its ticks";
    wind.step(0.01);
    EXPECT_EQ(wind.origin().x, -3.0);
    EXPECT_EQ(wind.view().field().data(), wind.field().data());
}

} // namespace
