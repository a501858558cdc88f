// Obstacles of a scene file: how they are read, and that a scene brings, moves, turns and removes them.
#include "scene/scene_air.h"
#include "scene/scene_reader.h"
#include "tests/winds.h"

#include <numbers>

namespace windrow::scene {
namespace {

constexpr const char* k_town = R"({
    "air": {"cells": [16, 8, 16]},
    "paths": {"rails": {"points": [[0, -6, 0, 0], [4, 6, 0, 0]]}, "hinge": {"points": [[1, 0, 0, 0], [2, 90, 0, 0]]}},
    "obstacles": [
        {"name": "house", "position": [1, 2, 3], "turn_deg": [90, 0, 0], "shape": {"block": {"half_size": [4, 2, 1]}},
         "surface": "no_slip"},
        {"name": "train", "path": "rails", "from": 1, "until": 3, "shape": {"capsule": {"half_axis": [2, 0, 0]}}},
        {"name": "door", "turn_path": "hinge", "shape": {"plate": {"half_size": [1, 2]}}},
        {}
    ]})";

Scene town() {
    auto scene = read_scene_text(k_town, "town.json");
    EXPECT_TRUE(scene) << scene.error();
    return scene ? *std::move(scene) : Scene{};
}

TEST(SceneObstacles, AreReadWithTheirDefaults) {
    const Scene scene = town();
    ASSERT_EQ(scene.obstacles.size(), 4u);
    const Obstacle& house = scene.obstacles[0].obstacle;
    EXPECT_EQ(house.position, glm::dvec3(1, 2, 3));
    EXPECT_EQ(std::get<Block>(house.shape).half_size, glm::vec3(4, 2, 1));
    EXPECT_EQ(house.surface, Surface::no_slip);
    EXPECT_NEAR(glm::length(house.orientation * glm::vec3(1, 0, 0) - glm::vec3(0, 0, -1)), 0.0f, 1e-6f) << "yaw: from x to -z";
    EXPECT_EQ(scene.obstacles[1].path, std::optional<std::size_t>(1)) << "paths are in the order of their names";
    EXPECT_EQ(scene.obstacles[1].from, 1.0);
    EXPECT_EQ(scene.obstacles[1].until, 3.0);
    EXPECT_EQ(scene.obstacles[2].turn_path, std::optional<std::size_t>(0));
    EXPECT_EQ(scene.obstacles[3].obstacle.orientation, glm::quat(1, 0, 0, 0));
    EXPECT_TRUE(std::holds_alternative<Block>(scene.obstacles[3].obstacle.shape));
}

TEST(SceneObstacles, BlockWhatPassesOrEndsInside) {
    const Scene scene = town();
    const auto standing = SceneAir(scene).standing(2.5);
    ASSERT_EQ(standing.size(), 4u);
    const auto& house = standing[0]; // yawed by 90 degrees: half sizes 1, 2, 4 in the world, about 1, 2, 3
    EXPECT_TRUE(house.blocks({-3, 2, 6}, {5, 2, 6})) << "through it";
    EXPECT_TRUE(house.blocks({1, 2, 6}, {1, 2, 6})) << "a place inside";
    EXPECT_TRUE(house.blocks({-3, 2, 6}, {1, 2, 6})) << "into it";
    EXPECT_FALSE(house.blocks({-3, 2, 8}, {5, 2, 8})) << "past it";
    EXPECT_FALSE(house.blocks({3, 2, 3}, {3, 2, 3})) << "inside, were it not turned";
    EXPECT_TRUE(standing[2].blocks({-1, 0, 0.5}, {1, 0, 0.5})) << "the door is open by 90 degrees";
    EXPECT_FALSE(standing[2].blocks({0.5, 0, -1}, {0.5, 0, 1}));
}

TEST(SceneObstacles, AnglesComeBack) {
    test::Random random(5);
    for (int n = 0; n < 100; ++n) {
        const glm::dvec3 turn(random.real(-179.0, 179.0), random.real(-85.0, 85.0), random.real(-179.0, 179.0));
        EXPECT_NEAR(glm::length(turn_of(orientation_of(turn)) - turn), 0.0, 1e-2) << n;
    }
    for (const double pitch : {-90.0, -89.999, 89.999, 90.0}) // where yaw and roll turn about one axis
        for (const double yaw : {0.0, 30.0, 90.0, 120.0, 200.0})
            for (const double roll : {0.0, 50.0, -170.0}) {
                const glm::quat given = orientation_of({yaw, pitch, roll}), again = orientation_of(turn_of(given));
                EXPECT_NEAR(std::abs(glm::dot(given, again)), 1.0f, 1e-6f) << yaw << " " << pitch << " " << roll;
            }
    EXPECT_NEAR(glm::length(orientation_of({0, 90, 0}) * glm::vec3(0, 0, 1) - glm::vec3(0, -1, 0)), 0.0f, 1e-6f) << "pitch";
    EXPECT_NEAR(glm::length(orientation_of({0, 0, 90}) * glm::vec3(1, 0, 0) - glm::vec3(0, 1, 0)), 0.0f, 1e-6f) << "roll";
}

TEST(SceneObstacles, FaultsAreNamed) {
    const std::pair<const char*, const char*> bad[] = {
        {R"({"shape": {"block": {"half_size": [1, 0, 1]}}})",
         "$.obstacles[0].shape.block.half_size[1] is 0 m: give a number above 0, at most 1e6 m."},
        {R"({"shape": {"torus": {}}})", "$.obstacles[0].shape.torus is not a known key"},
        {R"({"turn_deg": [1, 2]})", "$.obstacles[0].turn_deg is [1,2]: give three numbers, [x, y, z]."},
        {R"({"path": "a"})", "$.obstacles[0].path is \"a\", which is not in $.paths"},
        {R"({"from": 2, "until": 1})", "$.obstacles[0].until is 1 s but the obstacle begins at 2 s: give a later time."},
        {R"({"surface": "sticky"})", "$.obstacles[0].surface is \"sticky\""},
    };
    for (const auto& [text, reason] : bad) {
        const auto scene = read_scene_text(std::string(R"({"obstacles": [)") + text + "]}", "a.json");
        ASSERT_FALSE(scene) << text;
        EXPECT_NE(scene.error().find(reason), std::string::npos) << scene.error();
    }
    for (const char* both :
         {R"({"obstacles": [{"position": [0, 0, 0], "path": "a"}], "paths": {"a": {"points": [[0, 0, 0, 0]]}}})",
          R"({"obstacles": [{"turn_deg": [0, 0, 0], "turn_path": "a"}], "paths": {"a": {"points": [[0, 0, 0, 0]]}}})"})
        EXPECT_FALSE(read_scene_text(both, "a.json")) << both;
}

TEST(SceneObstacles, ComeMoveTurnAndGo) {
    const Scene scene = town();
    auto wind = Wind::create(scene.air);
    ASSERT_TRUE(wind) << wind.error();
    SceneAir air(scene);
    ASSERT_TRUE(air.begin(*wind));
    EXPECT_EQ(wind->obstacles().count(), 3);
    std::vector<int> counts;
    std::vector<Obstacle> last;
    for (int tick = 0; tick < 8; ++tick) {
        const auto advanced = air.advance_to(*wind, 0.5 * (tick + 1));
        ASSERT_TRUE(advanced) << advanced.error();
        counts.push_back(wind->obstacles().count());
        if (tick == 2) // up to 1.5 s
            for (const Obstacles::Slot& slot : wind->obstacles().slots())
                last.push_back(slot.obstacle);
        (void)wind->step(0.5);
    }
    EXPECT_EQ(counts, (std::vector<int>{3, 3, 4, 4, 4, 4, 3, 3}));
    ASSERT_EQ(last.size(), 4u);
    EXPECT_NEAR(last[3].position.x, -1.5, 1e-9) << "the train, which came last";
    EXPECT_NEAR(turn_of(last[1].orientation).x, 45.0, 1e-3) << "the door";
}

// A door on its hinge, and a wheel that turns ten times a second: a whole turn in each step of .1 s, which its poses do not show.
TEST(SceneObstacles, TurnAboutAPivotAndAsOftenAsTheySay) {
    const auto scene = read_scene_text(R"({
        "air": {"cells": [16, 8, 8]},
        "paths": {"hinge": {"points": [[0, 0, 0, 0], [1, 90, 0, 0]]}},
        "obstacles": [
            {"name": "door", "position": [2, 0, 0], "turn_path": "hinge", "pivot": [-1, 0, 0],
             "shape": {"block": {"half_size": [1, 1, 0.1]}}},
            {"name": "wheel", "position": [-3, 0, 0], "rpm": [0, 0, 600], "shape": {"block": {"half_size": [1, 0.3, 0.5]}}}
        ]})",
                                       "turning.json");
    ASSERT_TRUE(scene) << scene.error();
    auto wind = Wind::create(scene->air);
    ASSERT_TRUE(wind) << wind.error();
    SceneAir air(*scene);
    ASSERT_TRUE(air.begin(*wind));
    EXPECT_NEAR(wind->obstacles().slots()[0].obstacle.position.x, 3.0, 1e-6);
    int fast = 0;
    for (int tick = 0; tick < 10; ++tick) {
        ASSERT_TRUE(air.advance_to(*wind, 0.1 * (tick + 1)));
        fast += wind->step(0.1).fast_turns;
    }
    const Obstacle& door = wind->obstacles().slots()[0].obstacle;
    EXPECT_LT(glm::length(door.position - glm::dvec3(2.0, 0.0, -1.0)), 1e-5) << "turned by 90 degrees about x = 2";
    EXPECT_EQ(fast, 10);
    double spin = 0.0;
    for (const PlacedObstacle& body : wind->obstacles().in_reach())
        spin = std::max(spin, static_cast<double>(body.spin.z));
    EXPECT_NEAR(spin, 20.0 * std::numbers::pi, 1e-3);
}

TEST(SceneObstacles, ASceneOfMoreThanFitIsRejected) {
    std::string list = "{}";
    for (std::uint32_t n = 0; n < Obstacles::k_capacity; ++n)
        list += ",{}";
    const auto scene = read_scene_text(R"({"obstacles": [)" + list + "]}", "a.json");
    ASSERT_FALSE(scene);
    EXPECT_NE(scene.error().find("$.obstacles"), std::string::npos) << scene.error();
}

} // namespace
} // namespace windrow::scene
