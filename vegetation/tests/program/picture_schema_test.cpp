// The schema of scene files and the tables of their keys are what the readers ask for: every key, with its default, range and words.
#include "scene/scene_reader.h"
#include "tests/scene_schema.h"
#include "vegetation/program/picture_writer.h"
#include "vegetation/tests/program/specimen.h"

#include <cstdlib>

namespace windrow::vegetation::program {
namespace {

using nlohmann::json;
using test::Folder;

/// So that each key is asked for; the class's own defaults are stated for grass, which this has.
constexpr const char* k_bare =
    R"({"paths": {"a": {"points": [[0, 0, 0, 0]]}}, "obstacles": [{"shape": {"sphere": {}}}], "picture": {
    "grass": [{"mask": {"strokes": [{"paint": {}}, {"erase": {}}]}}], "trees": [{"places": [{}], "scatter": {"clear": [{}]}}], "fans": [{}], "ground_memory": {},
    "bodies": [{"mesh": {"file": {"name": "a.obj"}}, "skeleton": {"kind": "own", "bones": [{"swings": [{}]}]},
                "coats": [{"spots": [{}], "inertia": {}, "cloud": {}}]},
               {"mesh": {"sheet": {}}}, {"mesh": {"globe_sphere": {}}}, {"mesh": {"cube_sphere": {}}}, {"mesh": {"wing": {}}}, {"mesh": {"beast": {}}}],
    "obstacles": [{"windows": {}}], "lamps": [{}],
    "walkers": [{"path": "a", "airborne": [{"from": 0, "until": 1}]}]}})";

TEST(PictureSchema, IsMadeOfTheReadersKeys) {
    std::vector<windrow::scene::KnownKey> known;
    for (const char* text : {windrow::test::k_scene_with_every_key, "{}"}) {
        const auto scene =
            windrow::scene::read_scene_text(text, std::filesystem::path(WINDROW_SOURCE_DIR) / "examples/scenes/a.json", &known);
        ASSERT_TRUE(scene) << scene.error();
    }
    const auto scene = read_picture_scene_text(k_bare, "a.json", &known);
    ASSERT_TRUE(scene) << scene.error();
    EXPECT_GE(known.size(), 350u);
    windrow::test::SchemaNode root;
    for (const windrow::scene::KnownKey& key : known) {
        EXPECT_FALSE(key.meaning.empty() && key.is_value()) << key.pattern << " has no meaning";
        root.add(key);
    }
    windrow::test::OrderedJson schema{
        {"$schema", "https://json-schema.org/draft/2020-12/schema"},
        {"title", "Windrow scene"},
        {"description",
         "The air around a follower, what moves in it and acts on it, and what is kept of a run. Right-handed, y up, "
         "metres and seconds. Every key may be left out unless it is required; an unknown key is rejected. Made by "
         "./dev schema."}};
    schema.update(root.object_schema());
    std::string text;
    windrow::test::write_json(text, schema);
    const std::filesystem::path source = WINDROW_SOURCE_DIR;
    windrow::test::expect_file(source / "examples/scenes/scene.schema.json", text + "\n");
    std::string tables =
        "# Keys of a scene\n\nEvery key of a scene file, made by `./dev schema` from the tables of validation, reader and "
        "schema.\nA name in brackets is a kind: `motors[](wake)`.\n";
    root.write_tables(tables);
    windrow::test::expect_file(source / "docs/scene_keys.md", tables);
}

TEST(PictureSchema, EveryObjectRejectsUnknownKeys) {
    const Folder folder;
    test::write_sample_files(folder);
    const json specimen = json::parse(test::k_sample_values);
    const json flat = specimen["picture"].flatten();
    std::vector<std::string> pointers = {"/picture"};
    for (const auto& [pointer, value] : flat.items())
        for (std::size_t slash = pointer.find('/', 1); slash != std::string::npos; slash = pointer.find('/', slash + 1))
            pointers.push_back("/picture" + pointer.substr(0, slash));
    int tried = 0;
    for (const std::string& pointer : pointers) {
        json broken = specimen;
        json& place = broken[json::json_pointer(pointer)];
        if (!place.is_object())
            continue;
        place["zebra"] = 1;
        const auto scene = read_picture_scene_text(broken.dump(), folder / "a.json");
        ASSERT_FALSE(scene) << pointer;
        EXPECT_NE(scene.error().find("zebra is not a known key"), std::string::npos) << scene.error();
        ++tried;
    }
    EXPECT_GE(tried, 40);
}

TEST(PictureSchema, SpecimenAndWhatIsWrittenKeepIt) {
    if (std::system("python3 -c 'import jsonschema' 2>/dev/null") != 0)
        FAIL() << "python3-jsonschema is not installed: ./dev setup does it";
    const Folder folder;
    test::write_sample_files(folder);
    const auto scene = read_picture_scene_text(test::k_sample_values, folder / "a.json");
    ASSERT_TRUE(scene) << scene.error();
    json whole = json::parse(test::k_sample_values), defaults = json::object(), wrong = whole;
    whole["picture"] = write_picture(*scene);
    const auto plain = read_picture_scene_text("{}", "a.json");
    ASSERT_TRUE(plain) << plain.error();
    defaults["picture"] = write_picture(*plain);
    wrong["picture"]["grass"][0]["look"]["glos"] = 1;
    folder.write("specimen.json", test::k_sample_values);
    folder.write("whole.json", whole.dump());
    folder.write("defaults.json", defaults.dump());
    folder.write("wrong.json", wrong.dump());
    folder.write("check.py", "import json, sys\n"
                             "from jsonschema.validators import validator_for\n"
                             "schema = json.load(open(sys.argv[1], encoding='utf-8'))\n"
                             "kind = validator_for(schema); kind.check_schema(schema)\n"
                             "for name in sys.argv[2:]:\n"
                             "    if not kind(schema).is_valid(json.load(open(name, encoding='utf-8'))): sys.exit(name)\n");
    const auto check = [&](const char* file) {
        return std::system(("python3 '" + (folder / "check.py").string() +
                            "' '" WINDROW_SOURCE_DIR "/examples/scenes/scene.schema.json' '" + (folder / file).string() +
                            "' 2>/dev/null")
                               .c_str());
    };
    for (const char* file : {"specimen.json", "whole.json", "defaults.json"})
        EXPECT_EQ(check(file), 0) << file;
    EXPECT_NE(check("wrong.json"), 0);
}

} // namespace
} // namespace windrow::vegetation::program
