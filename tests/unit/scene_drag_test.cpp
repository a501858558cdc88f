// Deposits of drag of a scene file: how they are read, and that they slow the scene's air from the start on.
#include "scene/scene_air.h"
#include "scene/scene_reader.h"
#include "tests/winds.h"

#include <string>
#include <utility>

namespace windrow::scene {
namespace {

TEST(SceneDrag, IsReadAndAddedOnce) {
    const auto scene = read_scene_text(R"({"air": {"cells": [16, 8, 16], "ambient": [4, 0, 0]}, "drag": [
        {"plant": {"position": [1, 2, 3], "radius": 2, "base": 2, "height": 7, "area": 10}},
        {"belt": {"start": [-4, 0, 1], "end": [4, 0, 1], "width": 3, "height": 6, "resistance": 1.5}}, {"belt": {}}]})",
                                       "hedge.json");
    ASSERT_TRUE(scene) << scene.error();
    ASSERT_EQ(scene->drag.size(), 3u);
    const auto& tree = std::get<PlantDrag>(scene->drag[0]);
    EXPECT_EQ(tree.position, glm::dvec3(1, 2, 3));
    EXPECT_EQ(std::tuple(tree.radius, tree.base, tree.height, tree.area), std::tuple(2.0f, 2.0f, 7.0f, 10.0f));
    const auto& hedge = std::get<BeltDrag>(scene->drag[1]);
    EXPECT_EQ(hedge.start, glm::dvec3(-4, 0, 1));
    EXPECT_EQ(hedge.end, glm::dvec3(4, 0, 1));
    EXPECT_EQ(std::tuple(hedge.width, hedge.height, hedge.resistance), std::tuple(3.0f, 6.0f, 1.5f));
    EXPECT_EQ(std::get<BeltDrag>(scene->drag[2]).width, BeltDrag{}.width);

    Wind wind = *Wind::create(scene->air);
    SceneAir air(*scene);
    ASSERT_TRUE(air.begin(wind));
    for (int n = 1; n <= 20; ++n) {
        ASSERT_TRUE(air.advance_to(wind, n / 30.0));
        wind.step(1.0 / 30.0);
    }
    EXPECT_EQ(wind.drag().count(), 3);
    EXPECT_LT(wind.velocity({1.0, 2.5, 1.0}).x, 3.5f);
}

// [m/s] Along the wind behind a grove, and how many deposits made it.
std::pair<float, int> wind_behind(const std::string& stand) {
    const auto scene =
        read_scene_text(R"({"air": {"cells": [32, 16, 16], "ambient": [4, 0, 0], "boundaries": {"y_low": "free_slip"}},
        "drag": [{"plant": {"position": [0, 0, 40]}}], "picture": {"trees": [)" +
                            stand + "]}}",
                        "grove.json");
    EXPECT_TRUE(scene) << scene.error();
    Wind wind = *Wind::create(scene->air);
    SceneAir air(*scene);
    EXPECT_TRUE(air.begin(wind));
    for (int n = 1; n <= 90; ++n) {
        EXPECT_TRUE(air.advance_to(wind, n / 30.0));
        wind.step(1.0 / 30.0);
    }
    return {wind.velocity({6.0, 1.5, 0.0}).x, wind.drag().count()};
}

TEST(SceneDrag, TreesOfAPictureSlowTheAirUnlessTheyAreNotTo) {
    const std::string grove = R"("kind": "bush", "places": [{"at": [0, 0]}, {"at": [-3, 1], "size": 0.8}],
        "scatter": {"count": 3, "low": [-8, -8], "high": [-4, 8], "groves": 0, "apart": 1})";
    const auto [slowed, all] = wind_behind("{" + grove + "}");
    const auto [free, none] = wind_behind(R"({"slows_air": false, )" + grove + "}");
    EXPECT_EQ(all, 6);
    EXPECT_EQ(none, 1);
    EXPECT_FLOAT_EQ(free, 4.0f);
    EXPECT_LT(slowed, 3.0f);
}

TEST(SceneDrag, TooManyTreesAreRejectedByASentence) {
    const auto scene = read_scene_text(R"({"picture": {"trees": [{"scatter": {"count": 100000}}, {"scatter": {"count": 100000}},
        {"scatter": {"count": 100000}}]}})",
                                       "wood.json");
    ASSERT_FALSE(scene);
    EXPECT_NE(scene.error().find("$.picture.trees[2]"), std::string::npos) << scene.error();
    EXPECT_NE(scene.error().find("\"slows_air\": false"), std::string::npos) << scene.error();
}

// What a crown takes: C_d 0.2 of its leaves, over a square of the area that it covers.
TEST(SceneDrag, OfATreeIsThatOfItsCrown) {
    const TreeCrown& oak = k_tree_crowns[0];
    const PlantDrag drag = drag_of(oak, {.base = {1.0, 2.0, 3.0}, .size = 0.5f});
    EXPECT_EQ(drag.position, glm::dvec3(1.0, 2.0, 3.0));
    EXPECT_FLOAT_EQ(drag.height, 0.5f * oak.height);
    const float covered = 4.0f * drag.radius * drag.radius;
    EXPECT_NEAR(covered, 3.14159f * 0.25f * oak.radius * oak.radius, 1e-3f);
    EXPECT_NEAR(drag.area, 0.2f * oak.leaf_area * covered, 1e-3f);
}

TEST(SceneDrag, OfNonsenseIsRejectedByASentence) {
    const auto fault = [](const std::string& drag) {
        const auto scene = read_scene_text(R"({"drag": [)" + drag + "]}", "a.json");
        return scene ? std::string() : scene.error();
    };
    for (const auto& [drag, words] : {std::pair{R"({"plant": {"base": 3}})", "give a base below the height"},
                                      {R"({"plant": {"area": -1}})", "area is -1"},
                                      {R"({"belt": {"start": [5, 1, 0]}})", "give 0.001 to 10000 m"},
                                      {R"({"plant": {}, "belt": {}})", "plant"},
                                      {R"({"hedge": {}})", "hedge"},
                                      {R"({"plant": {"radius": 1, "radios": 2}})", "radios"}})
        EXPECT_NE(fault(drag).find(words), std::string::npos) << fault(drag);
}

} // namespace
} // namespace windrow::scene
