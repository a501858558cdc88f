// Recovery of the ground: a trail fades exponentially without an abrupt end, plants swing back, alike at any frame rate.
#include "coupling/ground_fading.h"
#include "coupling/ground_memory.h"
#include "coupling/ground_state.h"
#include "coupling/motion_numerics.h"
#include "tests/figure.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace windrow {
namespace {

const glm::dvec3 k_place(0.125, 0.0, 0.375); // a texel's centre, beside the walker

GroundMemory trodden(const GroundConfig& config) {
    auto made = GroundMemory::create(config);
    EXPECT_TRUE(made) << (made ? "" : made.error());
    const GroundWalker walker{.radius = 1.0f};
    EXPECT_TRUE(made->advance({.duration = 0.1, .walkers = std::span(&walker, 1)}));
    return *std::move(made);
}

void recover(GroundMemory& ground, double duration, glm::vec2 lean = {0.0f, 0.0f}) {
    const auto done = ground.advance({.duration = duration, .wind_lean = lean});
    ASSERT_TRUE(done) << done.error();
}

TEST(GroundRecovery, TrailFadesByItsTimeConstantAndHasNoEnd) {
    for (const int rate : {15, 60, 1000}) {
        const float tau = rate == 1000 ? 2.0f : 20.0f; // fewer frames of 1 ms
        GroundMemory ground = trodden({.texels = 16, .trail_time = tau, .blend_width = 0.5f});
        const double first = static_cast<double>(ground.at(k_place).trail);
        ASSERT_GT(first, 0.1);
        // Least squares of log(trail) over ten time constants, to 1/22000 of where it began.
        double n = 0.0, t_sum = 0.0, y_sum = 0.0, tt = 0.0, ty = 0.0, largest_drop = 0.0, before = first;
        for (int frame = 1; frame <= static_cast<int>(10.0f * tau) * rate; ++frame) {
            recover(ground, 1.0 / rate);
            const double trail = static_cast<double>(ground.at(k_place).trail), time = static_cast<double>(frame) / rate;
            largest_drop = std::max(largest_drop, (before - trail) / before);
            EXPECT_LE(trail, before);
            before = trail;
            const double y = std::log(trail);
            n += 1.0;
            t_sum += time;
            y_sum += y;
            tt += time * time;
            ty += time * y;
        }
        const double found = -(n * tt - t_sum * t_sum) / (n * ty - t_sum * y_sum);
        const std::string name = "ground/trail/" + std::to_string(rate) + "_hz";
        WINDROW_EXPECT_FIGURE(name + "/time_constant_off", std::abs(found / static_cast<double>(tau) - 1.0), 0.02);
        // No frame falls by more than an exponential does: no abrupt end.
        const double fair = -std::expm1(-1.0 / rate / static_cast<double>(tau));
        WINDROW_EXPECT_FIGURE(name + "/largest_fall_over_fair", largest_drop / fair, 1.01);
    }
}

// After twenty minutes the fading has long passed what can be seen, by nine digits and more, and is 0, not a denormal number for
// ever.
TEST(GroundRecovery, NothingIsLeftInTheEnd) {
    GroundMemory ground = trodden({.texels = 8, .blend_width = 0.3f});
    int lasted = 0;
    for (int frame = 0; frame < 72000; ++frame) {
        recover(ground, 1.0 / 60.0);
        lasted += ground.at(k_place).trail > 0.0f ? 1 : 0;
    }
    for (const numerics::WindrowGround& texel : detail::GroundState::of(ground)) {
        ASSERT_EQ(texel.lean, glm::vec2(0.0f));
        ASSERT_EQ(texel.velocity, glm::vec2(0.0f));
        ASSERT_EQ(texel.trail, glm::vec2(0.0f));
        ASSERT_EQ(texel.trample, 0.0f);
    }
    EXPECT_GT(test::figure("ground/trail/lasted_s", lasted / 60.0), 20.0 * std::log(1e9));
}

// Where nobody has walked, the window's move does not touch what fades: as WindowShiftsChangeNoBit, for the slow part over a
// minute.
TEST(GroundRecovery, TrailOutlivesShiftsOfTheWindow) {
    GroundMemory stays = trodden({.texels = 64}), wanders = trodden({.texels = 64});
    std::mt19937 random(4);
    std::uniform_real_distribution<double> place(-4.0, 4.0);
    for (int frame = 0; frame < 1000; ++frame) {
        recover(stays, 0.06);
        ASSERT_TRUE(wanders.follow({place(random), 0.0, place(random)}));
        recover(wanders, 0.06);
        ASSERT_EQ(stays.at(k_place).trail, wanders.at(k_place).trail) << frame;
        ASSERT_EQ(stays.at(k_place).lean, wanders.at(k_place).lean) << frame;
    }
    EXPECT_GT(stays.at(k_place).trail, 0.01f);
}

// Released, plants swing about the trail with the period of their class, and come to rest on it.
TEST(GroundRecovery, ReleasedPlantsSwingAtTheirFrequency) {
    const GroundConfig config{.texels = 16, .spring = {2.0, 0.1}, .trail_time = 1e5f, .blend_width = 0.5f};
    GroundMemory ground = trodden(config);
    // The walker stood at 0; the trail points away from it.
    const float rest = ground.at(k_place).trail * static_cast<float>(k_place.z / glm::length(k_place));
    std::vector<double> crossings;
    double before = static_cast<double>(ground.at(k_place).lean.y - rest);
    for (int frame = 1; frame <= 2400; ++frame) {
        recover(ground, 1.0 / 240.0);
        const double now = static_cast<double>(ground.at(k_place).lean.y - rest);
        if (frame < 480 && before > 0.0 && now <= 0.0)
            crossings.push_back((frame - now / (now - before)) / 240.0);
        before = now;
    }
    ASSERT_GE(crossings.size(), 3u);
    const double period = crossings[2] - crossings[1], expected = 0.5 / std::sqrt(1.0 - 0.01);
    WINDROW_EXPECT_FIGURE("ground/release/period_off", std::abs(period / expected - 1.0), 0.01);
    WINDROW_EXPECT_FIGURE("ground/release/off_the_trail", std::abs(before), 1e-3);
}

// Trampled plants do not follow the wind; as they rise they do.
TEST(GroundRecovery, PressedPlantsDoNotFollowTheWind) {
    auto made = GroundMemory::create({.texels = 16, .trail_fraction = 0.0f, .blend_width = 0.5f});
    ASSERT_TRUE(made);
    const GroundWalker walker{.position = {0.125, 0.0, 0.125}, .previous = {0.125, 0.0, 0.125}, .radius = 1.0f};
    const glm::dvec3 right_under(0.125, 0.0, 0.125);
    for (int frame = 0; frame < 240; ++frame)
        ASSERT_TRUE(made->advance({.duration = 1.0 / 60.0, .walkers = std::span(&walker, 1), .wind_lean = {0.5f, 0.0f}}));
    EXPECT_LT(made->at(right_under).lean.x, 0.02f);
    for (int frame = 0; frame < 600; ++frame)
        ASSERT_TRUE(made->advance({.duration = 1.0 / 60.0, .wind_lean = {0.5f, 0.0f}}));
    EXPECT_NEAR(made->at(right_under).lean.x, 0.5f, 1e-3f);
}

// How far a released texel's lean strays from its equation at the frames of 2 s; the equation by Runge and Kutta's fourth order
// in double, from the same state. A wind that turns to and fro, linear between the frames of 5 Hz.
double released_off(int rate, float trample_time) {
    auto made = GroundMemory::create({.texels = 16, .trample_time = trample_time, .blend_width = 0.5f});
    EXPECT_TRUE(made);
    const GroundWalker walker{.radius = 1.0f};
    EXPECT_TRUE(made->advance({.duration = 0.1, .walkers = std::span(&walker, 1), .wind_lean = {0.5f, 0.0f}}));
    const auto slot = [&] {
        for (int j = 0; j < 16; ++j)
            for (int i = 0; i < 16; ++i)
                if (glm::length(made->next_centre({i, j}) - glm::dvec2(k_place.x, k_place.z)) < 1e-6)
                    return static_cast<std::size_t>(16 * j + i);
        return std::size_t{0};
    }();
    const numerics::WindrowGround start = detail::GroundState::of(*made)[slot];
    const auto wind = [](double time) {
        const double knot = std::floor(time * 5.0 + 1e-9), share = time * 5.0 - knot;
        const double from = 0.5 * std::cos(1.1 * knot), to = 0.5 * std::cos(1.1 * (knot + 1.0));
        return from + share * (to - from);
    };
    const SpringClass spring = made->config().spring;
    const double omega = 2.0 * std::numbers::pi * spring.frequency_hz;
    glm::dvec2 state(start.lean.x, start.velocity.x); // lean, its velocity
    const auto slope = [&](double time, glm::dvec2 s) {
        const double pressed = static_cast<double>(start.trample) * std::exp(-time / static_cast<double>(trample_time));
        const double trail =
            static_cast<double>(start.trail.x) * std::exp(-time / static_cast<double>(made->config().trail_time));
        const double target = (1.0 - pressed) * wind(time) + trail;
        return glm::dvec2(s.y, -2.0 * spring.damping * omega * s.y - omega * omega * (s.x - target));
    };
    double off = 0.0, time = 0.0;
    for (int frame = 1; frame <= 2 * rate; ++frame) {
        const int parts = 3600 / rate; // of which none reaches beyond a knot of the wind
        const double h = 1.0 / rate / parts;
        for (int part = 0; part < parts; ++part) {
            time = static_cast<double>(frame - 1) / rate + part * h;
            const double last = time + h - 1e-12; // the wind's slope before a knot, not after it
            const glm::dvec2 a = slope(time, state), b = slope(time + 0.5 * h, state + 0.5 * h * a),
                             c = slope(time + 0.5 * h, state + 0.5 * h * b), d = slope(last, state + h * c);
            state += h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
        }
        recover(*made, 1.0 / rate, {wind(static_cast<double>(frame) / rate), 0.0f});
        off = std::max(off, std::abs(static_cast<double>(detail::GroundState::of(*made)[slot].lean.x) - state.x));
    }
    return off;
}

// Who was pressed rises again alike at any frame rate. Bound: a float's rounding, as that of the wind alone at these rates.
TEST(GroundRecovery, ReleasedPlantsRiseAlikeAtAnyFrameRate) {
    for (const float trample_time : {0.8f, 0.1f})
        for (const int rate : {5, 15, 30, 60, 240}) {
            const std::string name = "ground/release/" + std::string(trample_time > 0.5f ? "trample_0.8_s/" : "trample_0.1_s/") +
                                     std::to_string(rate) + "_hz";
            WINDROW_EXPECT_FIGURE(name, released_off(rate, trample_time), 1e-6);
        }
}

// At the ends of what springs, times and steps may be: nothing is added where no time passes, plants that follow at once follow
// what fades, and after long all has faded.
TEST(GroundRecovery, FadingIsFollowedAtAnySetting) {
    double over = 0.0, held = 0.0, left = 0.0;
    for (const double hz : {1e-4, 3.5, 1000.0})
        for (const double damping : {0.0, 0.2, 1.0, 1000.0})
            for (const double time : {0.01, 20.0, 1e6})
                for (const double duration : {0.0, 1e-9, 1e-3, 0.1, 1e3, 1e8, 1e300}) {
                    const SpringClass spring{hz, damping};
                    const auto constant = detail::fading_response(spring, duration, time);
                    const auto ramp = detail::fading_ramp_response(spring, duration, time);
                    for (const detail::FadingResponse& each : {constant, ramp}) {
                        EXPECT_TRUE(std::isfinite(each.place) && std::isfinite(each.velocity));
                        // Of a target from 0 to -1 a spring goes as far again at most, where nothing damps it.
                        over = std::max({over, each.place, -2.0 - each.place});
                        if (duration == 0.0)
                            held = std::max({held, std::abs(each.place), std::abs(each.velocity)});
                    }
                    if (damping > 0.0 && duration > 1e9)
                        left = std::max({left, std::abs(constant.place + 1.0), std::abs(ramp.place + 1.0)});
                }
    WINDROW_EXPECT_FIGURE("ground/fading/beyond_its_target", over, 1e-6);
    WINDROW_EXPECT_FIGURE("ground/fading/in_no_time", held, 0.0);
    WINDROW_EXPECT_FIGURE("ground/fading/left_after_long", left, 1e-2); // a ramp of 1e9 s is followed late by up to 3e6 s
}

// Wind that turns and swells, linear over each second, at five frame rates. Bound: a float's rounding in a thousand steps a
// second, a fiftieth of what a half-float texture can show of it.
TEST(GroundRecovery, WindMovesTheGroundAlikeAtAnyFrameRate) {
    const auto history = [](int rate) {
        auto made = GroundMemory::create({.texels = 8, .blend_width = 0.4f});
        EXPECT_TRUE(made);
        std::vector<glm::vec2> found;
        recover(*made, 0.0);
        for (int frame = 1; frame <= 6 * rate; ++frame) {
            const int second = (frame - 1) / rate;
            const auto lean = [](int s) {
                return glm::vec2(0.6f * std::sin(2.1f * static_cast<float>(s)), 0.3f * static_cast<float>(s % 3));
            };
            const float share = static_cast<float>(frame - second * rate) / static_cast<float>(rate);
            recover(*made, 1.0 / rate, lean(second) + share * (lean(second + 1) - lean(second)));
            if (frame % rate == 0)
                found.push_back(made->at({0.0, 0.0, 0.0}).lean);
        }
        return found;
    };
    const auto truth = history(1);
    double worst = 0.0;
    for (const int rate : {15, 30, 60, 144, 1000}) {
        const auto found = history(rate);
        for (std::size_t n = 0; n < truth.size(); ++n)
            worst = std::max(worst, static_cast<double>(glm::length(found[n] - truth[n])));
    }
    WINDROW_EXPECT_FIGURE("ground/wind_at_any_rate", worst, 1e-5);
}

// A lean of the wind for each texel, in slots.
TEST(GroundRecovery, EachTexelFollowsItsOwnWind) {
    auto made = GroundMemory::create({.texels = 32, .blend_width = 1.0f});
    ASSERT_TRUE(made);
    ASSERT_TRUE(made->follow({3.3, 0.0, -7.1}));
    std::vector<glm::vec2> leans(32 * 32);
    for (int j = 0; j < 32; ++j)
        for (int i = 0; i < 32; ++i)
            leans[static_cast<std::size_t>(32 * j + i)] = glm::vec2(made->next_centre({i, j}) - glm::dvec2(3.3, -7.1)) * 0.1f;
    for (int frame = 0; frame < 100; ++frame)
        ASSERT_TRUE(made->advance({.duration = 0.1}, leans));
    double worst = 0.0;
    for (double z = -2.0; z < 2.0; z += 0.3)
        for (double x = -2.0; x < 2.0; x += 0.3)
            worst = std::max(
                worst, static_cast<double>(glm::length(made->at({3.3 + x, 0.0, -7.1 + z}).lean - glm::vec2(0.1 * x, 0.1 * z))));
    WINDROW_EXPECT_FIGURE("ground/own_wind", worst, 1e-6);
}

// What a host's wind gives where it breaks is no wind, and is forgotten in the next step.
TEST(GroundRecovery, ABrokenWindIsNone) {
    auto made = GroundMemory::create({.texels = 16, .blend_width = 0.5f});
    ASSERT_TRUE(made);
    const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
    std::vector<glm::vec2> leans(16 * 16, glm::vec2(0.2f, 0.0f));
    leans[5] = {nan, 0.1f};
    leans[77] = {infinity, -infinity};
    leans[200] = {3e38f, 0.0f};
    for (int frame = 0; frame < 600; ++frame)
        ASSERT_TRUE(made->advance({.duration = 0.02}, leans));
    for (std::size_t n = 0; n < leans.size(); ++n) {
        const glm::vec2 lean = detail::GroundState::of(*made)[n].lean;
        const bool broken = n == 5 || n == 77 || n == 200;
        EXPECT_NEAR(lean.x, broken ? 0.0f : 0.2f, 1e-5f) << n;
        EXPECT_NEAR(lean.y, n == 5 ? 0.1f : 0.0f, 1e-5f) << n;
    }
}

// The last frame's sample is what the last frame showed, and over its time the difference is the velocity, to the second order.
TEST(GroundRecovery, PreviousIsTheLastFrameAndTheirDifferenceTheVelocity) {
    double errors[2];
    for (int k = 0; k < 2; ++k) {
        const double h = 0.01 / (1 << k);
        GroundMemory ground = trodden({});
        const int n = ground.config().texels;
        // The slot of k_place: texel (0, 1) of the world.
        const auto texel = [&] { return detail::GroundState::of(ground)[static_cast<std::size_t>(n + 0)]; };
        errors[k] = 0.0;
        for (int frame = 0; frame * h < 0.5; ++frame) {
            const GroundSample last = ground.at(k_place);
            const glm::vec2 velocity = texel().velocity;
            recover(ground, h);
            ASSERT_EQ(ground.previous_at(k_place).lean, last.lean);
            ASSERT_EQ(ground.previous_at(k_place).trail, last.trail);
            const glm::dvec2 moved = glm::dvec2(ground.at(k_place).lean) - glm::dvec2(ground.previous_at(k_place).lean);
            const glm::dvec2 mean = 0.5 * (glm::dvec2(velocity) + glm::dvec2(texel().velocity));
            errors[k] = std::max(errors[k], glm::length(moved / h - mean));
        }
    }
    test::figure("ground/motion_vector_error", errors[1]);
    EXPECT_NEAR(test::figure("ground/motion_vector_slope", std::log2(errors[0] / errors[1])), 2.0, 0.15);
}

} // namespace
} // namespace windrow
