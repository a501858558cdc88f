// Writes the lists of picture_fields.h and its kind: every field, with the digits that name it.
#pragma once

#include "scene/json_object.h"
#include "scene/number_text.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <utility>

namespace windrow::vegetation::program {

using nlohmann::json;
using windrow::scene::Key;

inline json written(double value) {
    // Whole numbers as a person writes them: 30, not 30.0.
    if (value == std::trunc(value) && std::abs(value) < 1e15)
        return json(static_cast<std::int64_t>(value));
    return json(value);
}
inline json written(float value) {
    char digits[64];
    const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
    return written(windrow::scene::parse_number({digits, end}).value_or(static_cast<double>(value)));
}
template <int Count, class Number>
json written(const glm::vec<Count, Number, glm::defaultp>& values) {
    json list = json::array();
    for (int n = 0; n < Count; ++n)
        list.push_back(written(values[n]));
    return list;
}

/// The counterpart of FieldReader.
class FieldWriter {
  public:
    void real(const Key& key, float value, const windrow::Range&) { object[key.name] = written(value); }
    void number(const Key& key, double value, const windrow::Range&) { object[key.name] = written(value); }
    void integer(const Key& key, int value, const windrow::Range&) { object[key.name] = value; }
    void whole(const Key& key, std::uint32_t value, const windrow::Range&) { object[key.name] = value; }
    void place(const Key& key, glm::dvec3 value, const windrow::Range&) { object[key.name] = written(value); }
    void colour(const Key& key, glm::vec3 value) { object[key.name] = written(value); }
    void pair(const Key& key, glm::dvec2 value, const windrow::Range&, const char*) { object[key.name] = written(value); }
    void pair(const Key& key, glm::vec2 value, const windrow::Range&, const char*) { object[key.name] = written(value); }
    void flag(const Key& key, bool value) { object[key.name] = value; }
    void position(const Key& key, glm::vec3 value, const windrow::Range&) { object[key.name] = written(value); }
    void direction(const Key& key, glm::vec3 value) { object[key.name] = written(value); }
    template <class Value>
    void word(const Key& key, Value value, std::initializer_list<windrow::scene::Word<Value>> words) {
        for (const auto& [text, meaning] : words)
            if (meaning == value)
                object[key.name] = text;
    }

    json object = json::object();
};

/// By value: the lists take what a reader may change.
template <class Part>
json write_part(Part part) {
    FieldWriter fields;
    list_fields(fields, part);
    return std::move(fields.object);
}

} // namespace windrow::vegetation::program
