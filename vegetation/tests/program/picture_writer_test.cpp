// File to structure to file: nothing is lost, and nothing is made up.
#include "vegetation/program/picture_writer.h"
#include "vegetation/tests/program/specimen.h"

#include <cctype>

namespace windrow::vegetation::program {
namespace {

using nlohmann::json;
using test::Folder;

/// A scene whose picture is this, in the specimen's air.
std::string with_picture(json picture) {
    json document = json::parse(test::k_sample_values);
    document["picture"] = std::move(picture);
    return document.dump(4);
}

TEST(PictureWriter, FileThatSaysEverythingComesBackIdentical) {
    const Folder folder;
    test::write_sample_files(folder);
    const auto scene = read_picture_scene_text(test::k_sample_values, folder / "a.json");
    ASSERT_TRUE(scene) << scene.error();
    ASSERT_FALSE(scene->air.obstacles.empty()) << "the ground is in the air";
    const windrow::Obstacle& body = scene->air.obstacles.back().obstacle;
    EXPECT_EQ(body.position, scene->picture.ground.corner);
    ASSERT_TRUE(std::holds_alternative<windrow::Ground>(body.shape));
    EXPECT_EQ(*std::get<windrow::Ground>(body.shape).heights, *scene->picture.ground.heights);
    // The second layer and walker say little; what is written says all, so it is compared after one more round.
    const json given = json::parse(test::k_sample_values)["picture"], first = write_picture(*scene);
    for (const auto& [key, value] : given.items()) {
        if (key != "grass" && key != "walkers" && key != "bodies") {
            EXPECT_EQ(value, first[key]) << key;
            continue;
        }
        EXPECT_EQ(value[0], first[key][0]) << key;
    }
    EXPECT_EQ(given.size(), first.size());
    const std::string text = with_picture(first);
    const auto again = read_picture_scene_text(text, folder / "a.json");
    ASSERT_TRUE(again) << again.error();
    EXPECT_EQ(with_picture(write_picture(*again)), text);
}

TEST(PictureWriter, DefaultsWrittenOutAreTheDefaults) {
    const auto scene = read_picture_scene_text(R"({"picture": {"grass": [{}], "ground_memory": {}}})", "a.json");
    ASSERT_TRUE(scene) << scene.error();
    const json written = write_picture(*scene);
    const auto again = read_picture_scene_text(json{{"picture", written}}.dump(), "a.json");
    ASSERT_TRUE(again) << again.error();
    EXPECT_EQ(write_picture(*again), written);
    const grass::GrassSettings defaults, &read = again->picture.grass[0].drawn.field;
    EXPECT_EQ(read.blade.stalk.rigidity, defaults.blade.stalk.rigidity);
    EXPECT_EQ(read.min_width, defaults.min_width);
    EXPECT_EQ(again->picture.sun.radius_deg, render::Sun{}.radius_deg);
    EXPECT_EQ(again->picture.grass[0].drawn.look.through, render::PlantLook{}.through);
    EXPECT_EQ(again->picture.ground_memory->spring.damping, windrow::GroundConfig{}.spring.damping);
}

TEST(PictureWriter, SpecimenSaysSomethingElseThanEachDefault) {
    // Else a key that reader and writer both dropped would come back all the same.
    const auto plain = read_picture_scene_text(
        R"({"paths": {"a": {"points": [[0, 0, 0, 0]]}}, "picture": {"grass": [{"mask": {"strokes": [{"paint": {}}, {"erase": {}}]}}], "trees": [{"places": [{}], "scatter": {"clear": [{}]}}], "fans": [{}], "ground_memory": {},
            "bodies": [{"mesh": {"file": {"name": "a.obj"}}, "skeleton": {"kind": "own", "bones": [{"swings": [{}]}]}, "coats": [{"spots": [{}], "inertia": {}, "cloud": {}}]}],
            "lamps": [{}], "walkers": [{"path": "a", "airborne": [{"from": 0, "until": 1}]}]}})",
        "a.json");
    ASSERT_TRUE(plain) << plain.error();
    const json defaults = write_picture(*plain), given = json::parse(test::k_sample_values)["picture"];
    const json flat = defaults.flatten();
    for (const auto& [pointer, value] : flat.items()) {
        // A vector may keep one of its three.
        const bool part = std::isdigit(static_cast<unsigned char>(pointer.back())) != 0;
        const json::json_pointer place(part ? pointer.substr(0, pointer.rfind('/')) : pointer);
        if (pointer.starts_with("/camera/position") || pointer.starts_with("/camera/target")) // the specimen has paths
            continue;
        if (pointer == "/bodies/0/skeleton/kind") // both have bones of their own
            continue;
        ASSERT_TRUE(given.contains(place)) << pointer;
        EXPECT_NE(defaults.at(place), given.at(place)) << pointer;
    }
}

TEST(PictureWriter, NumbersHaveTheDigitsThatNameThem) {
    const auto scene = read_picture_scene_text(
        R"({"picture": {"fog": {"density": 0.0015, "fall": 1e-7}, "sun": {"irradiance": 16777217}}})", "a.json");
    ASSERT_FALSE(scene); // too large; the float next to it has other digits
    const auto good =
        read_picture_scene_text(R"({"picture": {"fog": {"density": 0.0015, "fall": 1e-7, "base": 0.1}}})", "a.json");
    ASSERT_TRUE(good) << good.error();
    EXPECT_EQ(write_picture(*good)["fog"].dump(), R"({"base":0.1,"density":0.0015,"fall":1e-07})");
}

} // namespace
} // namespace windrow::vegetation::program
