// Reads settings from JSON by their tables (fluid/setting.h): each keeps its default where the file says nothing.
#pragma once

#include "fluid/core/validation.h"
#include "fluid/wind.h"
#include "scene/json_object.h"
#include "scene/motion_path.h"
#include "scene/scene.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

namespace windrow::scene {

/// Places of a scene, nearer than what the library takes: files carry them as text.
inline constexpr Range k_place_rule{-MotionPath::k_farthest, MotionPath::k_farthest, "m"};

template <class Value>
void read_value(JsonObject& object, const Key& key, Value& value, const Range& range);

/// The range of a place, no wider than what a file may hold.
[[nodiscard]] inline Range place_rule(Range range) {
    range.min = std::max(range.min, k_place_rule.min);
    range.max = std::min(range.max, k_place_rule.max);
    return range;
}

/// `special(row, value)` reads a setting by itself where it returns true. The settings of a struct without a name are the object's
/// own.
template <class Struct, class Special>
void read_settings(JsonObject& object, Struct& value, const Special& special) {
    for_each_setting(value, [&]<class Row>(const Row& row, auto& member) {
        if constexpr (Row::k_stored == Stored::everywhere) {
            if (special(row, member))
                return;
            if constexpr (HasSettings<decltype(member)>)
                if (*row.name == '\0')
                    return read_settings(object, member, special);
            read_value(object, Key{row.name, row.meaning}, member, row.range);
        }
    });
}

/// The items of a list of objects; the range bounds how many, else they are as many as a file may hold.
template <class Read>
void read_items(JsonObject& object, const Key& key, const Range& range, const Read& read) {
    const auto items = object.array(key, std::isfinite(range.max) ? static_cast<std::size_t>(range.max) : 4096);
    for (std::size_t n = 0; n < items.size(); ++n) {
        const std::string name = std::string(".") + key.name;
        read(JsonObject(items[n], object.path() + name + "[" + std::to_string(n) + "]", object.pattern() + name + "[]",
                        object.log()));
    }
}

/// All settings of an object of their own; rejects other keys.
template <class Struct>
void read_object(JsonObject object, Struct& value) {
    read_settings(object, value, [](const auto&, const auto&) { return false; });
    if constexpr (requires { check_object(object, value); })
        check_object(object, value);
    object.finish();
}

/// A side of the box: a word is enough for a kind; the object is for a wall that moves.
void read_side(JsonObject& boundaries, const Key& key, Boundary& side);
/// A decay that no hold would ever let begin.
void check_object(JsonObject& object, const Envelope& envelope);

/// What one alternative of a variant holds, by its name: {"sphere": {"radius": 2}}.
template <class... Kinds, class Read>
void read_kind(JsonObject object, std::variant<Kinds...>& value, const Read& read_one) {
    const char* const fallback = std::visit([](const auto& kind) { return kind.k_name; }, value);
    const std::size_t chosen = object.one_of({Kinds::k_name...}, fallback);
    const auto read = [&]<class Kind>(Kind kind) {
        if (const Kind* const own = std::get_if<Kind>(&value)) // the struct's own default
            kind = *own;
        read_one(object.object({Kind::k_name, Kind::k_meaning}), kind);
        value = kind;
    };
    std::size_t index = 0;
    ((index++ == chosen ? read(Kinds{}) : void()), ...);
    object.finish();
}

template <class Value>
void read_value(JsonObject& object, const Key& key, Value& value, const Range& range) {
    if constexpr (std::same_as<Value, bool>) {
        value = object.boolean(key, value);
    } else if constexpr (std::same_as<Value, std::string>) {
        value = object.text(key, value);
    } else if constexpr (std::same_as<Value, float>) {
        value = object.real(key, value, range);
    } else if constexpr (std::same_as<Value, double>) {
        value = object.number(key, value, range);
    } else if constexpr (std::integral<Value>) {
        value = static_cast<Value>(object.whole(key, value, range));
    } else if constexpr (std::same_as<Value, glm::ivec3>) {
        value = object.integers(key, value, range);
    } else if constexpr (std::same_as<Value, glm::dvec3>) {
        value = object.vector(key, value, place_rule(range));
    } else if constexpr (std::same_as<Value, glm::vec3>) {
        value = glm::vec3(object.vector(key, glm::dvec3(value), range));
    } else if constexpr (std::same_as<Value, glm::quat>) { // as angles: nobody writes four numbers
        constexpr Range k_turn{-3.6e6, 3.6e6, "degrees"};
        if (const auto turn = object.optional_vector(key, k_turn))
            value = orientation_of(*turn);
    } else if constexpr (std::same_as<Value, glm::dvec2> || std::same_as<Value, glm::vec2>) {
        value = Value(object.pair(key, glm::dvec2(value), range, range.pair));
    } else if constexpr (std::same_as<Value, glm::ivec2>) {
        value = object.whole_pair(key, value, range, range.pair);
    } else if constexpr (std::same_as<Value, std::optional<glm::bvec3>>) {
        value = object.optional_flags(key);
    } else if constexpr (std::is_enum_v<Value>) {
        const auto& words = k_words<Value>;
        const std::size_t chosen =
            object.word_index(key, words.at(static_cast<std::size_t>(value)), {words.begin(), words.end()});
        if (chosen < words.size())
            value = static_cast<Value>(chosen);
    } else if constexpr (std::same_as<Value, Boundary>) {
        read_side(object, key, value);
    } else if constexpr (std::same_as<Value, std::optional<glm::vec3>>) {
        if (const auto given = object.optional_vector(key, range))
            value = glm::vec3(*given);
    } else if constexpr (detail::k_is_optional<Value>) {
        typename Value::value_type given{};
        if constexpr (std::is_arithmetic_v<typename Value::value_type>)
            given = static_cast<typename Value::value_type>(object.optional_number(key, range).value_or(0.0));
        else
            read_object(object.object(key), given);
        if (object.value().contains(key.name))
            value = given;
    } else if constexpr (detail::k_is_variant<Value>) {
        read_kind(object.object(key), value,
                  [](JsonObject kind, auto& alternative) { read_object(std::move(kind), alternative); });
    } else if constexpr (detail::k_is_list<Value>) {
        read_items(object, key, range, [&](JsonObject item) { read_object(std::move(item), value.emplace_back()); });
    } else if constexpr (detail::k_is_number_list<Value>) {
        value = object.numbers(key, range);
    } else if constexpr (HasSettings<Value>) {
        read_object(object.object(key), value);
    } // what is left is read from a file, by who knows the folder
}

/// Notes what validation finds in a struct whose single values were read without a fault: the rules between them.
template <class Struct>
void check_read(JsonObject& object, const Struct& value) {
    detail::Reasons reasons;
    check_settings(reasons, detail::FieldPath{nullptr, object.path()}, value);
    object.log().reject_lines(reasons.take());
}

} // namespace windrow::scene
