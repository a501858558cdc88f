// What a picture moves carries the air along, unasked: how much, where, and where not; and its hills stand in the air.
#include "fluid/core/numerics.h"
#include "fluid/wind.h"
#include "scene/scene_air.h"
#include "scene/scene_reader.h"
#include "tests/figure.h"
#include "tests/own_folder.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <string>

namespace windrow::scene {
namespace {

constexpr double k_speed = 3.0; // [m/s] along x, from -4 to 5 m in 3 s

Result<Scene> read(const std::string& picture, const std::string& air = "", const std::filesystem::path& file = "a.json") {
    return read_scene_text(
        R"({"tick_hz": 60, "air": {"cells": [48, 16, 24], "cell_size": 0.25, "boundaries": {"y_low": "free_slip"},
        "centre": [0, 2, 0]}, "paths": {"way": {"points": [[0, -4, 7, 0], [3, 5, 7, 0]]}, "bench": {"points": [[0, 1, 0, 1]]}})" +
            air + R"(, "picture": {"ground_memory": {}, )" + picture + "}}",
        file);
}

std::size_t wakes_of(const std::string& picture, const std::string& air = "") {
    const auto scene = read(picture, air);
    EXPECT_TRUE(scene) << scene.error();
    return scene ? scene->carried.size() : 0;
}

/// The scene's air after `seconds`.
Wind blown(const Scene& scene, double seconds) {
    auto wind = Wind::create(scene.air);
    EXPECT_TRUE(wind) << wind.error();
    SceneAir air(scene);
    EXPECT_TRUE(air.begin(*wind));
    const double tick = 1.0 / scene.tick_hz;
    for (int n = 0; (n + 0.5) * tick < seconds; ++n) {
        EXPECT_TRUE(air.advance_to(*wind, (n + 1) * tick));
        wind->step(tick);
    }
    return *std::move(wind);
}

TEST(SceneWakes, MotorLeavesTheMomentumOfABluffBody) {
    for (const float cell : {0.1f, 0.4f, 0.75f}) { // the last two are wider than the body
        const WakeMotor motor = wake_of({0.5f, 1.75f}, cell);
        EXPECT_EQ(numerics::windrow_widened(motor.radius, cell), motor.radius) << "no wider in the air than here";
        const double pull = std::get<WakeDrive>(motor.law).per_metre;
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

TEST(SceneWakes, AirBehindAWalkerFollowsIt) {
    const auto scene = read(R"("walkers": [{"path": "way"}])");
    ASSERT_TRUE(scene) << scene.error();
    const auto wind = blown(*scene, 2.0); // at x = 2; the path is 7 m up, the walker on the ground
    const auto along = [&](double x, double y, double z) { return static_cast<double>(wind.velocity({x, y, z}).x) / k_speed; };
    // On the axis 1 - exp(-4.17) of the speed is drawn along, and parallel flow keeps it; cells of half the radius smooth it.
    EXPECT_GT(test::figure("body_wakes/behind_over_speed", along(1.2, 0.9, 0.0)), 0.5);
    EXPECT_LT(std::abs(test::figure("body_wakes/beside_over_speed", along(1.2, 0.9, 2.2))), 0.1);
    EXPECT_LT(std::abs(test::figure("body_wakes/above_over_speed", along(1.2, 3.4, 0.0))), 0.1);
    EXPECT_LT(std::abs(test::figure("body_wakes/ahead_over_speed", along(4.5, 0.9, 0.0))), 0.1);
}

TEST(SceneWakes, AirBehindAFurredBodyFollowsItAndFalseMeansStillAir) {
    for (const bool wake : {true, false}) {
        const auto scene = read(
            R"("bodies": [{"mesh": {"globe_sphere": {}}, "place": {"position": [0, -6.4, 0]}, "coats": [{}], "motion": {"path": "way", "wake": )" +
            std::string(wake ? "true" : "false") + "}}]");
        ASSERT_TRUE(scene) << scene.error();
        const auto wind = blown(*scene, 2.0);
        const double behind = static_cast<double>(wind.velocity({0.8, 0.6, 0.0}).x) / k_speed;
        EXPECT_EQ(wind.motors().count(), wake ? 1 : 0);
        if (wake)
            EXPECT_GT(test::figure("body_wakes/behind_body_over_speed", behind), 0.5);
        else
            EXPECT_EQ(behind, 0.0);
    }
}

TEST(SceneWakes, AirIsNotMovedTwice) {
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

TEST(SceneWakes, MeshGivesTheSizeOfAWakeOrASentenceSaysWhyThereIsNone) {
    const test::OwnFolder folder;
    std::ofstream(folder / "hound.obj") << "v -1 0 -4\nv 1 0 4\nv 0 3 0\nf 1 2 3\n";
    const auto body = [&](const std::string& mesh) {
        return read(R"("bodies": [{"name": "hound", "mesh": )" + mesh + R"(, "coats": [{}], "motion": {"path": "way"}}])", "",
                    folder / "a.json");
    };
    const auto scene = body(R"({"file": {"name": "hound.obj", "size": 1.6}})");
    ASSERT_TRUE(scene) << scene.error();
    ASSERT_EQ(scene->carried.size(), 1u);
    EXPECT_EQ(scene->carried[0].key, "$.picture.bodies[0]");
    EXPECT_NEAR(scene->carried[0].front.x, 0.4, 1e-6);
    EXPECT_NEAR(scene->carried[0].front.y, 0.6, 1e-6);
    EXPECT_NEAR(scene->carried[0].middle_at(scene->paths[scene->carried[0].path].path, 0.0).y, 7.3, 1e-6);
    EXPECT_TRUE(scene->warnings.empty());

    const auto turned = body(R"({"file": {"name": "hound.obj", "up": "z", "size_of": "height", "yaw_deg": 90}})");
    ASSERT_TRUE(turned) << turned.error();
    EXPECT_NEAR(turned->carried.at(0).front.x, 0.375, 1e-6) << "3 of 8 that became 1 m";
    EXPECT_NEAR(turned->carried.at(0).front.y, 1.0, 1e-6);

    for (const char* name : {"fox.glb", "none.obj"}) {
        const auto without = body(std::string(R"({"file": {"name": ")") + name + "\"}}");
        ASSERT_TRUE(without) << without.error();
        EXPECT_TRUE(without->carried.empty());
        ASSERT_EQ(without->warnings.size(), 1u);
        EXPECT_NE(without->warnings[0].find("a.json: $.picture.bodies[0], hound, has no wake, since its size is not known: "),
                  std::string::npos)
            << without->warnings[0];
    }
}

TEST(SceneWakes, HillsOfThePictureStandInTheAir) {
    const auto scene =
        read(R"("ground": {"in_air": true, "extent": [40, 40], "corner": [-20, 0, -20], "hills": {"height": 3, "length": 8}},
                              "walkers": [{"path": "way"}])");
    ASSERT_TRUE(scene) << scene.error();
    ASSERT_EQ(scene->obstacles.size(), 1u);
    EXPECT_EQ(scene->obstacles[0].name, "ground");
    const auto& hills = std::get<Ground>(scene->obstacles[0].obstacle.shape).heights;
    const glm::dvec3 middle = scene->carried.at(0).middle_at(scene->paths[1].path, 1.0);
    EXPECT_NEAR(middle.y, static_cast<double>(hills->drawn_height({19.0f, 20.0f})) + 0.875, 1e-5) << "feet are on the ground";
}

TEST(SceneWakes, FaultsOfWhatTheAirNeedsOfAPictureAreNamed) {
    const std::pair<const char*, const char*> bad[] = {
        {R"("walkers": [{}])", "a.json: $.picture.walkers[0] has no \"path\": add it."},
        {R"("walkers": [{"path": "wya"}])", "$.picture.walkers[0].path is \"wya\""},
        {R"("bodies": [{"motion": {"pth": 1}}])", "$.picture.bodies[0].motion.pth is not a known key"},
        {R"("ground": {"heights": "none.pgm"})", "$.picture.ground.heights is \"none.pgm\""},
        {R"("bodies": [{"mesh": {"cone": {}}, "coats": [{}], "motion": {"path": "way"}}])",
         "$.picture.bodies[0].mesh holds neither"}};
    for (const auto& [picture, sentence] : bad) {
        const auto scene = read(picture);
        ASSERT_FALSE(scene) << picture;
        EXPECT_NE(scene.error().find(sentence), std::string::npos) << scene.error();
    }
    EXPECT_TRUE(read(R"("grass": 3, "bodies": [{"coats": 1}])")) << "what the air does not need is a renderer's";
}

} // namespace
} // namespace windrow::scene
