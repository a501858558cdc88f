// Shells that lag behind their body, without overshoot, alike at any frame rate and for any number of shells; and the two
// strategies of the write-up on Bloodelic's fur.
#include "coupling/cascade.h"
#include "coupling/motion_numerics.h"
#include "tests/figure.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace windrow {
namespace {

glm::dvec4 turn(glm::dvec3 axis, double angle) {
    return {std::sin(0.5 * angle) * glm::normalize(axis), std::cos(0.5 * angle)};
}

double angle_between(glm::dvec4 a, glm::dvec4 b) {
    const glm::dvec4 difference = a - (glm::dot(a, b) < 0.0 ? -b : b);
    return 4.0 * std::asin(std::min(1.0, 0.5 * glm::length(difference)));
}

Cascade cascade_of(const CascadeConfig& config, const Pose& body) {
    auto made = Cascade::create(config, body);
    EXPECT_TRUE(made) << (made ? "" : made.error());
    return *std::move(made);
}

// --- The source's strategies, for comparison --------------------------------------------------------------------------------

enum class Strategy { none, one, two };

// Frames until the tip has done 90 % of a step of the body. Shell 0 is glued to it; each frame every shell in turn goes a
// fraction k of the way to its target. Animation shells are those at multiples of N / N_a.
int frames_to_90(int shells, int animation_shells, Strategy strategy, double k) {
    std::vector<double> place(static_cast<std::size_t>(shells), 0.0);
    const int group = strategy == Strategy::none ? 1 : shells / animation_shells;
    for (int frame = 1; frame < 100000; ++frame) {
        place[0] = 1.0;
        for (int i = 1; i < shells; ++i) {
            const int within = i % group;
            const int target = within == 0 ? std::max(0, i - group) : strategy == Strategy::two ? i - within : i - 1;
            place[static_cast<std::size_t>(i)] +=
                k * (place[static_cast<std::size_t>(target)] - place[static_cast<std::size_t>(i)]);
        }
        if (place.back() >= 0.9)
            return frame;
    }
    return 0;
}

TEST(CascadeStrategies, HaveTheFrameCountsOfTheSource) {
    const auto count = [](const char* name, int shells, int animation_shells, Strategy strategy) {
        return static_cast<int>(
            test::figure(std::string("cascade/source/") + name, frames_to_90(shells, animation_shells, strategy, 0.3)));
    };
    EXPECT_EQ(count("20", 20, 0, Strategy::none), 61);
    EXPECT_EQ(count("200", 200, 0, Strategy::none), 516);
    EXPECT_EQ(count("200_on_20_one", 200, 20, Strategy::one), 86);
    EXPECT_EQ(count("200_on_20_two", 200, 20, Strategy::two), 64);
    EXPECT_EQ(count("200_on_10_two", 200, 10, Strategy::two), 36);
    EXPECT_EQ(count("20_on_10_two", 20, 10, Strategy::two), 36);
}

// --- Ours -------------------------------------------------------------------------------------------------------------------

// The pose of each shell of N as a vertex shader reads it.
std::vector<numerics::WindrowPose> shells_of(Cascade& cascade, int shells) {
    const auto poses = cascade.shader_poses({0.0, 0.0, 0.0});
    const int stages = cascade.config().stages;
    std::vector<numerics::WindrowPose> found;
    for (int i = 0; i <= shells; ++i) {
        const float height = static_cast<float>(i) / static_cast<float>(shells);
        const auto stage = static_cast<std::size_t>(numerics::windrow_cascade_stage(height, stages));
        const auto pose = [&](std::size_t n) { return std::bit_cast<numerics::WindrowPose>(poses[n]); };
        found.push_back(
            numerics::windrow_pose_between(pose(stage), pose(stage + 1), numerics::windrow_cascade_fraction(height, stages)));
    }
    return found;
}

// A body that runs, turns and jumps: where it is at its n-th knot.
Pose body_at(int knot) {
    const double q = knot;
    return {.position = {std::sin(1.3 * q), 0.3 * std::cos(2.1 * q), 0.7 * std::sin(0.4 * q)},
            .rotation = turn({std::cos(q), 1.0, std::sin(q)}, 0.9 * std::sin(1.7 * q)),
            .scale = 1.0};
}

// Between knots `frames` frames apart it goes straight, and turns evenly about an axis that stays: along the arc, as a body does.
Pose body_between(int frames, int frame) {
    const double share = static_cast<double>(frame % frames) / frames;
    const Pose from = body_at(frame / frames), to = body_at(frame / frames + 1);
    const glm::dvec4 end = glm::dot(from.rotation, to.rotation) < 0.0 ? -to.rotation : to.rotation;
    const double arc = 0.5 * angle_between(from.rotation, end);
    Pose body = from;
    body.position += share * (to.position - from.position);
    body.rotation = (std::sin((1.0 - share) * arc) * from.rotation + std::sin(share * arc) * end) / std::sin(arc);
    return body;
}

// All that frame rates can differ in: tenths of the height at each knot, `knots` of them a second, over ten knots.
std::vector<Pose> history_at(int rate, int knots) {
    std::vector<Pose> found;
    Cascade cascade = cascade_of({.stages = 10, .lag = 0.3}, body_at(0));
    for (int frame = 1; frame <= 10 * rate / knots; ++frame) {
        EXPECT_TRUE(cascade.advance(1.0 / rate, body_between(rate / knots, frame)));
        if (frame % (rate / knots) == 0)
            for (int tenth = 0; tenth <= 10; ++tenth)
                found.push_back(cascade.at(0.1 * tenth));
    }
    return found;
}

TEST(Cascade, TwentyAndTwoHundredShellsMoveAlike) {
    double worst = 0.0, largest_lag = 0.0;
    Cascade cascade = cascade_of({.stages = 10, .lag = 0.3}, body_at(0));
    for (int quarter = 1; quarter < 40; ++quarter) {
        ASSERT_TRUE(cascade.advance(0.25, body_at(quarter)));
        const auto few = shells_of(cascade, 20), many = shells_of(cascade, 200);
        for (std::size_t i = 0; i < few.size(); ++i) {
            worst = std::max(worst, static_cast<double>(glm::length(few[i].place - many[10 * i].place)));
            worst = std::max(worst, static_cast<double>(glm::length(few[i].rotation - many[10 * i].rotation)));
        }
        largest_lag = std::max(largest_lag, static_cast<double>(glm::length(few.back().place - few.front().place)));
    }
    WINDROW_EXPECT_FIGURE("cascade/20_against_200_shells", worst, 1e-6);
    EXPECT_GT(test::figure("cascade/20_against_200_shells/largest_lag", largest_lag), 0.1); // it did move
}

// A frame rate is compared at knots that are whole frames of it: three a second at 15 and 30 Hz, four at the others. Positions
// are exact. A quaternion goes along the chord of a frame, and its share of the arc's way is bounded: 1 % of what the body turns
// in the longest frame, a quarter of a radian at 15 Hz.
TEST(Cascade, IsTheSameAtAnyFrameRate) {
    double worst_place = 0.0, worst_turn = 0.0;
    const auto compare = [&](std::initializer_list<int> rates, int knots, int fine) {
        const auto truth = history_at(fine, knots), straight = history_at(knots, knots);
        for (const int rate : rates) {
            const auto found = history_at(rate, knots);
            double turned = 0.0; // the most in a frame
            for (int frame = 1; frame <= 10 * rate / knots; ++frame)
                turned = std::max(turned, angle_between(body_between(rate / knots, frame).rotation,
                                                        body_between(rate / knots, frame - 1).rotation));
            double off = 0.0;
            for (std::size_t n = 0; n < truth.size(); ++n) {
                worst_place = std::max(worst_place, glm::length(found[n].position - straight[n].position));
                off = std::max(off, angle_between(found[n].rotation, truth[n].rotation));
            }
            const std::string name = "cascade/rotations/" + std::to_string(rate) + "_hz";
            test::figure(name + "/turned_in_a_frame", turned);
            test::figure(name + "/off", off);
            worst_turn = std::max(worst_turn, off / turned);
        }
    };
    compare({15, 30}, 3, 6000);
    compare({60, 144, 1000}, 4, 6000);
    WINDROW_EXPECT_FIGURE("cascade/poses_at_any_rate", worst_place, 1e-12);
    WINDROW_EXPECT_FIGURE("cascade/rotations_at_any_rate/of_a_frames_turn", worst_turn, 0.01);
}

// A body that spins by nearly a radian a frame, and turns back at each knot: the hardest for chords.
TEST(Cascade, ARadianAFrameIsWellFollowed) {
    const auto history = [](int frames) { // of a knot of 1/5 s; the truth in many
        std::vector<glm::dvec4> found;
        Cascade cascade = cascade_of({.stages = 10, .lag = 0.3}, {});
        for (int frame = 1; frame <= 15 * frames; ++frame) {
            const int knot = (frame - 1) / frames;
            const double share = static_cast<double>(frame - knot * frames) / frames;
            const double angle = 3.0 * (knot % 2 == 0 ? share : 1.0 - share); // three frames of a radian at 15 Hz
            EXPECT_TRUE(cascade.advance(0.2 / frames, {.rotation = turn({1.0, 2.0, 0.5}, angle)}));
            if (frame % frames == 0)
                for (int tenth = 1; tenth <= 10; ++tenth)
                    found.push_back(cascade.at(0.1 * tenth).rotation);
        }
        return found;
    };
    const auto truth = history(1200), at_15_hz = history(3);
    double off = 0.0;
    for (std::size_t n = 0; n < truth.size(); ++n)
        off = std::max(off, angle_between(truth[n], at_15_hz[n]));
    WINDROW_EXPECT_FIGURE("cascade/a_radian_a_frame/off", off, 0.01);
}

TEST(Cascade, AStepLagsWithoutOvershootAndEnds) {
    Cascade cascade = cascade_of({}, {});
    const Pose there{.position = {1.0, 0.0, 0.0}, .rotation = turn({0.0, 1.0, 0.0}, 2.0), .scale = 3.0};
    double before_tip = 0.0, before_angle = 0.0, longest = 0.0, shortest = 2.0, over = 0.0;
    ASSERT_TRUE(cascade.advance(0.0, there)); // the body jumps
    EXPECT_EQ(cascade.at(1.0).position.x, 0.0);
    for (int frame = 0; frame < 120; ++frame) {
        ASSERT_TRUE(cascade.advance(1.0 / 60.0, there));
        double outer = 1.0;
        for (int tenth = 0; tenth <= 10; ++tenth) {
            const Pose shell = cascade.at(0.1 * tenth);
            EXPECT_LE(shell.position.x, outer + 1e-15); // each lags behind the one inside it
            outer = shell.position.x;
            over = std::max(over, shell.position.x - 1.0);
            longest = std::max(longest, glm::length(shell.rotation));
            shortest = std::min(shortest, glm::length(shell.rotation));
            EXPECT_EQ(shell.scale, 3.0);
        }
        const Pose tip = cascade.at(1.0);
        const double angle = angle_between(tip.rotation, turn({0.0, 1.0, 0.0}, 0.0));
        EXPECT_GE(tip.position.x, before_tip);
        EXPECT_GE(angle, before_angle - 1e-12);
        over = std::max(over, angle - 2.0);
        before_tip = tip.position.x;
        before_angle = angle;
    }
    WINDROW_EXPECT_FIGURE("cascade/step/overshoot", over, 1e-12);
    WINDROW_EXPECT_FIGURE("cascade/step/rest_of_place", 1.0 - before_tip, 1e-4);
    WINDROW_EXPECT_FIGURE("cascade/step/rest_of_turn", 2.0 - before_angle, 1e-4);
    WINDROW_EXPECT_FIGURE("cascade/step/quaternion", std::max(longest - 1.0, 1.0 - shortest), 1e-6);
}

// The tip's mean delay is the lag, whatever the number of stages: behind a body at speed 1 it stays `lag` behind.
TEST(Cascade, LagIsTheDelayOfTheTip) {
    double worst = 0.0;
    for (const int stages : {1, 5, 10, 40, 64}) {
        Cascade cascade = cascade_of({.stages = stages, .lag = 0.4}, {});
        for (int frame = 1; frame <= 600; ++frame)
            ASSERT_TRUE(cascade.advance(1.0 / 60.0, {.position = {frame / 60.0, 0.0, 0.0}}));
        worst = std::max(worst, std::abs(10.0 - cascade.at(1.0).position.x - 0.4));
        worst = std::max(worst, std::abs(10.0 - cascade.at(0.5).position.x - 0.2));
    }
    WINDROW_EXPECT_FIGURE("cascade/lag", worst, 1e-9);
}

// q and -q are one rotation: a body that hands in either, and turns on and on, shakes nothing.
TEST(Cascade, TurnsOnWithoutASignOfTheQuaternion) {
    Cascade cascade = cascade_of({.stages = 10, .lag = 0.1}, {}), flipped = cascade;
    double worst = 0.0, slowest = 10.0, fastest = 0.0;
    glm::dvec4 before = cascade.at(1.0).rotation;
    for (int frame = 1; frame <= 600; ++frame) {
        const glm::dvec4 q = turn({0.0, 1.0, 0.0}, 0.05 * frame);
        ASSERT_TRUE(cascade.advance(1.0 / 60.0, {.rotation = q}));
        ASSERT_TRUE(flipped.advance(1.0 / 60.0, {.rotation = frame % 3 == 0 ? -2.0 * q : 0.5 * q}));
        worst = std::max(worst, angle_between(cascade.at(1.0).rotation, flipped.at(1.0).rotation));
        if (frame > 60) {
            const double step = angle_between(cascade.at(1.0).rotation, before);
            slowest = std::min(slowest, step);
            fastest = std::max(fastest, step);
        }
        before = cascade.at(1.0).rotation;
    }
    WINDROW_EXPECT_FIGURE("cascade/turning/sign", worst, 1e-12);
    EXPECT_NEAR(test::figure("cascade/turning/slowest", slowest), 0.05, 1e-6);
    EXPECT_NEAR(test::figure("cascade/turning/fastest", fastest), 0.05, 1e-6);
}

// --- Motion vectors, teleports, the shader's poses
// --------------------------------------------------------------------------------

TEST(Cascade, PreviousIsTheLastFrameAndTheirDifferenceTheVelocity) {
    double errors[3];
    for (int k = 0; k < 3; ++k) {
        const double h = 0.02 / (1 << k);
        Cascade cascade = cascade_of({.stages = 8, .lag = 0.3}, {}), fine = cascade;
        Pose last{};
        errors[k] = 0.0;
        for (int frame = 1; frame * h <= 1.0; ++frame) {
            const auto body = [&](double time) { return Pose{.position = {std::min(time, 0.5), 0.0, 0.0}}; };
            fine = cascade;
            ASSERT_TRUE(cascade.advance(h, body(frame * h)));
            EXPECT_EQ(cascade.previous_at(0.75).position, last.position);
            last = cascade.at(0.75);
            // The velocity half a frame ago, by a step as small as rounding allows.
            const double e = 1e-5 * h;
            ASSERT_TRUE(fine.advance(0.5 * h - e, body((frame - 0.5) * h - e)));
            const double low = fine.at(0.75).position.x;
            ASSERT_TRUE(fine.advance(2.0 * e, body((frame - 0.5) * h + e)));
            const double velocity = (fine.at(0.75).position.x - low) / (2.0 * e);
            const double moved = cascade.at(0.75).position.x - cascade.previous_at(0.75).position.x;
            errors[k] = std::max(errors[k], std::abs(moved / h - velocity));
        }
    }
    test::figure("cascade/motion_vector_error", errors[2]);
    EXPECT_NEAR(test::figure("cascade/motion_vector_slope", std::log2(errors[0] / errors[1])), 2.0, 0.15);
}

TEST(Cascade, FarAwayIsAsExactAsTheOrigin) {
    const glm::dvec3 far(1048576.0, 0.0, -1048576.0); // sums with it are exact for what is a multiple of 2^-32
    Cascade near = cascade_of({}, {}), there = cascade_of({}, {.position = far});
    for (int frame = 1; frame <= 60; ++frame) {
        const glm::dvec3 place(frame / 64.0, 0.25, 0.0);
        ASSERT_TRUE(near.advance(1.0 / 60.0, {.position = place}));
        ASSERT_TRUE(there.advance(1.0 / 60.0, {.position = far + place}));
    }
    double worst = 0.0;
    const auto a = near.shader_poses({0.5, 0.0, 0.0}), b = there.shader_poses(far + glm::dvec3(0.5, 0.0, 0.0));
    ASSERT_EQ(a.size(), 11u);
    for (std::size_t n = 0; n < a.size(); ++n)
        worst = std::max(worst, static_cast<double>(glm::length(a[n].place - b[n].place)));
    WINDROW_EXPECT_FIGURE("cascade/far_away", worst, 1e-8);
    ASSERT_TRUE(near.move(far));
    EXPECT_NEAR(glm::length(near.at(1.0).position - there.at(1.0).position), 0.0, 1e-8);
    EXPECT_NEAR(glm::length(near.previous_at(1.0).position - there.previous_at(1.0).position), 0.0, 1e-8);
    ASSERT_TRUE(near.reset({.position = {5.0, 6.0, 7.0}}));
    EXPECT_EQ(near.at(1.0).position, glm::dvec3(5.0, 6.0, 7.0));
    EXPECT_EQ(near.previous_at(1.0).position, glm::dvec3(5.0, 6.0, 7.0));
}

// The text in float against the class in double, and a point of the body's space turned and moved.
TEST(Cascade, ShaderTextReadsTheSamePoses) {
    Cascade cascade = cascade_of({.stages = 10, .lag = 0.3}, body_at(0));
    for (int quarter = 1; quarter < 8; ++quarter)
        ASSERT_TRUE(cascade.advance(0.25, body_at(quarter)));
    const auto shells = shells_of(cascade, 37);
    double worst = 0.0;
    for (int i = 0; i <= 37; ++i) {
        const Pose pose = cascade.at(i / 37.0);
        const numerics::WindrowPose& shell = shells[static_cast<std::size_t>(i)];
        worst = std::max({worst, glm::length(glm::dvec3(shell.place) - pose.position),
                          glm::length(glm::dvec4(shell.rotation) - pose.rotation)});
    }
    WINDROW_EXPECT_FIGURE("cascade/shader_text", worst, 1e-6);
    numerics::WindrowPose quarter_turn;
    quarter_turn.place = {1.0f, 2.0f, 3.0f, 2.0f};
    quarter_turn.rotation = glm::vec4(turn({0.0, 1.0, 0.0}, 0.5 * std::numbers::pi));
    const glm::vec3 posed = numerics::windrow_posed(quarter_turn, {1.0f, 0.5f, 0.0f});
    EXPECT_NEAR(glm::length(posed - glm::vec3(1.0f, 3.0f, 1.0f)), 0.0f, 1e-6f);
}

TEST(Cascade, RejectsWhatIsNoPose) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_NE(Cascade::create({.stages = 0}, {}).error().find("stages"), std::string::npos);
    EXPECT_NE(Cascade::create({.stages = 65}, {}).error().find("stages"), std::string::npos);
    for (const double lag : {0.0, -1.0, 100.0, nan})
        EXPECT_NE(Cascade::create({.lag = lag}, {}).error().find("lag"), std::string::npos);
    Cascade cascade = cascade_of({}, {});
    EXPECT_NE(cascade.advance(0.1, {.position = {nan, 0.0, 0.0}}).error().find("position"), std::string::npos);
    EXPECT_NE(cascade.advance(0.1, {.rotation = {0.0, 0.0, 0.0, 0.0}}).error().find("rotation"), std::string::npos);
    EXPECT_NE(cascade.advance(0.1, {.scale = 0.0}).error().find("scale"), std::string::npos);
    EXPECT_FALSE(cascade.advance(-0.1, {}));
    EXPECT_FALSE(cascade.advance(nan, {}));
    EXPECT_FALSE(cascade.reset({.scale = nan}));
    EXPECT_FALSE(cascade.move({nan, 0.0, 0.0}));
    EXPECT_EQ(cascade.at(1.0).position, glm::dvec3(0.0)); // nothing has changed
    EXPECT_EQ(cascade.at(nan).position, glm::dvec3(0.0));
}

} // namespace
} // namespace windrow
