// Bodies in coats of shells: what their keys say, what is rejected, where a body is at a time.
#include "vegetation/program/body.h"
#include "vegetation/program/picture_writer.h"
#include "vegetation/tests/program/specimen.h"

#include <cmath>
#include <numbers>

namespace windrow::vegetation::program {
namespace {

using nlohmann::json;
using test::Folder;

windrow::Result<PictureScene> read_body(const std::string& body, const std::string& rest = "") {
    return read_picture_scene_text(
        R"({"paths": {"way": {"points": [[0, 0, 0, 0], [2, 0, 0, 4], [4, 4, 0, 4]]}}, "picture": {"bodies": [)" + body + "]" +
            rest + "}}",
        "a.json");
}

std::string body_rejection(const std::string& body, const std::string& rest = "") {
    const auto scene = read_body(body, rest);
    return scene ? std::string() : scene.error();
}

TEST(BodyReader, BodyWithoutKeysStandsAtTheOrigin) {
    const auto scene = read_body(R"({"coats": [{}]})");
    ASSERT_TRUE(scene) << scene.error();
    const Body& body = scene->picture.bodies.at(0);
    EXPECT_TRUE(std::holds_alternative<fur::CubeSphere>(body.mesh));
    const windrow::Pose pose = pose_of(*scene, body, 3.0);
    EXPECT_EQ(pose.position, glm::dvec3(0.0));
    EXPECT_EQ(pose.rotation, glm::dvec4(0.0, 0.0, 0.0, 1.0));
    EXPECT_EQ(body.coats.at(0).coat.layers.shells, windrow::ShellSettings{}.shells);
    EXPECT_FALSE(body.coats.at(0).coat.inertia);
}

TEST(BodyReader, SpecimensCoatIsReadWhole) {
    const Folder folder;
    test::write_sample_files(folder);
    const auto scene = read_picture_scene_text(test::k_sample_values, folder / "a.json");
    ASSERT_TRUE(scene) << scene.error();
    const BodyCoat& coat = scene->picture.bodies.at(0).coats.at(0);
    EXPECT_EQ(coat.material, "fur");
    EXPECT_EQ(coat.coat.layers.shells, 24);
    EXPECT_EQ(coat.coat.wind_at, fur::WindAt::pixel);
    EXPECT_EQ(coat.coat.strands.profile, fur::StrandProfile::centre);
    EXPECT_EQ(coat.coat.maps.length, "length.pgm");
    EXPECT_EQ(coat.coat.maps.projection, fur::Projection::side);
    EXPECT_EQ(coat.coat.spots.at(0).glow, 4.0f);
    EXPECT_EQ(coat.coat.inertia->lag, 0.5);
    EXPECT_EQ(std::get<MeshSource>(scene->picture.bodies[0].mesh).name, "wolf.obj");
    EXPECT_EQ(scene->picture.bodies[0].skeleton.bones.at(1).parent, 0);
    EXPECT_EQ(scene->picture.lamps.at(0).reach, 12.0f);
}

TEST(BodyReader, FurLineGivesWhatTheSceneDoesNotSay) {
    const auto scene = read_body(R"({"mesh": {"file": {"name": "a.obj"}}, "coats": [
        {}, {"layers": {"shells": 20, "length": 0.5}}, {"strands": {"density": 30, "thickness": 2}}]})");
    ASSERT_TRUE(scene) << scene.error();
    const std::vector<BodyCoat>& coats = scene->picture.bodies.at(0).coats;
    const fur::FurLine fur{.shells = 48, .height = 0.419f, .thickness = 2.753f, .resolution = 11.0f};
    const fur::CoatSettings whole = settings_of(coats[0], fur), layers = settings_of(coats[1], fur),
                            strands = settings_of(coats[2], fur), none = settings_of(coats[0], std::nullopt);
    EXPECT_EQ(whole.layers.shells, 48);
    EXPECT_EQ(whole.layers.length, 0.419f);
    EXPECT_EQ(whole.strands.thickness, 2.753f);
    EXPECT_EQ(whole.strands.density, 11.0f);
    EXPECT_EQ(layers.layers.shells, 20);
    EXPECT_EQ(layers.layers.length, 0.5f);
    EXPECT_EQ(layers.strands.density, 11.0f);
    EXPECT_EQ(strands.layers.shells, 48);
    EXPECT_EQ(strands.strands.density, 30.0f);
    EXPECT_EQ(strands.strands.thickness, 2.0f);
    EXPECT_EQ(none.layers.shells, windrow::ShellSettings{}.shells);
    EXPECT_EQ(none.strands.density, fur::StrandFieldSettings{}.density);
}

TEST(BodyReader, WhatTheFurLineSaysIsNotWritten) {
    const auto scene =
        read_body(R"({"mesh": {"file": {"name": "a.obj"}}, "coats": [{"layers": {"shells": 20}}]}, {"coats": [{}]})");
    ASSERT_TRUE(scene) << scene.error();
    const json bodies = write_picture(*scene)["bodies"];
    const json& file = bodies[0]["coats"][0];
    EXPECT_TRUE(file["layers"].contains("shells"));
    EXPECT_FALSE(file["layers"].contains("length"));
    EXPECT_FALSE(file["strands"].contains("density"));
    EXPECT_FALSE(file["strands"].contains("thickness"));
    EXPECT_TRUE(bodies[1]["coats"][0]["layers"].contains("length")); // no file, no fur line
}

TEST(BodyReader, EachKindOfMeshComesBackIdentical) {
    const json given = json::parse(test::k_sample_values)["picture"]["bodies"];
    for (std::size_t n = 1; n < given.size(); ++n) {
        const auto scene = read_body(given[n].dump());
        ASSERT_TRUE(scene) << scene.error();
        EXPECT_EQ(write_picture(*scene)["bodies"][0]["mesh"], given[n]["mesh"]);
    }
}

TEST(BodyReader, Rejections) {
    const auto expect = [](const std::string& body, const std::string& sentence, const std::string& rest = "") {
        EXPECT_EQ(body_rejection(body, rest), sentence) << body;
    };
    expect("3", "a.json: $.picture.bodies[0] is 3: give an object, {...}.");
    expect(
        R"({"mesh": {"file": {"name": "../a.obj"}}})",
        "a.json: $.picture.bodies[0].mesh.file.name is \"../a.obj\": name a file in the scene's folder, relative to it, so that "
        "the folder can be copied as a whole.");
    expect(R"({"mesh": {"file": {}}})",
           "a.json: $.picture.bodies[0].mesh.file.name is missing: name a mesh in the scene's folder, "
           "OBJ, glTF or GLB.");
    expect(R"({"mesh": {"wing": {"span": 0}}})", "a.json: $.picture.bodies[0].mesh.wing.span is 0 m: give 0.01 to 100 m.");
    expect(R"({"motion": {"path": "wey"}})",
           "a.json: $.picture.bodies[0].motion.path is \"wey\", which is not in $.paths (did you mean `way`?): "
           "add it there or name another.");
    expect(R"({"coats": [{"layers": {"shells": 1}}]})",
           "a.json: $.picture.bodies[0].coats[0].layers.shells is 1: give 2 to 4096.");
    expect(
        R"({"coats": [{"layers": {"lenght": 1}}]})",
        "a.json: $.picture.bodies[0].coats[0].layers.lenght is not a known key (did you mean `length`?): rename or remove it.");
    expect(R"({"coats": [{"comb": {"along": [0, 0, 0]}}]})",
           "a.json: $.picture.bodies[0].coats[0].comb.along is [0,0,0]: give a length of 1e-12 to 1e12.");
    expect(R"({"coats": [{"layers": {"down": [0, 0, 0]}}]})",
           "a.json: $.picture.bodies[0].coats[0].layers.down is [0,0,0]: give a finite vector that is not 0.");
    expect(R"({"coats": [{"strands": {"low": 0.9, "high": 0.5}}]})",
           "a.json: $.picture.bodies[0].coats[0].strands.low is 0.9: give at most $.picture.bodies[0].coats[0].strands.high, "
           "which is 0.5.");
    expect(R"({"coats": [{"maps": {"noise_a": "a.pgm"}}]})",
           "a.json: $.picture.bodies[0].coats[0].maps.noise_b is empty and the other is not: give both, or none.");
    expect(
        R"({"coats": [{"maps": {"length": "/etc/passwd"}}]})",
        "a.json: $.picture.bodies[0].coats[0].maps.length is \"/etc/passwd\": name a file in the scene's folder, relative to it, "
        "so that the folder can be copied as a whole.");
    expect(R"({"coats": [{"inertia": {"lag": 0}}]})",
           "a.json: $.picture.bodies[0].coats[0].inertia.lag is 0 s: give a number above 0, at most 60 s.");
    expect(
        R"({"skeleton": {"kind": "own"}})",
        "a.json: $.picture.bodies[0].skeleton.bones has none, and \"kind\" is \"own\": list them, parents first, or name another "
        "kind.");
    expect(R"({"skeleton": {"bones": [{"parent": "hip"}]}})",
           "a.json: $.picture.bodies[0].skeleton.bones[0].parent is \"hip\", and no bone before it has that name: list parents "
           "first.");
    expect("{}", "a.json: $.picture.lamps[0].reach is 0 m: give a number above 0, at most 10000 m.",
           R"(, "lamps": [{"reach": 0}])");
}

TEST(BodyReader, WhatValidateRejectsCannotBeRead) {
    // Each field at twice its largest: the reader's ranges are those of the structure.
    fur::CoatSettings coat;
    coat.look.cel_steps = 9;
    coat.levels.march = 17;
    coat.wind_fraction = std::numeric_limits<float>::quiet_NaN();
    coat.maps.noise_tiles = 0.0f;
    coat.spots.push_back({.radius = 0.0f});
    coat.comb.bend = 1.6f;
    const auto judged = fur::validate(coat);
    ASSERT_FALSE(judged);
    for (const char* field : {"coat.look.cel_steps is 9", "coat.levels.march is 17", "coat.wind_fraction is nan",
                              "coat.maps.noise_tiles is 0", "coat.spots[0].radius is 0", "coat.comb.bend is 1.6"})
        EXPECT_NE(judged.error().find(field), std::string::npos) << field << " in\n" << judged.error();
    coat = {};
    coat.spots.resize(fur::k_max_spots + 1);
    EXPECT_FALSE(fur::validate(coat));
    EXPECT_TRUE(fur::validate(fur::CoatSettings{}));
    EXPECT_TRUE(fur::validate(std::vector<fur::Lamp>(fur::k_max_lamps)));
    EXPECT_FALSE(fur::validate(std::vector<fur::Lamp>(fur::k_max_lamps + 1)));
}

TEST(BodyPose, FollowsItsPathAndFacesAlongIt) {
    const auto scene = read_body(R"({"place": {"position": [0, 0.5, 0]}, "motion": {"path": "way"}})");
    ASSERT_TRUE(scene) << scene.error();
    const Body& body = scene->picture.bodies.at(0);
    const windrow::Pose first = pose_of(*scene, body, 1.0), second = pose_of(*scene, body, 3.0),
                        after = pose_of(*scene, body, 9.0);
    EXPECT_EQ(first.position, glm::dvec3(0.0, 0.5, 2.0));
    EXPECT_NEAR(first.rotation.y, 0.0, 1e-12); // +z as it is
    EXPECT_EQ(second.position, glm::dvec3(2.0, 0.5, 4.0));
    EXPECT_NEAR(second.rotation.y, std::sqrt(0.5), 1e-12); // a quarter about the vertical turns +z to +x
    EXPECT_EQ(after.rotation, second.rotation);            // it waits as it came
}

TEST(BodyPose, SpinSwayAndHop) {
    const auto scene = read_body(
        R"({"motion": {"spin_hz": 0.25, "sway": {"by": [1, 0, 0], "hz": 0.5}, "hop": {"height": 2, "hz": 1, "rest": 0.5}}})");
    ASSERT_TRUE(scene) << scene.error();
    const Body& body = scene->picture.bodies.at(0);
    const windrow::Pose quarter = pose_of(*scene, body, 0.25);
    EXPECT_NEAR(quarter.position.y, 2.0, 1e-12); // the middle of the jump
    EXPECT_NEAR(pose_of(*scene, body, 0.75).position.y, 0.0, 1e-12);
    EXPECT_NEAR(pose_of(*scene, body, 0.5).position.x, 1.0, 1e-12);
    const double half = 2.0 * std::numbers::pi * 0.25 * 0.25 / 2.0;
    EXPECT_NEAR(quarter.rotation.y, std::sin(half), 1e-12);
    EXPECT_NEAR(quarter.rotation.w, std::cos(half), 1e-12);
}

} // namespace
} // namespace windrow::vegetation::program
