// Scenes: what is read, whatever the locale.
#include "cli/playback.h"
#include "scene/motion_path.h"
#include "scene/scene_reader.h"
#include "tests/own_folder.h"

#include <clocale>
#include <cmath>
#include <cstdlib>
#include <variant>

namespace windrow::cli {
namespace {

const std::filesystem::path k_scenes = std::filesystem::path(WINDROW_SOURCE_DIR) / "examples" / "scenes";

Result<scene::Scene> read(const std::string& text) {
    return scene::read_scene_text(text, "a.json");
}

TEST(Scene, EmptyObjectHasTheDefaultsOfTheHeaders) {
    const auto scene = read("{}");
    ASSERT_TRUE(scene) << scene.error();
    const Config defaults;
    EXPECT_EQ(scene->name, "a");
    EXPECT_EQ(scene->air.cells, defaults.cells);
    EXPECT_EQ(scene->air.cell_size, defaults.cell_size);
    EXPECT_EQ(scene->air.boundaries, defaults.boundaries);
    EXPECT_EQ(scene->air.viscosity, defaults.viscosity);
    EXPECT_EQ(scene->air.relaxation_time, defaults.relaxation_time);
    EXPECT_EQ(scene->air.max_substeps, defaults.max_substeps);
    EXPECT_TRUE(std::holds_alternative<std::monostate>(scene->follow));
    EXPECT_TRUE(scene->motors.empty());
    EXPECT_EQ(scene->tick_hz, 60.0);
}

TEST(Scene, ExampleIsRead) {
    const auto scene = scene::read_scene(k_scenes / "walk.json");
    ASSERT_TRUE(scene) << scene.error();
    EXPECT_EQ(scene->frame_count(), 201);
    EXPECT_EQ(scene->motors.size(), 4u);
    EXPECT_EQ(scene->air.boundaries, Boundaries::open_over_floor());
    EXPECT_EQ(scene->air.centre, scene->followed_point(0.0)) << "a box that follows begins where it will follow";
    EXPECT_NEAR(scene->followed_point(10.0).x, 0.0, 1e-9);
}

TEST(Scene, ExampleOfTheDocumentsIsRead) {
    const std::string page = test::text_of(WINDROW_SOURCE_DIR "/docs/scenes.md");
    const std::size_t begin = page.find("```json\n") + 8;
    ASSERT_LT(begin, page.size());
    const auto scene = scene::read_scene_text(page.substr(begin, page.find("```", begin) - begin), k_scenes / "walk.json");
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

TEST(Scene, MotorsOfTheOtherKindsAreReadWhole) {
    const auto scene = read(R"({
        "paths": {"way": {"points": [[0, 0, 0, 0], [2, 4, 0, 0]]}},
        "motors": [
            {"kind": "jet", "position": [1, 2, 3], "direction": [0, 2, 0], "length": 5, "start_radius": 0.7, "end_radius": 0.9,
             "law": {"drive": {"speed": 20}}, "envelope": {"attack": 1, "hold": 2, "decay": 3}},
            {"kind": "vortex", "path": "way", "axis": [1, 0, 0], "radius": 3, "half_length": 2, "lift": -0.5, "law": {"force": {}}},
            {"kind": "omni", "position": [4, 5, 6], "radius": 1.5, "speed": -3, "envelope": {"hold": 0.5}},
            {"kind": "pressure", "position": [7, 8, 9], "radius": 2.5, "speed": -30, "duration": 0.4},
            {"kind": "directional", "region": {"cone": {"axis": [0, 0, 4], "start_radius": 0.3, "end_radius": 1}}},
            {"kind": "jet"}
        ]})");
    ASSERT_TRUE(scene) << scene.error();
    ASSERT_EQ(scene->motors.size(), 6u);
    const auto& jet = std::get<JetMotor>(scene->motors[0].motor);
    EXPECT_EQ(jet.position, glm::dvec3(1, 2, 3));
    EXPECT_EQ(jet.direction, glm::vec3(0, 2, 0));
    EXPECT_EQ(jet.length, 5.0f);
    EXPECT_EQ(jet.start_radius, 0.7f);
    EXPECT_EQ(jet.end_radius, 0.9f);
    EXPECT_EQ(std::get<Drive>(jet.law).speed, 20.0f);
    EXPECT_EQ(std::get<Drive>(jet.law).rate, 8.0f) << "the jet's own default";
    EXPECT_EQ(jet.envelope.end(), 6.0);
    const auto& vortex = std::get<VortexMotor>(scene->motors[1].motor);
    EXPECT_EQ(scene->motors[1].path, std::optional<std::size_t>(0));
    EXPECT_EQ(vortex.axis, glm::vec3(1, 0, 0));
    EXPECT_EQ(vortex.radius, 3.0f);
    EXPECT_EQ(vortex.half_length, 2.0f);
    EXPECT_EQ(vortex.lift, -0.5f);
    EXPECT_TRUE(std::holds_alternative<Force>(vortex.law));
    const auto& omni = std::get<OmniMotor>(scene->motors[2].motor);
    EXPECT_EQ(omni.position, glm::dvec3(4, 5, 6));
    EXPECT_EQ(omni.radius, 1.5f);
    EXPECT_EQ(omni.speed, -3.0f);
    EXPECT_EQ(omni.envelope.end(), 0.5);
    const auto& pressure = std::get<PressureMotor>(scene->motors[3].motor);
    EXPECT_EQ(pressure.position, glm::dvec3(7, 8, 9));
    EXPECT_EQ(pressure.radius, 2.5f);
    EXPECT_EQ(pressure.speed, -30.0f);
    EXPECT_EQ(pressure.duration, 0.4f);
    const Cone cone = std::get<Cone>(std::get<DirectionalMotor>(scene->motors[4].motor).region);
    EXPECT_EQ(cone.axis, glm::vec3(0, 0, 4));
    EXPECT_EQ(cone.start_radius, 0.3f);
    EXPECT_EQ(cone.end_radius, 1.0f);
    const auto& plain = std::get<JetMotor>(scene->motors[5].motor);
    EXPECT_EQ(std::get<Drive>(plain.law).speed, std::get<Drive>(JetMotor{}.law).speed);
    EXPECT_TRUE(std::isinf(plain.envelope.end()));
}

TEST(Scene, AmbientWindIsReadWhole) {
    const auto scene = read(R"({"air": {"ambient": [6, 0, 0], "profile": {"roughness_length": 0.1, "reference_height": 2},
        "gusts": {"intensity": 0.3, "length": 12, "seed": 7}, "blend_width": 3, "sleep_speed": 0.01}})");
    ASSERT_TRUE(scene) << scene.error();
    ASSERT_TRUE(scene->air.profile);
    EXPECT_EQ(scene->air.profile->roughness_length, 0.1f);
    EXPECT_EQ(scene->air.profile->reference_height, 2.0f);
    EXPECT_EQ(scene->air.gusts.intensity, 0.3f);
    EXPECT_EQ(scene->air.gusts.length, 12.0f);
    EXPECT_EQ(scene->air.gusts.seed, 7u);
    EXPECT_EQ(scene->air.blend_width, 3.0f);
    EXPECT_EQ(scene->air.sleep_speed, 0.01f);
    EXPECT_FALSE(read("{}")->air.profile);
    EXPECT_TRUE(read(R"({"air": {"profile": {}}})")->air.profile) << "an empty one has the profile's own defaults";
}

TEST(Scene, BoxThatFollowsNothingHasNoAxisThatFollows) {
    EXPECT_EQ(read("{}")->air.follow_axes, glm::bvec3(false));
    EXPECT_FALSE(read(R"({"follow": [1, 2, 3]})")->air.follow_axes);
    EXPECT_EQ(read(R"({"air": {"follow_axes": [true, false, true]}})")->air.follow_axes, glm::bvec3(true, false, true));
}

TEST(Scene, StormIsWhatItsScriptMakes) {
    if (std::system("python3 -c '' 2>/dev/null") != 0)
        GTEST_SKIP() << "python3 is not installed";
    const auto scene = scene::read_scene(k_scenes / "storm.json");
    ASSERT_TRUE(scene) << scene.error();
    EXPECT_EQ(scene->motors.size(), 300u);
    const std::string command = "python3 '" + std::string(WINDROW_SOURCE_DIR) + "/tools/make_storm.py' | cmp - '" +
                                (k_scenes / "storm.json").string() + "'";
    EXPECT_EQ(std::system(command.c_str()), 0) << "run python3 tools/make_storm.py > " << k_scenes / "storm.json";
}

// --- Playback --------------------------------------------------------------------------------------------------------

TEST(Playback, MotorsThatEndByThemselvesAreLetGo) {
    const auto scene = read(R"({"tick_hz": 10, "air": {"cells": [8, 8, 8]},
        "paths": {"way": {"points": [[0, -3, 0, 0], [2, 3, 0, 0]]}},
        "motors": [
            {"kind": "directional", "name": "gust", "from": 0.2, "until": 1.6, "envelope": {"hold": 0.5}},
            {"kind": "wake", "name": "body", "path": "way", "envelope": {"attack": 0.2, "hold": 0.2, "decay": 0.2}},
            {"kind": "pressure", "name": "burst", "duration": 0.05},
            {"kind": "omni", "name": "vent"}
        ]})");
    ASSERT_TRUE(scene) << scene.error();
    auto playback = Playback::create(*scene, {});
    ASSERT_TRUE(playback) << playback.error();
    const auto names = [&] {
        std::string text;
        for (const Playback::ActingMotor& acting : playback->acting())
            text += acting.motor->name + " ";
        return text;
    };
    EXPECT_EQ(names(), "body burst vent ");
    for (int tick = 0; tick < 4; ++tick)
        ASSERT_TRUE(playback->tick());
    EXPECT_EQ(names(), "gust body burst vent ");
    for (int tick = 4; tick < 8; ++tick)
        ASSERT_TRUE(playback->tick()) << "a path goes on when its motor has ended";
    EXPECT_EQ(names(), "vent ") << "a motor that ended does not begin again, although its time is not over";
    for (int tick = 8; tick < 25; ++tick)
        ASSERT_TRUE(playback->tick()) << "nor is it removed a second time";
    EXPECT_EQ(names(), "vent ");
    EXPECT_EQ(playback->wind().motors().count(), 1);
}

TEST(Playback, FirstFrameIsTheAmbientWindAtItsHeight) {
    const auto scene = read(R"({"air": {"cells": [16, 16, 16], "ambient": [4, 0, 1], "profile": {}, "gusts": {"intensity": 0.3},
        "boundaries": {"y_low": "free_slip"}}, "follow": [5, 3, 5], "floor": 40})");
    ASSERT_TRUE(scene) << scene.error();
    const auto playback = Playback::create(*scene, {});
    ASSERT_TRUE(playback) << playback.error();
    const WindView view = playback->wind().view();
    for (int i = 3; i < 13; ++i)
        for (int j = 0; j < 16; ++j) {
            const glm::dvec3 centre = view.window().centre(i, j, 8);
            const glm::vec3 apart = view.velocity(centre) - view.ambient().velocity(centre);
            EXPECT_NEAR(apart.x, 0.0f, 1e-4f) << j << " m above the floor";
            EXPECT_NEAR(apart.z, 0.0f, 1e-4f) << j << " m above the floor";
        }
}

TEST(Playback, TellsHowStrongAMotorIs) {
    const auto scene = read(R"({"tick_hz": 100, "air": {"cells": [8, 8, 8]},
        "motors": [{"kind": "jet", "envelope": {"attack": 0.4}}, {"kind": "pressure", "duration": 0.2}]})");
    ASSERT_TRUE(scene) << scene.error();
    auto playback = Playback::create(*scene, {});
    ASSERT_TRUE(playback);
    EXPECT_NEAR(playback->acting()[0].strength, 0.0, 0.01);
    EXPECT_NEAR(playback->acting()[1].strength, 1.0, 0.1);
    for (int tick = 0; tick < 40; ++tick)
        ASSERT_TRUE(playback->tick());
    EXPECT_NEAR(playback->acting()[0].strength, 1.0, 1e-6);
    EXPECT_NEAR(playback->acting()[1].strength, -std::exp(-2.0), 0.01) << "it draws back, most at twice its duration";
}

TEST(Scene, SidesAreAWordOrAnObject) {
    const auto scene = read(
        R"({"air": {"boundaries": {"y_low": {"kind": "no_slip", "wall_velocity": [3, 0, 1]}, "z_low": "periodic", "z_high": "periodic"}}})");
    ASSERT_TRUE(scene) << scene.error();
    EXPECT_EQ(scene->air.boundaries.y_low.kind, BoundaryKind::no_slip);
    EXPECT_EQ(scene->air.boundaries.y_low.wall_velocity, glm::vec3(3, 0, 1));
    EXPECT_TRUE(scene->air.boundaries.periodic(2));
}

TEST(Scene, PictureIsForARendererToRead) {
    EXPECT_TRUE(read(R"({"picture": {"zebra": [1, "two"]}})"));
    const auto none = read(R"({"picture": 3})");
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error(), "a.json: $.picture is 3: give an object, {...}.");
}

TEST(Scene, FramesAndTicks) {
    auto scene = read(R"({"duration": 0.3, "frames_per_second": 10})");
    ASSERT_TRUE(scene);
    EXPECT_EQ(scene->frame_count(), 4) << "0.3 * 10 is a hair below 3";
    EXPECT_EQ(scene->frame_times().step_of_frame(0), 0);
    EXPECT_EQ(scene->frame_times().step_of_frame(3), 18);
    EXPECT_EQ(scene->frame_times().length_of_step(1), 1.0 / 60.0) << "the tick, to the bit";
    scene = read(R"({"duration": 1, "tick_hz": 60, "frames_per_second": 144})");
    ASSERT_TRUE(scene) << scene.error();
    EXPECT_EQ(scene->frame_count(), 145);
    EXPECT_EQ(scene->frame_times().step_of_frame(144), 144);
}

TEST(MotionPath, IsStraightBetweenPointsAndStaysAtItsEnds) {
    const scene::MotionPath path({{1.0, {0, 0, 0}}, {3.0, {4, 2, 0}}, {4.0, {4, 2, 0}}});
    EXPECT_EQ(path.at(-5.0), glm::dvec3(0, 0, 0));
    EXPECT_EQ(path.at(2.0), glm::dvec3(2, 1, 0));
    EXPECT_EQ(path.at(3.0), glm::dvec3(4, 2, 0));
    EXPECT_EQ(path.at(3.3), glm::dvec3(4, 2, 0)) << "a body that stands still does stand still";
    EXPECT_EQ(path.at(1e9), glm::dvec3(4, 2, 0));
}

TEST(PathCsv, TakesHeaderCommentsSpacesAndDosLineEnds) {
    const auto path = scene::parse_path_csv("# walk\r\n t, x ,y,z\r\n\r\n0, 1, +2.5, -3e-1\r\n  # pause\r\n1,1,1,1", "p.csv");
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
    const auto path = scene::parse_path_csv("0.5,1.5,2.5,3.5\n", "p.csv");
    const auto rejected = read(R"({"duration": -2.5})");
    std::setlocale(LC_ALL, before.c_str());
    ASSERT_TRUE(scene) << scene.error();
    EXPECT_EQ(scene->duration, 2.5);
    EXPECT_EQ(scene->air.cell_size, 0.25f);
    EXPECT_EQ(scene->air.cells.x, 10);
    ASSERT_TRUE(path);
    EXPECT_EQ(path->points()[0].position.z, 3.5);
    ASSERT_FALSE(rejected);
    EXPECT_EQ(rejected.error(), "a.json: $.duration is -2.5 s: give a number above 0, at most 1e6 s.");
}

} // namespace
} // namespace windrow::cli
