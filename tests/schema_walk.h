// What a reader of scenes and its schema say of their keys, side by side.
#pragma once

#include "scene/json_document.h"
#include "scene/read_log.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace windrow::test {

using nlohmann::json;

/// What is said of a key, by the reader or by the schema.
struct Said {
    std::optional<json> fallback;
    std::optional<double> least, most;
    bool above_least = false;
    bool required = false;
    std::vector<std::string> words;
};
using Keys = std::map<std::string, Said>;

/// What the reader said; the last word on a key counts.
inline Keys keys_of(const std::vector<scene::KnownKey>& known) {
    Keys keys;
    for (const scene::KnownKey& key : known) {
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
    explicit SchemaWalk(json schema) : schema_(std::move(schema)) { walk_object(schema_, "$"); }
    [[nodiscard]] const Keys& keys() const { return keys_; }

  private:
    [[nodiscard]] const json& resolve(const json& node) const {
        return node.contains("$ref") ? schema_.at(json::json_pointer(node["$ref"].get<std::string>().substr(1))) : node;
    }

    void walk_object(const json& node, const std::string& pattern) {
        const json properties = node.value("properties", json::object());
        const json required = node.value("required", json::array());
        for (const auto& [key, child] : properties.items()) {
            const std::string below = scene::join_json_path(pattern, key);
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
        if (kinds.empty())
            walk_object(items, pattern + "[]");
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

    const json schema_;
    Keys keys_;
};

inline json load_schema() {
    std::ifstream file(std::filesystem::path(WINDROW_SOURCE_DIR) / "examples" / "scenes" / "scene.schema.json");
    return json::parse(file);
}

/// Defaults of floats carry the float's digits in the reader and the written ones in the schema.
inline bool same_value(const json& a, const json& b) {
    if (a.is_number() && b.is_number())
        return a.get<float>() == b.get<float>();
    if (a.is_array() && b.is_array())
        return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), same_value);
    return a == b;
}

/// `without_default`: keys whose default no schema can state.
inline void expect_same_keys(const Keys& stated, const Keys& read, const std::vector<std::string>& without_default = {}) {
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
        if (std::find(without_default.begin(), without_default.end(), pattern) != without_default.end())
            continue;
        EXPECT_EQ(said.fallback.has_value(), other.fallback.has_value()) << pattern;
        if (said.fallback && other.fallback) {
            EXPECT_TRUE(same_value(*said.fallback, *other.fallback))
                << pattern << ": " << *said.fallback << " and " << *other.fallback;
        }
    }
}

} // namespace windrow::test
