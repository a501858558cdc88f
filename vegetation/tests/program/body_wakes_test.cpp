// Bodies that a picture moves carry the air along, unasked: how much, where, and where not.
#include "fluid/numerics.h"
#include "fluid/wind.h"
#include "scene/scene_motion.h"
#include "tests/figure.h"
#include "vegetation/program/body_wakes.h"
#include "vegetation/program/picture_reader.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <string>

namespace windrow::vegetation::program {
namespace {

constexpr double k_speed = 3.0; // [m/s] along x, from -4 to 5 m in 3 s

windrow::Result<PictureScene> read(const std::string& picture, const std::string& air = "") {
    return read_picture_scene_text(
        R"({"tick_hz": 60, "air": {"cells": [48, 16, 24], "cell_size": 0.25, "boundaries": {"y_low": "free_slip"},
        "centre": [0, 2, 0]}, "paths": {"way": {"points": [[0, -4, 7, 0], [3, 5, 7, 0]]}, "bench": {"points": [[0, 1, 0, 1]]}})" +
            air + R"(, "picture": {"ground_memory": {}, )" + picture + "}}",
        "a.json");
}

constexpr BodyBox k_hound{.low = {-0.25f, 0.0f, -0.8f}, .high = {0.25f, 1.2f, 0.8f}};

std::size_t wakes_of(const std::string& picture, const std::string& air = "") {
    const auto scene = read(picture, air);
    EXPECT_TRUE(scene) << scene.error();
    return BodyWakes(*scene, std::vector<BodyBox>(scene->picture.bodies.size(), k_hound)).count();
}

/// The scene's air after `seconds`.
windrow::Wind blown(const PictureScene& scene, BodyWakes& wakes, double seconds) {
    auto wind = windrow::Wind::create(scene.air.air);
    EXPECT_TRUE(wind) << wind.error();
    windrow::scene::SceneMotion motion(scene.air);
    EXPECT_TRUE(motion.begin(*wind));
    const double tick = 1.0 / scene.air.tick_hz;
    for (int n = 0; (n + 0.5) * tick < seconds; ++n) {
        EXPECT_TRUE(motion.place(*wind, n * tick, (n + 1) * tick));
        EXPECT_TRUE(wakes.place(wind->motors(), n * tick, (n + 1) * tick));
        wind->step(tick);
    }
    return *std::move(wind);
}

TEST(BodyWakes, MotorLeavesTheMomentumOfABluffBody) {
    for (const float cell : {0.1f, 0.4f, 0.75f}) { // the last two are wider than the body
        const windrow::WakeMotor motor = wake_of({0.5f, 1.75f}, cell);
        EXPECT_EQ(numerics::windrow_widened(motor.radius, cell), motor.radius) << "no wider in the air than here";
        const double pull = std::get<windrow::WakeDrive>(motor.law).per_metre;
        double momentum = 0.0; // over speed and metre of way
        constexpr int k_rings = 2000;
        for (int n = 0; n < k_rings; ++n) {
            const double r = (n + 0.5) / k_rings * static_cast<double>(motor.radius);
            const double way = numerics::windrow_wake_path({0.0f, static_cast<float>(r), 0.0f}, {-9.0f, 0.0f, 0.0f},
                                                           {9.0f, 0.0f, 0.0f}, motor.radius);
            momentum += (1.0 - std::exp(-pull * way)) * 2.0 * std::numbers::pi * r * static_cast<double>(motor.radius) / k_rings;
        }
        const double drag = 0.5 * 0.25 * std::numbers::pi * 0.5 * 1.75; // C A / 2 of an ellipse, C = 1
        WINDROW_EXPECT_FIGURE("body_wakes/momentum_off_at_" + std::to_string(cell).substr(0, 4), std::abs(momentum / drag - 1.0),
                              1e-3);
    }
}

TEST(BodyWakes, AirBehindAWalkerFollowsIt) {
    const auto scene = read(R"("walkers": [{"path": "way"}])");
    ASSERT_TRUE(scene) << scene.error();
    BodyWakes wakes(*scene, {});
    const auto wind = blown(*scene, wakes, 2.0); // at x = 2; the path is 7 m up, the walker on the ground
    const auto along = [&](double x, double y, double z) { return static_cast<double>(wind.velocity({x, y, z}).x) / k_speed; };
    // On the axis 1 - exp(-4.17) of the speed is drawn along, and parallel flow keeps it; cells of half the radius smooth it.
    EXPECT_GT(windrow::test::figure("body_wakes/behind_over_speed", along(1.2, 0.9, 0.0)), 0.5);
    EXPECT_LT(std::abs(windrow::test::figure("body_wakes/beside_over_speed", along(1.2, 0.9, 2.2))), 0.1);
    EXPECT_LT(std::abs(windrow::test::figure("body_wakes/above_over_speed", along(1.2, 3.4, 0.0))), 0.1);
    EXPECT_LT(std::abs(windrow::test::figure("body_wakes/ahead_over_speed", along(4.5, 0.9, 0.0))), 0.1);
}

TEST(BodyWakes, AirBehindADressedBodyFollowsItAndFalseMeansStillAir) {
    for (const bool wake : {true, false}) {
        const auto scene =
            read(R"("bodies": [{"place": {"position": [0, -7, 0]}, "coats": [{}], "motion": {"path": "way", "wake": )" +
                 std::string(wake ? "true" : "false") + "}}]");
        ASSERT_TRUE(scene) << scene.error();
        BodyWakes wakes(*scene, std::vector{k_hound});
        const auto wind = blown(*scene, wakes, 2.0);
        const double behind = static_cast<double>(wind.velocity({0.8, 0.6, 0.0}).x) / k_speed;
        EXPECT_EQ(wind.motors().count(), wake ? 1 : 0);
        if (wake)
            EXPECT_GT(windrow::test::figure("body_wakes/behind_body_over_speed", behind), 0.5);
        else
            EXPECT_EQ(behind, 0.0);
    }
}

TEST(BodyWakes, AirIsNotMovedTwice) {
    const std::string walker = R"("walkers": [{"path": "way"}])";
    EXPECT_EQ(wakes_of(walker), 1u);
    EXPECT_EQ(wakes_of(R"("walkers": [{"path": "way", "wake": false}])"), 0u);
    EXPECT_EQ(wakes_of(R"("walkers": [{"path": "way"}, {"path": "way", "figure": false}])"), 1u);
    EXPECT_EQ(wakes_of(R"("walkers": [{"path": "bench"}])"), 0u) << "who stands has no wake";
    EXPECT_EQ(wakes_of(walker, R"(, "motors": [{"kind": "wake", "path": "way"}])"), 0u);
    EXPECT_EQ(wakes_of(walker, R"(, "motors": [{"kind": "omni", "path": "way"}, {"kind": "wake", "path": "bench"}])"), 1u);
    EXPECT_EQ(wakes_of(walker, R"(, "obstacles": [{"path": "way"}])"), 0u);
    EXPECT_EQ(wakes_of(walker + R"(, "bodies": [{"coats": [{}], "motion": {"path": "way"}}])"), 1u);
    EXPECT_EQ(wakes_of(R"("bodies": [{"motion": {"path": "way"}}])"), 0u) << "a body without a coat is not there";
    EXPECT_EQ(wakes_of(R"("bodies": [{"coats": [{}]}])"), 0u);
}

} // namespace
} // namespace windrow::vegetation::program
