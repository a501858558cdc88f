// Scenes: what is read, whatever the locale.
#include "cli/path_csv.h"
#include "cli/scene_reader.h"

#include <clocale>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <string>
#include <variant>

namespace windrow::cli {
namespace {

const std::filesystem::path k_scenes = std::filesystem::path(WINDROW_SOURCE_DIR) / "examples" / "scenes";

Result<Scene> read(const std::string& text) {
    return read_scene_text(text, "a.json");
}

TEST(Scene, EmptyObjectHasTheDefaultsOfTheHeaders) {
    const auto scene = read("{}");
    ASSERT_TRUE(scene) << scene.error();
    const Config defaults;
    EXPECT_EQ(scene->name, "a");
    EXPECT_EQ(scene->air.cells, defaults.cells);
    EXPECT_EQ(scene->air.cell_size, defaults.cell_size);
    EXPECT_EQ(scene->air.sides, defaults.sides);
    EXPECT_EQ(scene->air.viscosity, defaults.viscosity);
    EXPECT_EQ(scene->air.settling_time, defaults.settling_time);
    EXPECT_EQ(scene->air.max_substeps, defaults.max_substeps);
    EXPECT_TRUE(std::holds_alternative<std::monostate>(scene->follow));
    EXPECT_TRUE(scene->motors.empty());
    EXPECT_EQ(scene->tick_hz, 60.0);
}

TEST(Scene, ExampleIsRead) {
    const auto scene = read_scene(k_scenes / "walk.json");
    ASSERT_TRUE(scene) << scene.error();
    EXPECT_EQ(scene->frame_count(), 201);
    EXPECT_EQ(scene->motors.size(), 3u);
    EXPECT_EQ(scene->air.sides, Sides::open_over_floor());
    EXPECT_EQ(scene->air.centre, scene->followed_point(0.0)) << "a box that follows begins where it will follow";
    EXPECT_NEAR(scene->followed_point(10.0).x, 0.0, 1e-9);
}

TEST(Scene, ExampleOfTheDocumentsIsRead) {
    std::ifstream file(std::filesystem::path(WINDROW_SOURCE_DIR) / "docs" / "scenes.md");
    const std::string page((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    const std::size_t begin = page.find("```json\n") + 8;
    ASSERT_LT(begin, page.size());
    const auto scene = read_scene_text(page.substr(begin, page.find("```", begin) - begin), k_scenes / "walk.json");
    EXPECT_TRUE(scene) << scene.error();
}

TEST(Scene, MotorsAreReadWhole) {
    const auto scene = read(R"({
        "paths": {"way": {"points": [[0, 0, 0, 0], [2, 4, 0, 0]]}},
        "motors": [
            {"kind": "directional", "name": "fan", "position": [1, 2, 3], "direction": [0, 2, 0], "from": 1, "until": 2,
             "region": {"capsule": {"half_axis": [0, 0, 3], "radius": 0.7}}, "law": {"force": {"acceleration": -3}}},
            {"kind": "directional", "path": "way", "region": {"box": {"half_size": [1, 2, 3]}}},
            {"kind": "wake", "path": "way", "radius": 0.4, "law": {"force": {"strength": 2}}}
        ]})");
    ASSERT_TRUE(scene) << scene.error();
    ASSERT_EQ(scene->motors.size(), 3u);
    const auto& fan = std::get<DirectionalMotor>(scene->motors[0].motor);
    EXPECT_EQ(scene->motors[0].name, "fan");
    EXPECT_EQ(scene->motors[0].from, 1.0);
    EXPECT_EQ(scene->motors[0].until, 2.0);
    EXPECT_EQ(fan.position, glm::dvec3(1, 2, 3));
    EXPECT_EQ(std::get<Capsule>(fan.region).half_axis, glm::vec3(0, 0, 3));
    EXPECT_EQ(std::get<Force>(fan.law).acceleration, -3.0f);
    EXPECT_EQ(std::get<AlignedBox>(std::get<DirectionalMotor>(scene->motors[1].motor).region).half_size, glm::vec3(1, 2, 3));
    EXPECT_EQ(scene->motors[1].path, std::optional<std::size_t>(0));
    EXPECT_EQ(std::get<WakeForce>(std::get<WakeMotor>(scene->motors[2].motor).law).strength, 2.0f);
}

TEST(Scene, SidesAreAWordOrAnObject) {
    const auto scene = read(
        R"({"air": {"sides": {"y_low": {"kind": "no_slip", "wall_velocity": [3, 0, 1]}, "z_low": "periodic", "z_high": "periodic"}}})");
    ASSERT_TRUE(scene) << scene.error();
    EXPECT_EQ(scene->air.sides.y_low.kind, SideKind::no_slip);
    EXPECT_EQ(scene->air.sides.y_low.wall_velocity, glm::vec3(3, 0, 1));
    EXPECT_TRUE(scene->air.sides.periodic(2));
}

TEST(Scene, FramesAndTicks) {
    auto scene = read(R"({"duration": 0.3, "frames_per_second": 10})");
    ASSERT_TRUE(scene);
    EXPECT_EQ(scene->frame_count(), 4) << "0.3 * 10 is a hair below 3";
    EXPECT_EQ(scene->tick_of_frame(0), 0);
    EXPECT_EQ(scene->tick_of_frame(3), 18);
    scene = read(R"({"duration": 1, "tick_hz": 60, "frames_per_second": 24})");
    ASSERT_TRUE(scene);
    EXPECT_EQ(scene->tick_of_frame(1), 3) << "2.5 ticks: to the nearest, and always the same one";
    EXPECT_EQ(scene->tick_of_frame(24), 60);
}

TEST(MotionPath, IsStraightBetweenPointsAndStaysAtItsEnds) {
    const MotionPath path({{1.0, {0, 0, 0}}, {3.0, {4, 2, 0}}, {4.0, {4, 2, 0}}});
    EXPECT_EQ(path.at(-5.0), glm::dvec3(0, 0, 0));
    EXPECT_EQ(path.at(2.0), glm::dvec3(2, 1, 0));
    EXPECT_EQ(path.at(3.0), glm::dvec3(4, 2, 0));
    EXPECT_EQ(path.at(3.3), glm::dvec3(4, 2, 0)) << "a body that stands still does stand still";
    EXPECT_EQ(path.at(1e9), glm::dvec3(4, 2, 0));
}

TEST(PathCsv, TakesHeaderCommentsSpacesAndDosLineEnds) {
    const auto path = parse_path_csv("# walk\r\n t, x ,y,z\r\n\r\n0, 1, +2.5, -3e-1\r\n  # pause\r\n1,1,1,1", "p.csv");
    ASSERT_TRUE(path) << path.error();
    ASSERT_EQ(path->points().size(), 2u);
    EXPECT_EQ(path->points()[0].position, glm::dvec3(1.0, 2.5, -0.3));
}

TEST(Scene, DecimalCommaOfTheLocaleDoesNotMatter) {
    // Where no such locale is installed this still reads, in the C locale.
    const std::string before = std::setlocale(LC_ALL, nullptr);
    for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8", "nl_NL.UTF-8"})
        if (std::setlocale(LC_ALL, name) != nullptr)
            break;
    const auto scene = read(R"({"duration": 2.5, "air": {"cell_size": 0.25, "cells": [1e1, 8, 8]}})");
    const auto path = parse_path_csv("0.5,1.5,2.5,3.5\n", "p.csv");
    const auto refused = read(R"({"duration": -2.5})");
    std::setlocale(LC_ALL, before.c_str());
    ASSERT_TRUE(scene) << scene.error();
    EXPECT_EQ(scene->duration, 2.5);
    EXPECT_EQ(scene->air.cell_size, 0.25f);
    EXPECT_EQ(scene->air.cells.x, 10);
    ASSERT_TRUE(path);
    EXPECT_EQ(path->points()[0].position.z, 3.5);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error(), "a.json: $.duration is -2.5 s: give a number above 0, at most 1e6 s.");
}

} // namespace
} // namespace windrow::cli
