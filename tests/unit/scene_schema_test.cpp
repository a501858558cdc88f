// Reader and schema say the same: every key, with its default, range and words.
#include "scene/json_document.h"
#include "scene/motor_reader.h"
#include "scene/scene_reader.h"
#include "tests/schema_walk.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <string>

namespace windrow::scene {
namespace {

using nlohmann::json;
using test::expect_same_keys;
using test::Keys;
using test::keys_of;
using test::load_schema;
using test::SchemaWalk;

const std::filesystem::path k_scenes = std::filesystem::path(WINDROW_SOURCE_DIR) / "examples" / "scenes";

/// One of each kind of thing, so that each key is asked for.
constexpr const char* k_specimen = R"({
    "air": {"sides": {"x_low": {"kind": "open"}, "x_high": {}, "y_low": {"kind": "free_slip"}, "y_high": {}, "z_low": {}, "z_high": {}}, "profile": {}, "gusts": {}},
    "paths": {"a": {"points": [[0, 0, 0, 0]]}, "b": {"file": "walk_player.csv"}},
    "motors": [
        {"kind": "directional", "region": {"sphere": {}}, "law": {"force": {}}},
        {"kind": "directional", "region": {"capsule": {}}, "law": {"drive": {}}},
        {"kind": "directional", "region": {"box": {}}},
        {"kind": "directional", "region": {"cone": {}}, "envelope": {"attack": 1, "hold": 1, "decay": 1},
         "turbulence": {}},
        {"kind": "wake", "path": "a", "law": {"force": {}}, "envelope": {}, "turbulence": {}},
        {"kind": "wake", "path": "a", "law": {"drive": {}}},
        {"kind": "jet", "law": {"force": {}}, "envelope": {}, "turbulence": {}},
        {"kind": "jet", "law": {"drive": {}}},
        {"kind": "vortex", "law": {"force": {}}, "envelope": {}},
        {"kind": "vortex", "law": {"drive": {}}},
        {"kind": "omni", "envelope": {}},
        {"kind": "pressure"}
    ]})";

Keys keys_of_reader() {
    std::vector<KnownKey> known;
    for (const char* text : {k_specimen, "{}"}) {
        const auto scene = read_scene_text(text, k_scenes / "specimen.json", &known);
        EXPECT_TRUE(scene) << scene.error();
    }
    return keys_of(known);
}

/// Every scene that comes with the project.
std::vector<std::filesystem::path> scenes() {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(k_scenes))
        if (entry.path().extension() == ".json" && entry.path().filename() != "scene.schema.json")
            files.push_back(entry.path());
    return files;
}

TEST(Schema, KnowsTheReadersKeysWithTheirDefaultsAndRanges) {
    Keys stated = SchemaWalk(load_schema()).keys();
    // vegetation/tests/program tests these.
    std::erase_if(stated, [](const auto& key) { return key.first.starts_with("$.picture."); });
    const Keys read = keys_of_reader();
    expect_same_keys(stated, read, {"$.name"}); // the name's default is the file's, which no schema can state
}

TEST(Schema, SpecimenHoldsEachKindOfMotor) {
    for (const MotorKind& kind : motor_kinds())
        EXPECT_NE(std::string(k_specimen).find(std::string("\"kind\": \"") + kind.name + "\""), std::string::npos)
            << kind.name << ": add one to the specimen, so that its keys are compared";
}

TEST(Schema, EveryObjectRefusesUnknownKeys) {
    // Each object of the specimen in turn gets a key that nobody knows; both reader and schema must refuse it.
    const json specimen = json::parse(k_specimen);
    std::vector<std::string> pointers = {""};
    const json flat = specimen.flatten();
    for (const auto& [pointer, value] : flat.items()) {
        pointers.push_back(pointer);
        for (std::size_t slash = pointer.find('/', 1); slash != std::string::npos; slash = pointer.find('/', slash + 1))
            pointers.push_back(pointer.substr(0, slash));
    }
    for (const std::string& pointer : pointers) {
        json broken = specimen;
        json& place = broken[json::json_pointer(pointer)];
        if (!place.is_object() || pointer == "/paths")
            continue;
        place["zebra"] = 1;
        const auto scene = read_scene_text(broken.dump(), k_scenes / "specimen.json");
        ASSERT_FALSE(scene) << pointer;
        EXPECT_NE(scene.error().find("zebra is not a known key"), std::string::npos) << scene.error();
    }
}

TEST(Schema, ReaderTakesEveryScene) {
    EXPECT_GE(scenes().size(), 11u);
    for (const std::filesystem::path& file : scenes()) {
        const auto scene = read_scene(file);
        EXPECT_TRUE(scene) << scene.error();
    }
}

TEST(Schema, ScenesKeepTheSchema) {
    if (std::system("python3 -c 'import jsonschema' 2>/dev/null") != 0)
        FAIL() << "python3-jsonschema is not installed: ./dev setup does it";
    const std::string script = "import json, sys\n"
                               "from jsonschema.validators import validator_for\n"
                               "schema = json.load(open(sys.argv[1], encoding='utf-8'))\n"
                               "kind = validator_for(schema); kind.check_schema(schema)\n"
                               "for name in sys.argv[2:]:\n"
                               "    kind(schema).validate(json.load(open(name, encoding='utf-8')))\n";
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "windrow_schema_test";
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "check.py") << script;
    std::ofstream(folder / "specimen.json") << k_specimen;
    std::string command = "python3 '" + (folder / "check.py").string() + "' '" + (k_scenes / "scene.schema.json").string() +
                          "' '" + (folder / "specimen.json").string() + "'";
    for (const std::filesystem::path& scene : scenes())
        command += " '" + scene.string() + "'";
    EXPECT_EQ(std::system(command.c_str()), 0);
    std::filesystem::remove_all(folder);
}

} // namespace
} // namespace windrow::scene
