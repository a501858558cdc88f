// Flutter of leaves: threshold, independence of frame rate and time, independent phases.
#include "coupling/plant_numerics.h"
#include "coupling/spring.h"
#include "tests/fields.h"
#include "tests/figure.h"

#include <bit>
#include <cmath>
#include <complex>
#include <gtest/gtest.h>
#include <numbers>
#include <set>

namespace windrow {
namespace {

using numerics::WindrowFlutter;

WindrowFlutter frame(const FlutterClass& leaves, double time, double duration) {
    const auto made = flutter_step(leaves, time, duration);
    EXPECT_TRUE(made) << made.error();
    return std::bit_cast<WindrowFlutter>(*made);
}

float now(const WindrowFlutter& flutter, glm::uvec2 hash, float speed) {
    return numerics::windrow_flutter_angle(flutter, flutter.now, hash, speed);
}

// Supercritical bifurcation: 0 up to the onset, then the square root of the excess, bounded by the largest turn.
TEST(Flutter, BeginsAtItsOnsetAndDependsLittleOnTheWind) {
    const FlutterClass leaves{.most = 0.5f, .onset = 2.0f};
    const WindrowFlutter flutter = frame(leaves, 3.0, 0.01);
    EXPECT_EQ(numerics::windrow_flutter_growth(flutter, 0.0f), 0.0f);
    EXPECT_EQ(numerics::windrow_flutter_growth(flutter, 2.0f), 0.0f);
    EXPECT_EQ(numerics::windrow_flutter_growth(flutter, std::nanf("")), 0.0f);
    // Near the onset the square of the amplitude goes as the excess of speed: 1 - (U0 / U)^2 = 2 e - 3 e^2 + ...
    for (const double excess : {0.01, 0.02, 0.04}) {
        const auto growth =
            static_cast<double>(numerics::windrow_flutter_growth(flutter, static_cast<float>(2.0 * (1.0 + excess))));
        EXPECT_NEAR(growth * growth / (2.0 * excess), 1.0, 1.6 * excess) << excess;
    }
    double most = 0.0;
    for (std::uint32_t leaf = 0; leaf < 4000; ++leaf)
        most = std::max(most, static_cast<double>(std::abs(now(flutter, {leaf * 2654435761u, leaf}, 1000.0f))));
    EXPECT_LE(most, 0.5 + 1e-6);
    EXPECT_GT(most, 0.499);
    EXPECT_EQ(now(frame({.most = 0.0f}, 3.0, 0.01), {1u, 2u}, 9.0f), 0.0f);
}

// The phase is exact after a day, since it is computed in double. A float of 86,400 s has steps of 8 ms: 0.05 turns at 6 Hz.
TEST(Flutter, IsTheSameAtAnyFrameRateAndTime) {
    const FlutterClass leaves{.frequency_hz = 6.0, .most = 1.0f, .onset = 0.0f};
    const auto bands = *spring_bands({leaves.frequency_hz, 0.0});
    double apart = 0.0, before_apart = 0.0;
    for (const double start : {0.0, 86400.0})
        for (const double duration : {0.0, 1.0 / 144.0, 1.0 / 24.0, 0.2})
            for (std::uint32_t leaf = 0; leaf < 64; ++leaf) {
                const glm::uvec2 hash = numerics::windrow_plant_hash({leaf, 5u});
                const double time = start + 0.37 * leaf;
                const WindrowFlutter flutter = frame(leaves, time, duration);
                const double hz = bands[hash.y & 3u].frequency_hz,
                             phase = static_cast<double>(numerics::windrow_fraction(hash.x));
                const auto wanted = [&](double t) { return std::sin(2.0 * std::numbers::pi * (hz * t + phase)); };
                const double before = static_cast<double>(numerics::windrow_flutter_angle(flutter, flutter.before, hash, 5.0f));
                apart = std::max(apart, std::abs(static_cast<double>(now(flutter, hash, 5.0f)) - wanted(time)));
                before_apart = std::max(before_apart, std::abs(before - wanted(time - duration)));
            }
    WINDROW_EXPECT_FIGURE("plants/flutter/off_its_sine_after_a_day", apart, 4e-6); // two roundings of a turn: 2 pi 2^-23
    WINDROW_EXPECT_FIGURE("plants/flutter/a_frame_ago_off_its_sine", before_apart, 4e-6);
}

// Phases of leaves are independent: the mean of n of them is of order 1 / sqrt(n), at the first frame and later.
TEST(Flutter, EachLeafHasItsOwnTime) {
    constexpr int k_leaves = 4096;
    const FlutterClass leaves{.most = 1.0f, .onset = 0.0f};
    for (const double time : {0.0, 1.0, 100.0}) {
        const WindrowFlutter a = frame(leaves, time, 0.0), b = frame(leaves, time + 0.01, 0.0);
        double sum = 0.0, moving = 0.0;
        for (std::uint32_t leaf = 0; leaf < k_leaves; ++leaf) {
            const glm::uvec2 hash = numerics::windrow_plant_hash({leaf, 9u});
            sum += static_cast<double>(now(a, hash, 5.0f)) / k_leaves;
            moving += std::abs(static_cast<double>(now(b, hash, 5.0f) - now(a, hash, 5.0f))) / k_leaves;
        }
        EXPECT_LT(std::abs(sum), 4.0 / std::sqrt(2.0 * k_leaves)) << time;
        EXPECT_GT(moving, 0.1) << time; // 2 pi 6 Hz 0.01 s 2 / pi = 0.24 on the mean
    }
}

TEST(Flutter, TurnsALeafAboutItsAxis) {
    test::Random random(5);
    double length = 0.0, along = 0.0, angle_off = 0.0;
    for (int n = 0; n < 1000; ++n) {
        const numerics::WindrowPart leaf{glm::vec3(random.direction()), glm::vec3(random.direction()), 0.3f, 1.0f};
        const glm::vec3 at = leaf.root + 0.3f * glm::vec3(random.direction()), normal(random.direction());
        const float angle = random.uniform(-1.5f, 1.5f);
        const numerics::WindrowTreeVertex turned = numerics::windrow_leaf_turned(leaf, angle, {at, normal});
        const glm::dvec3 axis(leaf.axis), from = glm::dvec3(at) - glm::dvec3(leaf.root),
                                          to = glm::dvec3(turned.position) - glm::dvec3(leaf.root);
        length = std::max(length, std::abs(glm::length(to) - glm::length(from)));
        along = std::max(along, std::abs(glm::dot(to - from, axis)));
        const glm::dvec3 a = from - glm::dot(from, axis) * axis, b = to - glm::dot(to, axis) * axis;
        if (glm::length(a) > 0.05)
            angle_off = std::max(
                angle_off, std::abs(std::atan2(glm::dot(glm::cross(a, b), axis), glm::dot(a, b)) - static_cast<double>(angle)));
        ASSERT_NEAR(glm::length(turned.normal), 1.0f, 1e-6f);
        ASSERT_NEAR(glm::dot(turned.normal, leaf.axis), glm::dot(normal, leaf.axis), 1e-6f);
    }
    WINDROW_EXPECT_FIGURE("plants/flutter/length_changed_m", length, 5e-7);
    WINDROW_EXPECT_FIGURE("plants/flutter/moved_along_the_axis_m", along, 5e-7);
    WINDROW_EXPECT_FIGURE("plants/flutter/turned_by_another_angle_rad", angle_off, 1e-5);
}

TEST(Flutter, RejectsWhatIsNoFlutter) {
    for (const double wrong : {std::nan(""), HUGE_VAL})
        EXPECT_FALSE(flutter_step({}, wrong, 0.01)) << wrong;
    for (const double wrong : {-0.01, std::nan(""), HUGE_VAL})
        EXPECT_FALSE(flutter_step({}, 1.0, wrong)) << wrong;
    EXPECT_FALSE(flutter_step({.frequency_hz = 0.0}, 1.0, 0.01));
    EXPECT_FALSE(flutter_step({.most = 2.0f}, 1.0, 0.01));
    EXPECT_FALSE(flutter_step({.onset = -1.0f}, 1.0, 0.01));
}

} // namespace
} // namespace windrow
