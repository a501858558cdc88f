// The schema of scene files holds for every scene, and rejects what the reader rejects. That it is what the reader asks for, the
// tests of pictures show (PictureSchema), which know all keys.
#include "scene/json_document.h"
#include "scene/scene_reader.h"
#include "tests/scene_schema.h"

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
using test::k_scene_with_every_key;

const std::filesystem::path k_scenes = std::filesystem::path(WINDROW_SOURCE_DIR) / "examples" / "scenes";

/// Every scene that comes with the project.
std::vector<std::filesystem::path> scenes() {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(k_scenes))
        if (entry.path().extension() == ".json" && entry.path().filename() != "scene.schema.json")
            files.push_back(entry.path());
    return files;
}

TEST(Schema, SpecimenHoldsEachKindOfMotor) {
    for (const char* kind : k_alternatives<Motor>)
        EXPECT_NE(std::string(k_scene_with_every_key).find(std::string("\"kind\": \"") + kind + "\""), std::string::npos)
            << kind << ": add one to the specimen, so that the schema has its keys";
}

TEST(Schema, EveryObjectRejectsUnknownKeys) {
    // Each object of the specimen in turn gets a key that nobody knows; both reader and schema must reject it.
    const json specimen = json::parse(k_scene_with_every_key);
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
    std::ofstream(folder / "specimen.json") << k_scene_with_every_key;
    std::string command = "python3 '" + (folder / "check.py").string() + "' '" + (k_scenes / "scene.schema.json").string() +
                          "' '" + (folder / "specimen.json").string() + "'";
    for (const std::filesystem::path& scene : scenes())
        command += " '" + scene.string() + "'";
    EXPECT_EQ(std::system(command.c_str()), 0);
    std::filesystem::remove_all(folder);
}

} // namespace
} // namespace windrow::scene
