// Reader and schema say the same: every key, with its default, range and words.
#include "cli/json_document.h"
#include "cli/motor_reader.h"
#include "cli/scene_reader.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <string>

namespace windrow::cli {
namespace {

using nlohmann::json;

const std::filesystem::path k_scenes = std::filesystem::path(WINDROW_SOURCE_DIR) / "examples" / "scenes";

/// What is said of a key, by the reader or by the schema.
struct Said {
    std::optional<json> fallback;
    std::optional<double> least, most;
    bool above_least = false;
    bool required = false;
    std::vector<std::string> words;
};
using Keys = std::map<std::string, Said>;

/// One of each kind of thing, so that each key is asked for.
constexpr const char* k_specimen = R"({
    "air": {"sides": {"x_low": {"kind": "open"}, "x_high": {}, "y_low": {"kind": "free_slip"}, "y_high": {}, "z_low": {}, "z_high": {}}, "profile": {}, "gusts": {}},
    "paths": {"a": {"points": [[0, 0, 0, 0]]}, "b": {"file": "walk_player.csv"}},
    "motors": [
        {"kind": "directional", "region": {"sphere": {}}, "law": {"force": {}}},
        {"kind": "directional", "region": {"capsule": {}}, "law": {"drive": {}}},
        {"kind": "directional", "region": {"box": {}}},
        {"kind": "directional", "region": {"cone": {}}, "envelope": {"attack": 1, "hold": 1, "decay": 1}},
        {"kind": "wake", "path": "a", "law": {"force": {}}, "envelope": {}},
        {"kind": "wake", "path": "a", "law": {"drive": {}}},
        {"kind": "jet", "law": {"force": {}}, "envelope": {}},
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
    Keys keys;
    for (const KnownKey& key : known) {
        Said& said = keys[key.pattern];
        if (key.fallback)
            said.fallback = key.fallback;
        if (std::isfinite(key.rule.least))
            said.least = key.rule.least;
        if (std::isfinite(key.rule.most))
            said.most = key.rule.most;
        said.above_least = said.above_least || key.rule.above_least;
        said.required = said.required || key.required;
        if (!key.words.empty())
            said.words = key.words;
    }
    return keys;
}

class SchemaWalk {
  public:
    explicit SchemaWalk(const json& schema) : schema_(schema) { walk_object(schema, "$"); }
    [[nodiscard]] const Keys& keys() const { return keys_; }

  private:
    [[nodiscard]] const json& resolve(const json& node) const {
        return node.contains("$ref") ? schema_.at(json::json_pointer(node["$ref"].get<std::string>().substr(1))) : node;
    }

    void walk_object(const json& node, const std::string& pattern) {
        const json properties = node.value("properties", json::object());
        const json required = node.value("required", json::array());
        for (const auto& [key, child] : properties.items()) {
            const std::string below = join_json_path(pattern, key);
            if (std::find(required.begin(), required.end(), key) != required.end())
                keys_[below].required = true;
            // The kind of a motor is told by the list, before its pattern carries it.
            if (child.contains("const"))
                continue;
            walk(child, below);
        }
        if (node.contains("additionalProperties") && node["additionalProperties"].is_object())
            walk_object(node["additionalProperties"], pattern + ".*");
    }

    void walk(const json& node, const std::string& pattern) {
        Said& said = keys_[pattern];
        // A key beside a $ref stands before the same key behind it.
        for (const json* part : {&resolve(node), &node})
            read_part(*part, said);
        const json& target = resolve(node);
        const json choices = target.value("oneOf", json::array());
        for (const json& choice : choices)
            walk(choice, pattern);
        if (target.value("type", "") == "object")
            walk_object(target, pattern);
        if (!target.contains("items"))
            return;
        const json& items = resolve(target["items"]);
        const json kinds = items.value("oneOf", json::array());
        for (const json& choice : kinds) {
            const json& kind = resolve(choice);
            const std::string name = kind["properties"]["kind"]["const"];
            keys_[pattern + "[].kind"].required = true;
            keys_[pattern + "[].kind"].words.push_back(name);
            walk_object(kind, pattern + "[](" + name + ")");
            keys_.erase(pattern + "[](" + name + ").kind");
        }
        read_part(items, said, false);
    }

    static void read_part(const json& part, Said& said, bool with_default = true) {
        if (with_default && part.contains("default"))
            said.fallback = part["default"];
        if (part.contains("minimum"))
            said.least = part["minimum"].get<double>();
        if (part.contains("exclusiveMinimum")) {
            said.least = part["exclusiveMinimum"].get<double>();
            said.above_least = true;
        }
        if (part.contains("maximum"))
            said.most = part["maximum"].get<double>();
        if (part.contains("enum"))
            said.words = part["enum"].get<std::vector<std::string>>();
    }

    const json& schema_;
    Keys keys_;
};

/// Every scene that comes with the project.
std::vector<std::filesystem::path> scenes() {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(k_scenes))
        if (entry.path().extension() == ".json" && entry.path().filename() != "scene.schema.json")
            files.push_back(entry.path());
    return files;
}

json load_schema() {
    std::ifstream file(k_scenes / "scene.schema.json");
    return json::parse(file);
}

/// Defaults of floats carry the float's digits in the reader and the written ones in the schema.
bool same_value(const json& a, const json& b) {
    if (a.is_number() && b.is_number())
        return a.get<float>() == b.get<float>();
    if (a.is_array() && b.is_array())
        return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), same_value);
    return a == b;
}

TEST(Schema, KnowsTheReadersKeysWithTheirDefaultsAndRanges) {
    const json schema = load_schema();
    const Keys stated = SchemaWalk(schema).keys();
    const Keys read = keys_of_reader();
    for (const auto& [pattern, said] : stated)
        EXPECT_TRUE(read.contains(pattern)) << pattern << " stands in the schema, and the reader does not know it";
    for (const auto& [pattern, said] : read) {
        ASSERT_TRUE(stated.contains(pattern)) << pattern << " is read but does not stand in the schema";
        const Said& other = stated.at(pattern);
        // The list of points checks its numbers one by one, the places of follow and floor as they are found; neither has a rule
        // of its own.
        const bool ruled = said.least || said.most;
        if (ruled) {
            EXPECT_EQ(said.least, other.least) << pattern;
            EXPECT_EQ(said.most, other.most) << pattern;
            EXPECT_EQ(said.above_least, other.above_least) << pattern;
        }
        EXPECT_EQ(said.words, other.words) << pattern;
        EXPECT_EQ(said.required, other.required) << pattern;
        // The name's default is the file's, which no schema can state.
        if (pattern == "$.name")
            continue;
        EXPECT_EQ(said.fallback.has_value(), other.fallback.has_value()) << pattern;
        if (said.fallback && other.fallback) {
            EXPECT_TRUE(same_value(*said.fallback, *other.fallback))
                << pattern << ": " << *said.fallback << " and " << *other.fallback;
        }
    }
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
        GTEST_SKIP() << "python3-jsonschema is not installed";
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
} // namespace windrow::cli
