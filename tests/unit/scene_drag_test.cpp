// Deposits of drag of a scene file: how they are read, and that they slow the scene's air from the start on.
#include "scene/scene_air.h"
#include "scene/scene_reader.h"
#include "tests/winds.h"

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
