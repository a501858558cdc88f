// Scenes that are rejected, and the sentence that each gets: file, place, value, fix.
#include "scene/motion_path.h"
#include "scene/nearest_word.h"
#include "scene/scene_reader.h"
#include "tests/own_folder.h"

namespace windrow::scene {
namespace {

/// The sentences with which a text is rejected; empty where it is taken.
std::string rejection(const std::string& text) {
    const auto scene = read_scene_text(text, "a.json");
    return scene ? std::string() : scene.error();
}

void expect_rejection(const std::string& text, const std::string& sentence) {
    EXPECT_EQ(rejection(text), sentence) << text;
}

TEST(SceneFault, TextThatIsNoJson) {
    expect_rejection(R"({"name": "x",)",
                     "a.json:1:14: the file ends in the middle of the JSON: was it cut short, or is a closing bracket missing?");
    expect_rejection("{\n  \"duration\": NaN\n}", "a.json:2:15: NaN is not a JSON number: give a finite number.");
    expect_rejection("{\"duration\": -Infinity}", "a.json:1:15: -Infinity is not a JSON number: give a finite number.");
    expect_rejection("{\"duration\": 1e999}",
                     "a.json:1:18: the number 1e999 is too large: give one that fits a double (up to 1.8e308).");
    expect_rejection("{\n  \"duration\": 3,\n}", "a.json:3:1: trailing comma before '}': remove it.");
    expect_rejection("{\n// fast\n}", "a.json:2:1: JSON has no comments: remove it, or write it in \"description\".");
    expect_rejection("{'a': 1}", "a.json:1:2: JSON takes double quotes only: write \" instead of '.");
    EXPECT_TRUE(rejection("{\"a\" 1}").starts_with("a.json:1:6: is not JSON: ")) << rejection("{\"a\" 1}");
    EXPECT_TRUE(rejection("{} {}").starts_with("a.json:1:4: is not JSON: ")) << rejection("{} {}");
    expect_rejection("[]", "a.json: $ is []: give an object, {...}.");
}

TEST(SceneFault, EveryBeginningOfASceneIsRejectedWithItsPlace) {
    const std::string whole = test::text_of(WINDROW_SOURCE_DIR "/examples/scenes/walk.json");
    const std::size_t end = whole.find_last_of('}');
    ASSERT_GT(end, 1000u);
    for (std::size_t size = 0; size < end; ++size)
        EXPECT_TRUE(rejection(whole.substr(0, size)).starts_with("a.json:")) << size;
}

TEST(SceneFault, KeyThatStandsTwice) {
    expect_rejection(R"({"motors": [{"kind": "wake"}, {"law": {"force": {}, "force": {}}}]})",
                     "a.json: $.motors[1].law.force is a duplicate key: remove one of the two.");
    expect_rejection(R"({"paths": {"a b": {"points": []}, "a b": {}}})",
                     "a.json: $.paths[\"a b\"] is a duplicate key: remove one of the two.");
}

TEST(SceneFault, NestingWithoutEnd) {
    const std::string deep = R"({"air": )" + std::string(100'000, '[');
    EXPECT_TRUE(rejection(deep).ends_with("is nested deeper than 32 levels: a scene needs no more than 8.")) << rejection(deep);
}

TEST(SceneFault, WrongTypes) {
    expect_rejection(R"({"duration": "20"})", "a.json: $.duration is \"20\": give a number.");
    expect_rejection(R"({"name": 3})", "a.json: $.name is 3: give a string in double quotes.");
    expect_rejection(R"({"air": [1]})", "a.json: $.air is [1]: give an object, {...}.");
    expect_rejection(R"({"air": null})", "a.json: $.air is null: give an object, {...}.");
    expect_rejection(R"({"motors": {}})", "a.json: $.motors is {}: give a list, [...].");
    expect_rejection(R"({"air": {"ambient": [1, 2]}})", "a.json: $.air.ambient is [1,2]: give three numbers, [x, y, z].");
    expect_rejection(R"({"air": {"ambient": [1, 2, true]}})", "a.json: $.air.ambient[2] is true: give a number.");
    expect_rejection(R"({"air": {"follow_axes": [1, 0, 1]}})",
                     "a.json: $.air.follow_axes is [1,0,1]: give true or false for each axis, [x, y, z].");
    expect_rejection(R"({"air": {"scheme": "stam"}})",
                     "a.json: $.air.scheme is \"stam\": give one of \"second_order\", \"stable_fluids\".");
    expect_rejection(R"({"vdb": {"three_scalars": 1}})", "a.json: $.vdb.three_scalars is 1: give true or false.");
    expect_rejection(R"({"air": {"cells": [32, 16.5, 32]}})", "a.json: $.air.cells[1] is 16.5: give a whole number.");
}

TEST(SceneFault, Ranges) {
    expect_rejection(R"({"air": {"cells": [0, 16, 32]}})", "a.json: $.air.cells[0] is 0 cells: give 1 to 2048 cells.");
    expect_rejection(R"({"air": {"cells": [32, 16, 500000]}})", "a.json: $.air.cells[2] is 500000 cells: give 1 to 2048 cells.");
    expect_rejection(R"({"air": {"cells": [2048, 2048, 2048]}})",
                     "a.json: $.air.cells is (2048, 2048, 2048), 8589934592 in all: give at most 67108864.");
    expect_rejection(R"({"air": {"cell_size": 1e308}})", "a.json: $.air.cell_size is 1e308 m: give 1e-6 to 1e6 m.");
    expect_rejection(R"({"air": {"ambient": [1e308, 0, 0]}})",
                     "a.json: $.air.ambient[0] is 1e308 m/s: give -10000 to 10000 m/s.");
    expect_rejection(R"({"tick_hz": 0})", "a.json: $.tick_hz is 0 Hz: give 1 to 10000 Hz.");
    expect_rejection(R"({"vdb": {"grids": {"density": true}}})",
                     "a.json: $.vdb.grids asks for density, and no smoke makes any: add $.smoke, or remove it.");
    expect_rejection(R"({"vdb": {"margin": 3, "box": {}}})",
                     "a.json: $.vdb holds both \"margin\" and \"box\": keep one of them.");
    expect_rejection(R"({"duration": 1e6, "tick_hz": 1000, "frames_per_second": 1000})",
                     "a.json: $.duration is 1e6 s, 1000000001 frames: give at most 100000 frames, by a shorter duration or fewer "
                     "frames_per_second.");
    expect_rejection(
        R"({"duration": 1e6, "tick_hz": 1000, "frames_per_second": 0.01})",
        "a.json: $.duration is 1e6 s, 1000000000 steps: give at most 10000000 steps, by a shorter duration or a lower tick_hz.");
    expect_rejection(R"({"motors": [{"kind": "directional", "region": {"sphere": {"radius": -1}}}]})",
                     "a.json: $.motors[0].region.sphere.radius is -1 m: give a number above 0, at most 1e6 m.");
    expect_rejection(R"({"motors": [{"kind": "directional", "direction": [0, 0, 0]}]})",
                     "a.json: $.motors[0].direction is [0,0,0]: give a finite vector that is not 0.");
    // Small enough for each number alone, too long together: the library's own words with the scene's place.
    expect_rejection(R"({"motors": [{"kind": "directional", "region": {"capsule": {"half_axis": [1e6, 1e6, 0]}}}]})",
                     "a.json: $.motors[0].region.capsule.half_axis is [1000000.0,1000000.0,0]: give a length of 0 to 1e6 m.");
}

TEST(SceneFault, MotorsOfEachKind) {
    const auto motor = [](const std::string& keys) { return R"({"motors": [{)" + keys + "}]}"; };
    expect_rejection(motor(R"("kind": "jet", "start_radius": 0, "length": -1)"),
                     "a.json: $.motors[0].length is -1 m: give a number above 0, at most 1e6 m.\n"
                     "a.json: $.motors[0].start_radius is 0 m: give a number above 0, at most 1e6 m.");
    expect_rejection(motor(R"("kind": "vortex", "axis": [0, 0, 0], "lift": 11)"),
                     "a.json: $.motors[0].axis is [0,0,0]: give a finite vector that is not 0.\n"
                     "a.json: $.motors[0].lift is 11: give -10 to 10.");
    expect_rejection(motor(R"("kind": "omni", "speed": 1e5)"),
                     "a.json: $.motors[0].speed is 100000 m/s: give -10000 to 10000 m/s.");
    expect_rejection(motor(R"("kind": "omni", "law": {})"),
                     "a.json: $.motors[0].law is not a known key (known: kind, name, from, until, position, path, radius, speed, "
                     "envelope): rename or remove it.");
    expect_rejection(motor(R"("kind": "pressure", "duration": 0)"),
                     "a.json: $.motors[0].duration is 0 s: give a number above 0, at most 1e9 s.");
    expect_rejection(
        motor(R"("kind": "pressure", "envelope": {})"),
        "a.json: $.motors[0].envelope is not a known key (known: kind, name, from, until, position, path, radius, speed, "
        "duration): rename or remove it.");
    expect_rejection(motor(R"("kind": "directional", "region": {"cone": {"axis": [0, 0, 0]}})"),
                     "a.json: $.motors[0].region.cone.axis is [0,0,0]: give a length of 1e-6 to 1e6 m.");
}

TEST(SceneFault, Envelopes) {
    const auto envelope = [](const std::string& keys) { return R"({"motors": [{"kind": "jet", "envelope": {)" + keys + "}}]}"; };
    expect_rejection(
        envelope(R"("decay": 2)"),
        "a.json: $.motors[0].envelope.decay never begins without a \"hold\": say how long the motor acts before it.");
    expect_rejection(envelope(R"("hold": 0)"), "a.json: $.motors[0].envelope lasts 0 s: set attack, hold or decay above 0.");
    expect_rejection(envelope(R"("attack": -1)"), "a.json: $.motors[0].envelope.attack is -1 s: give 0 to 1e9 s.");
}

TEST(SceneFault, AmbientWind) {
    expect_rejection(R"({"air": {"profile": {"roughness_length": 0}}})",
                     "a.json: $.air.profile.roughness_length is 0 m: give 1e-6 to 100 m.");
    expect_rejection(R"({"air": {"gusts": {"intensity": 2, "seed": 1.5}}})",
                     "a.json: $.air.gusts.intensity is 2: give 0 (none) to 1.\n"
                     "a.json: $.air.gusts.seed is 1.5: give a whole number.");
    expect_rejection(R"({"air": {"blend_width": -1, "sleep_speed": -1}})",
                     "a.json: $.air.blend_width is -1 cells: give 0 (none) to 64 cells.\n"
                     "a.json: $.air.sleep_speed is -1 m/s: give 0 (never) to 10000 m/s.");
}

TEST(SceneFault, KeysThatNobodyKnows) {
    expect_rejection(R"({"durration": 3})",
                     "a.json: $.durration is not a known key (did you mean `duration`?): rename or remove it.");
    expect_rejection(R"({"air": {"cell_sise": 3}})",
                     "a.json: $.air.cell_sise is not a known key (did you mean `cell_size`?): rename or remove it.");
    expect_rejection(R"({"air": {"sides": {}}})",
                     "a.json: $.air.sides is now called \"boundaries\": rename it, or run ./dev rename-scene on the file.");
    EXPECT_TRUE(
        rejection(R"({"pictures": {"zebra": 3}})")
            .starts_with(
                "a.json: $.pictures.zebra is not a known key (known: slice_height, above_ground, slice_z, speed_scale, width, "
                "flow): rename or remove it."));
    expect_rejection(R"({"motors": [{"kind": "wake", "path": "p", "raduis": 1}], "paths": {"p": {"points": [[0, 0, 0, 0]]}}})",
                     "a.json: $.motors[0].raduis is not a known key (did you mean `radius`?): rename or remove it.");
}

TEST(SceneFault, AllFaultsAreTold) {
    expect_rejection(R"({"duration": 0, "air": {"cell_size": 0, "viscosity": -1}, "frame": 2})",
                     "a.json: $.duration is 0 s: give a number above 0, at most 1e6 s.\n"
                     "a.json: $.air.cell_size is 0 m: give 1e-6 to 1e6 m.\n"
                     "a.json: $.air.viscosity is -1 m^2/s: give 0 to 1e9 m^2/s.\n"
                     "a.json: $.frame is not a known key (did you mean `frames_per_second`?): rename or remove it.");
}

TEST(SceneFault, WhatDoesNotFitTogether) {
    expect_rejection(
        R"({"follow": "plyer", "paths": {"player": {"points": [[0, 0, 0, 0]]}}})",
        "a.json: $.follow is \"plyer\", which is not in $.paths (did you mean `player`?): add it there or name another.");
    expect_rejection(R"({"floor": 1})", "a.json: $.floor is given, but the box has none: set air.boundaries.y_low to "
                                        "\"free_slip\" or \"no_slip\", or remove it.");
    expect_rejection(R"({"motors": [{"kind": "wake"}]})", "a.json: $.motors[0] has no \"path\": add it.");
    expect_rejection(R"({"motors": [{}]})", "a.json: $.motors[0] has no \"kind\": add it.");
    expect_rejection(
        R"({"motors": [{"kind": "whirl"}]})",
        "a.json: $.motors[0].kind is \"whirl\": give one of \"directional\", \"wake\", \"jet\", \"vortex\", \"omni\", "
        "\"pressure\".");
    expect_rejection(R"({"motors": [{"kind": "directional", "law": {"force": {}, "drive": {}}}]})",
                     "a.json: $.motors[0].law holds more than one of \"force\" or \"drive\": keep one of them.");
    expect_rejection(R"({"motors": [{"kind": "directional", "from": 3, "until": 2}]})",
                     "a.json: $.motors[0].until is 2 s but the motor begins at 3 s: give a later time.");
    expect_rejection(R"({"paths": {"p": {"points": [[0, 0, 0, 0], [2, 0, 0, 0], [1, 0, 0, 0]]}}})",
                     "a.json: $.paths.p.points[2] has t = 1 s after 2 s: times must increase from point to point.");
    expect_rejection(R"({"paths": {"p": {"points": []}}})",
                     "a.json: $.paths.p.points is empty: give at least one point, [t, x, y, z].");
    expect_rejection(R"({"paths": {"p": {}}})", "a.json: $.paths.p holds neither \"points\" or \"file\": give one of them.");
    expect_rejection(
        R"({"air": {"boundaries": {"x_low": "periodic"}}})",
        "a.json: $.air.boundaries.x_high is not periodic, but the opposite boundary is: make both boundaries of the axis "
        "periodic, or neither.");
}

TEST(SceneFault, TablesOutsideTheFolder) {
    for (const char* file : {"/etc/passwd", "../player.csv", "a/../../player.csv", ".", ""})
        EXPECT_EQ(rejection(std::string(R"({"paths": {"p": {"file": ")") + file + "\"}}}"),
                  std::string("a.json: $.paths.p.file is \"") + file +
                      "\": name a file in the scene's folder, relative to it, so that the folder can be copied as a whole.");
    expect_rejection(R"({"paths": {"p": {"file": "none.csv"}}})",
                     "none.csv: no such file: check the name, which is sought beside the file that gives it.");
}

TEST(SceneFault, FilesThatCannotBeRead) {
    const test::OwnFolder folder;
    const auto fault = [&](const std::string& name) {
        const auto scene = read_scene(folder / name);
        return scene ? std::string("taken") : scene.error().substr(folder.path().string().size() + 1);
    };
    EXPECT_EQ(fault("none.json"), "none.json: no such file: check the name and the current folder.");
    EXPECT_EQ(read_scene(folder.path()).error(), folder.path().string() + ": is a folder: name a file in it.");
    std::ofstream(folder / "empty.json") << "\n  \n";
    EXPECT_EQ(fault("empty.json"), "empty.json: is empty: name the right file, or write something in it.");
    std::ofstream(folder / "latin1.json") << "{\n\"name\": \"Wiese b\xe4uerlich\"}";
    EXPECT_EQ(fault("latin1.json"),
              "latin1.json:2: byte 19 (value 228) is not UTF-8 text: save the file as UTF-8, or name the right file.");
    std::ofstream(folder / "mark.json") << "\xef\xbb\xbf{\"name\": \"Wiese b\xc3\xa4uerlich\"}";
    EXPECT_EQ(fault("mark.json"), "taken") << "a byte-order mark is no fault";
    std::ofstream(folder / "large.json") << std::string(17 << 20, ' ') << "{}";
    EXPECT_EQ(fault("large.json"), "large.json: is larger than 16 MiB, the most that is read: give a smaller file.");
}

TEST(PathCsv, NamesTheLineOfAFault) {
    const auto fault = [](const std::string& text) {
        const auto path = parse_path_csv(text, "p.csv");
        return path ? std::string() : path.error();
    };
    EXPECT_EQ(fault("t,x,y,z\n0,0,0,0\n1,2,3\n"), "p.csv:3: has 3 fields: give four, t,x,y,z, with commas between them.");
    EXPECT_EQ(fault("0;0;0;0\n"), "p.csv:1: has 1 field: give four, t,x,y,z, with commas between them.");
    EXPECT_EQ(fault("0,0,0,0\n1,a,0,0\n"), "p.csv:2: x is \"a\": give a finite number.");
    EXPECT_EQ(fault("0,0,nan,0\n"), "p.csv:1: y is \"nan\": give a finite number.");
    EXPECT_EQ(fault("0,0,1e308,0\n"), "p.csv:1: y is 1e308: give -1e9 to 1e9.");
    EXPECT_EQ(fault("0,0,1e999,0\n"), "p.csv:1: y is \"1e999\": give a finite number.");
    EXPECT_EQ(fault("# c\n0,0,0,0\n2,0,0,0\n1,0,0,0\n"), "p.csv:4: t is 1 s after 2 s: times must increase from line to line.");
    EXPECT_EQ(fault("x,y,z,t\n0,0,0,0\n"), "p.csv:1: the names of the columns are \"x,y,z,t\": put the columns in the order "
                                           "t,x,y,z and name them so, or leave the names out.");
    EXPECT_EQ(fault("t,x,y,z\n"), "p.csv: holds no point: give at least one line t,x,y,z.");
}

TEST(NearestWord, FindsSlipsAndNothingElse) {
    const std::vector<std::string> known = {"radius", "region", "law"};
    EXPECT_EQ(nearest_word("raduis", known), "radius");
    EXPECT_EQ(nearest_word("rad", known), "radius");
    EXPECT_EQ(nearest_word("lwa", known), "law");
    EXPECT_EQ(nearest_word("zebra", known), "");
    EXPECT_EQ(nearest_word(std::string(1 << 20, 'r'), known), "");
}

} // namespace
} // namespace windrow::scene
