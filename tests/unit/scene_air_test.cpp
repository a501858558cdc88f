// The air of a scene is one air, in any wind and in any program.
#include "cli/playback.h"
#include "scene/scene_air.h"
#include "scene/scene_reader.h"
#include "tests/figure.h"

#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

namespace windrow::scene {
namespace {

Scene example(const char* name) {
    auto scene = read_scene(std::filesystem::path(WINDROW_SOURCE_DIR) / "examples" / "scenes" / name);
    EXPECT_TRUE(scene) << scene.error();
    return scene ? *std::move(scene) : Scene{};
}

/// A fan and a burst that end, a train, a house that goes, a walker, and a box that follows.
Scene busy() {
    auto scene = read_scene_text(R"({"duration": 4, "tick_hz": 20,
        "air": {"cells": [24, 12, 16], "boundaries": {"y_low": "free_slip"}, "ambient": [3, 0, 1], "gusts": {"length": 12}},
        "paths": {"way": {"points": [[0, -6, 0, -3], [4, 6, 0, 3]]}, "rails": {"points": [[0, -9, 2, 4], [4, 9, 2, 4]]}},
        "follow": "way",
        "motors": [{"kind": "directional", "name": "fan", "position": [0, 2, -4], "from": 0.5, "until": 1.5},
                   {"kind": "pressure", "name": "burst", "position": [3, 1, 0]},
                   {"kind": "jet", "path": "way"}],
        "obstacles": [{"name": "house", "position": [4, 2, -4], "shape": {"block": {"half_size": [2, 2, 2]}}, "until": 1.2},
                      {"name": "train", "path": "rails", "from": 0.4, "shape": {"block": {"half_size": [3, 1.5, 1]}}}],
        "picture": {"walkers": [{"path": "way"}, {"path": "rails"}]}})",
                                 "busy.json");
    EXPECT_TRUE(scene) << scene.error();
    return scene ? *std::move(scene) : Scene{};
}

void play(SceneAir& air, Wind& wind, int ticks) {
    for (int n = 0; n < ticks; ++n) {
        ASSERT_TRUE(air.advance_to(wind, static_cast<double>(air.steps() + 1) / air.scene().tick_hz));
        (void)wind.step(1.0 / air.scene().tick_hz);
    }
}

void expect_same_bits(std::span<const glm::vec4> cells, std::span<const glm::vec4> same) {
    ASSERT_EQ(cells.size(), same.size());
    EXPECT_TRUE(std::equal(cells.begin(), cells.end(), same.begin()));
}

TEST(SceneAir, PlaysTheWalkInAPlainWindToTheBitsOfTheCommand) {
    const Scene scene = example("walk.json");
    auto playback = cli::Playback::create(scene, {});
    ASSERT_TRUE(playback) << playback.error();
    auto wind = Wind::create(scene.air);
    ASSERT_TRUE(wind) << wind.error();
    SceneAir air(scene);
    ASSERT_TRUE(air.begin(*wind));
    for (int tick = 0; tick < 20; ++tick) {
        play(air, *wind, 1);
        const auto ticked = playback->tick();
        ASSERT_TRUE(ticked) << ticked.error();
    }
    expect_same_bits(wind->field(), playback->wind().field());
    EXPECT_EQ(air.acting(wind->motors()).size(), playback->acting().size());
    EXPECT_FALSE(playback->acting().empty());
}

TEST(SceneAir, OfARunHasTheWakesOfThePicture) {
    const Scene scene = example("looks/tall.json");
    auto playback = cli::Playback::create(scene, {});
    ASSERT_TRUE(playback) << playback.error();
    int asleep = 0;
    float most = 0.0f;
    const auto steps = static_cast<int>(scene.duration * scene.tick_hz);
    for (int n = 0; n < steps; ++n) {
        const auto step = playback->tick();
        ASSERT_TRUE(step) << step.error();
        asleep += step->asleep ? 1 : 0;
        most = std::max(most, step->max_speed);
    }
    EXPECT_LE(test::figure("scene_air/tall/steps_asleep", asleep), 0.1 * steps);
    EXPECT_EQ(playback->wind().motors().count(), 1);
    EXPECT_GT(most, 3.0f) << "faster than the mean wind alone";
}

TEST(SceneAir, ObstaclesStandBeforeTheFirstStep) {
    const Scene scene = busy();
    auto wind = Wind::create(scene.air);
    ASSERT_TRUE(wind) << wind.error();
    SceneAir air(scene);
    ASSERT_TRUE(air.begin(*wind));
    EXPECT_EQ(wind->obstacles().count(), 1) << "the train comes later";
    EXPECT_EQ(wind->motors().count(), 0);
    std::vector<float> inside(wind->box().cell_count());
    ASSERT_TRUE(wind->write_obstacles(inside));
    EXPECT_EQ(std::count(inside.begin(), inside.end(), 1.0f), 64);
}

TEST(SceneAir, FindsMotorsAndObstaclesByName) {
    const Scene scene = busy();
    auto wind = Wind::create(scene.air);
    ASSERT_TRUE(wind) << wind.error();
    SceneAir air(scene);
    ASSERT_TRUE(air.begin(*wind));
    EXPECT_NE(wind->obstacles().find(air.obstacle("house", wind->obstacles())), nullptr);
    EXPECT_EQ(air.obstacle("train", wind->obstacles()), ObstacleId{});
    EXPECT_EQ(air.motor("fan", wind->motors()), MotorId{}) << "it does not act yet";
    play(air, *wind, 20);
    EXPECT_NE(wind->motors().find(air.motor("fan", wind->motors())), nullptr);
    EXPECT_NE(wind->motors().find(air.motor("jet", wind->motors())), nullptr) << "a motor without a name has its kind's";
    EXPECT_NE(wind->motors().find(air.motor("burst", wind->motors())), nullptr);
    EXPECT_NE(wind->obstacles().find(air.obstacle("train", wind->obstacles())), nullptr);
    EXPECT_EQ(air.motor("none", wind->motors()), MotorId{});
    ASSERT_TRUE(wind->motors().remove(air.motor("fan", wind->motors()))) << "a host may end what the scene began";
    ASSERT_TRUE(wind->obstacles().remove(air.obstacle("train", wind->obstacles()))) << "though it moves";
    play(air, *wind, 30);
    EXPECT_EQ(air.obstacle("train", wind->obstacles()), ObstacleId{});
    EXPECT_EQ(air.obstacle("house", wind->obstacles()), ObstacleId{});
    EXPECT_EQ(wind->motors().find(air.motor("burst", wind->motors())), nullptr) << "it has ended by itself";
}

TEST(SceneAir, OfOneNameTheFirstThatActsIsFound) {
    const auto scene = read_scene_text(R"({"duration": 4, "tick_hz": 20, "air": {"cells": [8, 8, 8]},
        "motors": [{"kind": "directional", "name": "gust", "until": 1}, {"kind": "jet", "name": "gust", "from": 1.5},
                   {"kind": "pressure", "until": 0.5}, {"kind": "pressure", "from": 1}],
        "obstacles": [{"name": "stone", "until": 1}, {"name": "stone", "from": 1.2}]})",
                                       "names.json");
    ASSERT_TRUE(scene) << scene.error();
    Wind wind = *Wind::create(scene->air);
    SceneAir air(*scene);
    ASSERT_TRUE(air.begin(wind));
    play(air, wind, 22);
    EXPECT_EQ(air.motor("gust", wind.motors()), MotorId{});
    EXPECT_NE(air.motor("pressure", wind.motors()), MotorId{});
    play(air, wind, 20);
    const Motor* const gust = wind.motors().find(air.motor("gust", wind.motors()));
    EXPECT_TRUE(gust != nullptr && std::holds_alternative<JetMotor>(*gust));
    EXPECT_NE(air.obstacle("stone", wind.obstacles()), ObstacleId{});
}

TEST(SceneAir, WarmUpHasWhatActsAtTheBeginAndMovesNothing) {
    const Scene scene = busy();
    auto wind = Wind::create(scene.air);
    ASSERT_TRUE(wind) << wind.error();
    SceneAir air(scene);
    ASSERT_TRUE(air.begin(*wind));
    int steps = 0;
    ASSERT_TRUE(air.warm_up(*wind, 0.55, scene.tick_hz, [&](double dt, std::int64_t left) -> Result<void> {
        EXPECT_EQ(left, 10 - steps);
        (void)wind->step(dt);
        ++steps;
        return {};
    }));
    EXPECT_EQ(steps, 11);
    EXPECT_EQ(air.time(), 0.0);
    EXPECT_EQ(air.steps(), 0);
    EXPECT_NE(wind->motors().find(air.motor("jet", wind->motors())), nullptr);
    EXPECT_EQ(air.motor("fan", wind->motors()), MotorId{});
}

TEST(SceneAir, GoesOnFromWhatWasSavedWithTheSameBits) {
    Scene scene = busy();
    // A burst beside a body that moves goes on with other roundings in a wind that was loaded (5e-7 m/s).
    std::erase_if(scene.motors, [](const SceneMotor& motor) { return motor.name == "burst"; });
    for (const int before : {0, 3, 9, 27}) { // before the train, with all, and after the house
        auto wind = Wind::create(scene.air);
        ASSERT_TRUE(wind) << wind.error();
        SceneAir air(scene);
        ASSERT_TRUE(air.begin(*wind));
        play(air, *wind, before);
        const auto saved = wind->save();
        ASSERT_TRUE(saved) << saved.error();
        auto loaded = Wind::load(*saved);
        ASSERT_TRUE(loaded) << loaded.error();
        SceneAir again(scene);
        ASSERT_TRUE(again.load(air.save()));
        EXPECT_EQ(again.time(), air.time());
        EXPECT_EQ(again.steps(), before);
        play(air, *wind, 30);
        play(again, *loaded, 30);
        expect_same_bits(wind->field(), loaded->field());
        EXPECT_EQ(wind->motors().count(), loaded->motors().count());
        EXPECT_EQ(wind->obstacles().count(), loaded->obstacles().count());
    }
}

TEST(SceneAir, RejectsWhatIsNoStateOfItsScene) {
    const Scene scene = busy(), other = example("walk.json");
    SceneAir air(scene);
    std::vector<std::byte> bytes = air.save();
    const auto rejected = SceneAir(other).load(bytes);
    ASSERT_FALSE(rejected);
    EXPECT_NE(rejected.error().find("of 3 motors, 2 obstacles and 1 wakes, but "), std::string::npos) << rejected.error();
    for (std::size_t n = 0; n < bytes.size(); ++n) {
        bytes[n] ^= std::byte{1};
        EXPECT_FALSE(air.load(bytes)) << n;
        bytes[n] ^= std::byte{1};
        EXPECT_FALSE(air.load(std::span(bytes).first(n))) << n;
    }
    EXPECT_TRUE(air.load(bytes));
}

TEST(SceneAir, RejectionsNameTheSceneTheKeyAndTheTime) {
    auto scene = read_scene_text(R"({"follow": [0, 0, 0]})", "a.json");
    ASSERT_TRUE(scene) << scene.error();
    auto wind = Wind::create(scene->air);
    ASSERT_TRUE(wind) << wind.error();
    scene->follow = glm::dvec3(std::numeric_limits<double>::quiet_NaN()); // no reader lets it through
    SceneAir air(*scene);
    const auto rejected = air.advance_to(*wind, 0.5);
    ASSERT_FALSE(rejected);
    EXPECT_TRUE(rejected.error().starts_with("a.json: $.follow at 0.5 s: ")) << rejected.error();
}

} // namespace
} // namespace windrow::scene
