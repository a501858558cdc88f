// The schema of scene files and the tables of their keys in docs/, made from what the reader says of each key.
#pragma once

#include "fluid/core/validation.h"
#include "scene/read_log.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace windrow::test {

using OrderedJson = nlohmann::ordered_json;

/// One of each kind of thing but pictures, so that each key is asked for.
inline constexpr const char* k_scene_with_every_key = R"({
    "air": {"boundaries": {"x_low": {"kind": "open"}, "x_high": {}, "y_low": {"kind": "free_slip"}, "y_high": {}, "z_low": {}, "z_high": {}}, "profile": {}, "gusts": {}},
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
    ],
    "obstacles": [
        {"shape": {"sphere": {}}}, {"shape": {"capsule": {}}}, {"shape": {"block": {}}}, {"shape": {"cylinder": {}}},
        {"shape": {"plate": {}}, "path": "a", "turn_path": "a"},
        {"shape": {"mesh": {"file": "house.obj"}}}, {"shape": {"voxels": {"file": "tower.vox"}}},
        {"shape": {"ground": {"file": "ridge.pgm"}}}
    ],
    "drag": [{"plant": {}}, {"belt": {}}],
    "smoke": [{}, {"path": "a"}]})";

/// A key with all that is under it.
class SchemaNode {
  public:
    void add(const scene::KnownKey& key) { add(key, std::string_view(key.pattern).substr(1)); }
    /// What a scene may hold here.
    [[nodiscard]] OrderedJson schema() const {
        std::vector<const scene::KnownKey*> values;
        for (const scene::KnownKey& said : said_)
            if (said.is_value())
                values.push_back(&said);
        OrderedJson schema;
        if (!values.empty() && !values.front()->meaning.empty())
            schema["description"] = description(*values.front());
        std::vector<OrderedJson> forms;
        for (const scene::KnownKey* value : values)
            for (std::size_t begin = 0; begin < value->type.size();) { // "number or name"
                const std::size_t end = std::min(value->type.find(" or ", begin), value->type.size());
                forms.push_back(form(*value, value->type.substr(begin, end - begin)));
                begin = end + 4;
            }
        if (forms.size() == 1)
            schema.update(forms.front());
        else if (!forms.empty())
            schema["oneOf"] = forms;
        return schema;
    }
    /// An object with its keys, as the whole scene is.
    [[nodiscard]] OrderedJson object_schema() const {
        OrderedJson schema = OrderedJson::object();
        for (const scene::KnownKey& said : said_)
            if (said.type == "kind")
                schema["description"] = said.meaning;
        schema["type"] = "object";
        schema["additionalProperties"] = false;
        OrderedJson required = OrderedJson::array(), rules = OrderedJson::array();
        for (const auto& [name, member] : members_)
            if (std::any_of(member.said_.begin(), member.said_.end(),
                            [](const auto& said) { return said.required && said.is_value(); }))
                required.push_back(name);
        if (!required.empty())
            schema["required"] = required;
        for (const scene::KnownKey& said : said_) {
            if (said.type == "one of") {
                schema["maxProperties"] = 1;
                if (said.required)
                    schema["minProperties"] = 1;
            } else if (said.type == "not both") {
                rules.push_back({{"not", {{"required", said.words}}}});
            } else if (said.type == "needs") {
                schema["dependentRequired"][said.words.back()] = {said.words.front()};
            }
        }
        if (!rules.empty())
            schema["allOf"] = rules;
        for (const auto& [name, member] : members_)
            if (name == "*")
                schema["additionalProperties"] = member.object_schema();
            else
                schema["properties"][name] = member.schema();
        return schema;
    }
    /// Tables of the keys, an object each: key, range, default, meaning.
    void write_tables(std::string& text, const std::string& path = {}) const {
        if (!members_.empty() && members_.front().first != "*") {
            std::string rows = "\n\n| key | range | default | meaning |\n|---|---|---|---|\n";
            for (const auto& [name, member] : members_)
                rows += member.row(name);
            const std::string title = path.empty() ? "The scene" : "`" + path + "`";
            // The same table again is a reference to the first.
            const std::size_t same = text.find(rows), heading = same == text.npos ? same : text.rfind("\n## ", same);
            text +=
                "\n## " + title + (same == text.npos ? rows : "\n\nAs " + text.substr(heading + 4, same - heading - 4) + ".\n");
        }
        for (const auto& [name, member] : members_)
            member.write_tables(text, path.empty() ? name : path + "." + name);
        for (const SchemaNode& item : items_)
            item.write_tables(text, path + "[]");
        for (const auto& [name, kind] : kinds_)
            kind.write_tables(text, path + "(" + name + ")");
    }

  private:
    void add(const scene::KnownKey& key, std::string_view rest) {
        if (rest.empty()) {
            const auto same = [&](const scene::KnownKey& said) { return said.type == key.type && said.words == key.words; };
            const auto known = std::find_if(said_.begin(), said_.end(), same);
            if (known == said_.end())
                said_.push_back(key);
        } else if (rest.starts_with("[]")) {
            if (items_.empty())
                items_.emplace_back();
            items_.front().add(key, rest.substr(2));
        } else {
            const bool kind = rest.front() == '(', quoted = rest.starts_with("[\"");
            const std::size_t begin = quoted ? 2 : 1;
            const std::size_t end = std::min(kind     ? rest.find(')')
                                             : quoted ? rest.find("\"]")
                                                      : rest.find_first_of(".[(", 1),
                                             rest.size());
            auto& children = kind ? kinds_ : members_;
            const std::string name(rest.substr(begin, end - begin));
            auto child = std::find_if(children.begin(), children.end(), [&](const auto& other) { return other.first == name; });
            if (child == children.end())
                child = children.insert(children.end(), {name, {}});
            child->second.add(key, rest.substr(quoted ? end + 2 : kind ? end + 1 : end));
        }
    }

    static std::string description(const scene::KnownKey& key) {
        const std::string unit = *key.rule.unit == '\0' ? "" : std::string("[") + key.rule.unit + "] ";
        return unit + key.meaning + (*key.rule.zero == '\0' ? "" : std::string(" 0: ") + key.rule.zero + ".");
    }

    static OrderedJson number(const char* type, const Range& range) {
        OrderedJson schema{{"type", type}};
        if (range.measure == Measure::direction)
            return schema;
        if (std::isfinite(range.min))
            schema[range.above_min ? "exclusiveMinimum" : "minimum"] =
                plain(range.measure == Measure::length ? -range.max : range.min);
        if (std::isfinite(range.max))
            schema["maximum"] = plain(range.max);
        return schema;
    }
    static OrderedJson several(const OrderedJson& item, int count) {
        return {{"type", "array"}, {"items", item}, {"minItems", count}, {"maxItems", count}};
    }
    /// Digits of a float where a double is one; whole numbers without a point.
    static OrderedJson plain(const nlohmann::json& value) {
        if (value.is_array()) {
            OrderedJson list = OrderedJson::array();
            for (const nlohmann::json& item : value)
                list.push_back(plain(item));
            return list;
        }
        if (!value.is_number_float())
            return value;
        const auto number = value.get<double>();
        if (number == std::trunc(number) && std::abs(number) < 1e15)
            return static_cast<std::int64_t>(number);
        const auto single = static_cast<float>(number);
        return static_cast<double>(single) == number ? OrderedJson::parse(detail::message(single)) : OrderedJson(number);
    }

    [[nodiscard]] OrderedJson form(const scene::KnownKey& key, const std::string& type) const {
        OrderedJson schema;
        if (type == "number" || type == "integer")
            schema = number(type.c_str(), key.rule);
        else if (type == "vector")
            schema = several(number("number", key.rule), 3);
        else if (type == "integers")
            schema = several(number("integer", key.rule), 3);
        else if (type == "pair")
            schema = several(number("number", key.rule), 2);
        else if (type == "whole pair")
            schema = several(number("integer", key.rule), 2);
        else if (type == "flags")
            schema = several({{"type", "boolean"}}, 3);
        else if (type == "numbers")
            schema = {{"type", "array"}, {"items", number("number", key.rule)}};
        else if (type == "points")
            schema = {{"type", "array"}, {"items", several(number("number", key.rule), 4)}, {"minItems", 1}};
        else if (type == "boolean")
            schema = {{"type", "boolean"}};
        else if (type == "object")
            schema = object_schema();
        else if (type == "array")
            schema = {{"type", "array"}, {"items", items_schema()}};
        else if (type == "file name")
            schema = {{"type", "string"},
                      {"minLength", 1},
                      {"maxLength", 100},
                      {"pattern", R"(^[^./\\ \u0000-\u001f\u007f-][^/\\\u0000-\u001f\u007f]*$)"}};
        else if (type == "file")
            schema = {{"type", "string"}, {"minLength", 1}};
        else
            schema = {{"type", "string"}};
        if (key.max_items > 0)
            schema["maxItems"] = key.max_items;
        if (!key.words.empty())
            schema["enum"] = key.words;
        if (key.fallback && type != "file" && type != "file name")
            schema["default"] = plain(*key.fallback);
        return schema;
    }

    [[nodiscard]] OrderedJson items_schema() const {
        if (items_.empty())
            return OrderedJson::object();
        const SchemaNode& item = items_.front();
        if (item.kinds_.empty())
            return item.object_schema();
        OrderedJson kinds = OrderedJson::array();
        for (const auto& [name, kind] : item.kinds_) {
            OrderedJson schema = kind.object_schema();
            OrderedJson properties{{"kind", {{"const", name}}}};
            properties.update(schema["properties"]);
            schema["properties"] = properties;
            schema["required"].push_back("kind");
            kinds.push_back(schema);
        }
        return {{"oneOf", kinds}};
    }

    [[nodiscard]] std::string row(const std::string& name) const {
        std::string range, fallback, meaning;
        for (const scene::KnownKey& said : said_) {
            if (meaning.empty())
                meaning = said.meaning;
            if (range.empty() && said.type != "array" && (std::isfinite(said.rule.min) || std::isfinite(said.rule.max)))
                range = said.rule.measure == Measure::component ? detail::message(detail::Bounds{said.rule})
                                                                : detail::message(detail::VectorBounds{said.rule});
            if (range.empty())
                for (const std::string& word : said.words)
                    range += (range.empty() ? "`" : ", `") + word + "`";
            if (fallback.empty() && said.fallback && !said.type.starts_with("file"))
                fallback = plain(*said.fallback).dump();
        }
        return "| `" + name + "` | " + range + " | " + (fallback.empty() || fallback == "\"\"" ? "" : "`" + fallback + "`") +
               " | " + meaning + " |\n";
    }

    std::vector<scene::KnownKey> said_;
    std::vector<std::pair<std::string, SchemaNode>> members_, kinds_;
    std::vector<SchemaNode> items_; ///< of an array: one
};

/// JSON in which a key is a line.
inline void write_json(std::string& text, const OrderedJson& value, int depth = 0) {
    const std::string line = value.dump();
    const std::size_t described = line.find("\"description\":");
    if (described == line.npos || line.find("\"description\":", described + 1) == line.npos) {
        text += line;
        return;
    }
    const bool object = value.is_object();
    text += object ? "{" : "[";
    bool first = true;
    for (const auto& [key, item] : value.items()) {
        text += (first ? "\n" : ",\n") + std::string(4 * static_cast<std::size_t>(depth + 1), ' ');
        if (object)
            text += OrderedJson(key).dump() + ": ";
        write_json(text, item, depth + 1);
        first = false;
    }
    text += "\n" + std::string(4 * static_cast<std::size_t>(depth), ' ') + (object ? "}" : "]");
}

/// What is made of tables, as a file: the same text, or made again where WINDROW_ACCEPT_SCHEMA is set.
inline void expect_file(const std::filesystem::path& file, const std::string& text) {
    if (std::getenv("WINDROW_ACCEPT_SCHEMA") != nullptr)
        std::ofstream(file, std::ios::binary) << text;
    std::ifstream stream(file, std::ios::binary);
    const std::string there((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
    EXPECT_TRUE(there == text) << file << " is not what its tables give: ./dev schema makes it again";
}

} // namespace windrow::test
