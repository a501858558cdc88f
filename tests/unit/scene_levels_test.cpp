// A scene with winds around its box: what is read of them, what is in each, and that they go on from where they were saved.
#include "scene/scene_levels.h"
#include "scene/scene_reader.h"
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
