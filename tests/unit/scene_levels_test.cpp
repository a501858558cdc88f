// A scene with winds around its box: what is read of them, what is in each, and that they go on from where they were saved.
#include "fluid/event_log.h"
#include "scene/scene_levels.h"
#include "scene/scene_reader.h"
#include "scene/scene_writer.h"
#include "tests/winds.h"

#include <optional>
#include <string>

namespace windrow::scene {
namespace {

Scene read(const std::string& air, const std::string& others = "") {
    auto scene =
        read_scene_text(R"({"air": {"cells": [12, 8, 12], "boundaries": {"y_low": "free_slip"}, "ambient": [5, 0, 0], )" + air +
                            "}" + others + "}",
                        "levels.json");
    EXPECT_TRUE(scene) << scene.error();
    return *std::move(scene);
}

constexpr const char* k_two = R"("outer": {"cells": [16, 6, 16], "cell_size": 2, "ticks": {"hz": 10},
    "outer": {"cells": [16, 4, 16], "cell_size": 6, "ticks": {"hz": 2}}})";
constexpr const char* k_things = R"(, "paths": {"walk": {"points": [[0, 0, 1, 0], [4, 8, 1, 0]]}}, "follow": "walk",
    "obstacles": [{"position": [-10, 2, 4], "shape": {"block": {"half_size": [3, 2.5, 2]}}},
                  {"position": [-3, 1, -2], "shape": {"cylinder": {"radius": 0.5, "half_length": 1}}}],
    "motors": [{"kind": "directional", "position": [-12, 3, -3], "region": {"sphere": {"radius": 4}}}],
    "drag": [{"plant": {"position": [4, 0, 5]}}])";

/// A scene with all its winds.
struct Played {
    explicit Played(const Scene& scene) : levels(*SceneLevels::create(scene, {})), air(SceneAir::within(scene)) {
        wind.emplace(*Wind::create(levels.inner_config(), levels.nearest()));
        EXPECT_TRUE(air.begin(*wind));
    }
    void tick(int number) {
        ASSERT_TRUE(levels.advance_to(number / 30.0));
        ASSERT_TRUE(air.advance_to(*wind, number / 30.0));
        (void)wind->step(1.0 / 30.0);
    }
    SceneLevels levels;
    SceneAir air;
    std::optional<Wind> wind;
};

TEST(SceneLevels, AreReadFromTheNearestToTheOutermost) {
    const Scene scene = read(k_two);
    ASSERT_EQ(scene.outer.size(), 2u);
    EXPECT_EQ(scene.outer[0].cell_size, 2.0f);
    EXPECT_EQ(scene.outer[1].cells, glm::ivec3(16, 4, 16));
    EXPECT_EQ(scene.outer[1].ticks.hz, 2.0);
    EXPECT_TRUE(read(R"("viscosity": 0)").outer.empty());
    const auto error = [](const char* air) {
        return read_scene_text(std::string(R"({"air": {)") + air + "}}", "levels.json").error();
    };
    EXPECT_NE(error(R"("outer": {"cells": [0, 4, 4]})").find("$.air.outer"), std::string::npos);
    EXPECT_NE(error(R"("outer": {"ambient": [1, 0, 0]})").find("ambient is not a known key"), std::string::npos);
    EXPECT_NE(error(R"("outer": {"rows": {"first": -1}})").find("$.air.outer.rows.first"), std::string::npos);
}

TEST(SceneLevels, HoldWhatIsWiderThanTheirCells) {
    const Scene scene = read(k_two, k_things);
    Played played(scene);
    for (int n = 1; n <= 30; ++n)
        played.tick(n);
    EXPECT_EQ(played.levels.size(), 2u);
    const auto obstacles = [](const WindControl& wind) { return wind.obstacles().count(); };
    const auto motors = [](const WindControl& wind) { return wind.motors().count(); };
    EXPECT_EQ(obstacles(played.levels.wind(0)), 0); // 6 m
    EXPECT_EQ(obstacles(played.levels.wind(1)), 1); // 2 m
    EXPECT_EQ(obstacles(*played.wind), 2);
    EXPECT_EQ(motors(played.levels.wind(0)), 1);
    EXPECT_EQ(motors(played.levels.wind(1)), 1);
    EXPECT_EQ(played.levels.wind(0).drag().count(), 1);
    // Each follows by cells of its own.
    EXPECT_EQ(played.wind->origin().x, -4.0);
    EXPECT_EQ(played.levels.wind(1).origin().x, -14.0);
    EXPECT_EQ(played.levels.wind(0).origin().x, -48.0);
    EXPECT_EQ(played.levels.wind(0).ambient(), glm::vec3(5.0f, 0.0f, 0.0f));
    EXPECT_EQ(played.wind->ambient(), glm::vec3(5.0f, 0.0f, 0.0f));
    // The house beyond the box is known inside: its wake is in the wind there.
    EXPECT_LT(played.wind->velocity({-5.5, 2.0, 4.0}).x, 3.0f);
}

TEST(SceneLevels, GoOnWithTheSameBits) {
    const Scene scene = read(k_two, k_things);
    Played played(scene);
    for (int n = 1; n <= 20; ++n)
        played.tick(n);
    const auto levels = played.levels.save(), wind = played.wind->save();
    const auto air = played.air.save();
    ASSERT_TRUE(levels && wind);
    Played again(scene);
    again.levels = *SceneLevels::load(scene, {}, *levels);
    again.wind = *Wind::load(*wind, {}, again.levels.nearest());
    ASSERT_TRUE(again.air.load(air));
    for (int n = 21; n <= 40; ++n) {
        played.tick(n);
        again.tick(n);
    }
    EXPECT_EQ(test::largest_apart(played.wind->field(), again.wind->field()), 0.0);
    const Scene other = read(R"("outer": {})");
    EXPECT_NE(SceneLevels::load(other, {}, *levels).error().find("has 1"), std::string::npos);
}

// What is written of a wind is what was read: the same winds around it, with the same bits once they are played.
TEST(SceneLevels, AreWrittenAndReadAgain) {
    const Scene scene = read(k_two, R"(, "follow": [2, 3, 0], "floor": 0, "drag": [{"plant": {"position": [-4, 0, 5]}}],
        "obstacles": [{"position": [-10, 2, 4], "shape": {"block": {"half_size": [3, 2.5, 2]}}}])");
    Played played(scene);
    played.tick(1);
    const auto text = write_scene(*played.wind, {.duration = 2.0, .tick_hz = 30.0});
    ASSERT_TRUE(text) << text.error();
    const auto again = read_scene_text(*text, "again.json");
    ASSERT_TRUE(again) << again.error();
    ASSERT_EQ(again->outer.size(), 2u);
    EXPECT_EQ(again->outer[1].ticks.hz, 2.0);
    Played first(scene), second(*again);
    for (int n = 1; n <= 20; ++n) {
        first.tick(n);
        second.tick(n);
    }
    EXPECT_EQ(test::largest_apart(first.wind->field(), second.wind->field()), 0.0);
    EXPECT_GT(test::largest_apart(first.wind->field(), test::made(scene.air).field()), 1.0);
}

TEST(SceneWriter, SaysWhatASceneMayNotHave) {
    const auto far = write_scene(test::made({.cells = {8, 8, 8}, .centre = {2e9, 0.0, 0.0}}), {}, "far.json");
    EXPECT_EQ(far ? std::string() : far.error().substr(0, 26), "far.json: $.air.centre[0] ");
}

TEST(SceneLevels, AreWrittenAsASceneHasThemOrNot) {
    const Config around{.cells = {20, 8, 20}, .cell_size = 2.0f, .boundaries = Boundaries::open_over_floor()},
        inside{.cells = {12, 8, 12}, .boundaries = Boundaries::open_over_floor()};
    const auto error = [&](const auto& change) {
        Config outside = around;
        change(outside, static_cast<Wind*>(nullptr));
        const auto outer = std::make_shared<Wind>(test::made(outside));
        change(outside, outer.get());
        const auto inner = Wind::create(inside, outer);
        EXPECT_TRUE(inner) << inner.error();
        const auto text = write_scene(*inner, {});
        return text ? std::string() : text.error();
    };
    EXPECT_EQ(error([](Config&, Wind*) {}), "");
    EXPECT_EQ(error([](Config&, Wind* wind) {
                  if (wind != nullptr) { // the wind inside takes it in its next step
                      EXPECT_TRUE(wind->set_ambient({3.0f, 0.0f, 1.0f}) && wind->set_gusts({.intensity = 0.2f}));
                  }
              }),
              "");
    EXPECT_NE(error([](Config& config, Wind*) { config.viscosity = 0.1f; }).find("another viscosity"), std::string::npos);
    EXPECT_NE(error([](Config& config, Wind*) { config.centre.x = 4.0; }).find("let both follow it"), std::string::npos);
    EXPECT_NE(error([](Config&, Wind* wind) {
                  if (wind != nullptr) {
                      EXPECT_TRUE(wind->motors().add(DirectionalMotor{}));
                  }
              }).find("has motors that"),
              std::string::npos);
}

// Each level has a log; played in turns, from the outermost in, they are all that happened.
TEST(SceneLevels, AreReplayedFromTheirLogs) {
    const Config around{
        .cells = {20, 8, 20}, .cell_size = 2.0f, .boundaries = Boundaries::open_over_floor(), .ticks = {.hz = 10.0}},
        inside{.cells = {12, 8, 12}, .boundaries = Boundaries::open_over_floor()};
    const auto outer = std::make_shared<Wind>(test::made(around)), outer_again = std::make_shared<Wind>(test::made(around));
    Wind inner = *Wind::create(inside, outer), inner_again = *Wind::create(inside, outer_again);
    for (int frame = 0; frame < 12; ++frame) {
        EventLog large, small; // of this frame
        outer->record_to(&large);
        inner.record_to(&small);
        if (frame == 0) {
            ASSERT_TRUE(outer->set_ambient({4.0f, 0.0f, 1.0f}));
            (void)test::added(*outer, DirectionalMotor{.position = {-8.0, 3.0, 0.0}, .region = Sphere{4.0f}});
        }
        if (frame == 5) {
            ASSERT_TRUE(outer->set_gusts({.intensity = 0.2f}));
        }
        ASSERT_TRUE(inner.follow({0.3 * frame, 0.0, 0.0}));
        (void)outer->advance(1.0 / 30.0);
        (void)inner.advance(1.0 / 30.0);
        ASSERT_TRUE(replay(large, *outer_again));
        ASSERT_TRUE(replay(small, inner_again));
    }
    EXPECT_EQ(test::largest_apart(outer->field(), outer_again->field()), 0.0);
    EXPECT_EQ(test::largest_apart(inner.field(), inner_again.field()), 0.0);
    EXPECT_GT(glm::length(inner.velocity({0.0, 2.0, 0.0})), 1.0f);
}

TEST(SceneLevels, AreNotLeftOutInSilence) {
    const Scene scene = read(k_two);
    auto wind = Wind::create(scene.air);
    ASSERT_TRUE(wind);
    EXPECT_NE(SceneAir(scene).begin(*wind).error().find("$.air.outer"), std::string::npos);
}

TEST(SceneLevels, RejectABoxThatIsNotInside) {
    const Scene scene = read(R"("outer": {"cells": [8, 8, 8], "cell_size": 1})");
    const auto levels = SceneLevels::create(scene, {});
    ASSERT_TRUE(levels) << levels.error();
    EXPECT_NE(Wind::create(levels->inner_config(), levels->nearest()).error().find("along x"), std::string::npos);
}

} // namespace
} // namespace windrow::scene
