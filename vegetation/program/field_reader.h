// Reads the lists of picture_fields.h: each field keeps its default where the file says nothing.
#pragma once

#include "fluid/result.h"
#include "scene/json_object.h"

#include <algorithm>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <initializer_list>
#include <string>
#include <utility>

namespace windrow::vegetation::program {

using windrow::scene::JsonObject;
using windrow::scene::Key;

class FieldReader {
  public:
    using Rule = windrow::Range;

    explicit FieldReader(JsonObject& object) : object_(object) {}

    void real(const Key& key, float& value, const Rule& rule) { value = object_.real(key, value, rule); }
    void number(const Key& key, double& value, const Rule& rule) { value = object_.number(key, value, rule); }
    void integer(const Key& key, int& value, const Rule& rule) { value = object_.integer(key, value, rule); }
    void whole(const Key& key, std::uint32_t& value, const Rule& rule) {
        value = static_cast<std::uint32_t>(object_.whole(key, value, rule));
    }
    void place(const Key& key, glm::dvec3& value, const Rule& rule) { value = object_.vector(key, value, rule); }
    void colour(const Key& key, glm::vec3& value) { value = object_.vector(key, value, {.least = 0.0, .most = 1.0}); }
    void pair(const Key& key, glm::dvec2& value, const Rule& rule, const char* names) {
        value = object_.pair(key, value, rule, names);
    }
    void pair(const Key& key, glm::vec2& value, const Rule& rule, const char* names) {
        value = object_.pair(key, value, rule, names);
    }
    void flag(const Key& key, bool& value) { value = object_.boolean(key, value); }
    void position(const Key& key, glm::vec3& value, const Rule& rule) { value = object_.vector(key, value, rule); }
    /// Of any length but 0, which the structure's `validate` tells.
    void direction(const Key& key, glm::vec3& value) { position(key, value, {.least = -1e6, .most = 1e6}); }
    template <class Value>
    void word(const Key& key, Value& value, std::initializer_list<windrow::scene::Word<Value>> words) {
        value = object_.word(key, value, words);
    }

  private:
    JsonObject& object_;
};

/// Reads the list of one structure from the whole of an object.
template <class Part>
void read_part(JsonObject object, Part& part) {
    FieldReader fields(object);
    list_fields(fields, part);
    object.finish();
}

/// The items of an array of objects.
template <class Read>
void each(JsonObject& object, const Key& key, std::size_t most, Read read) {
    const auto items = object.array(key, most);
    for (std::size_t i = 0; i < items.size(); ++i)
        read(JsonObject(items[i], object.path() + "." + key.name + "[" + std::to_string(i) + "]",
                        object.pattern() + "." + key.name + "[]", object.log()));
}

/// Notes what a `validate` says of a structure whose single values were found good. Its lines begin with `owner` and a field,
/// "grass.split_distance is ...", whose place in the file is that of the object.
inline void note_refusals(const windrow::Result<void>& judged, const std::string& owner, JsonObject& object) {
    if (judged)
        return;
    const std::string& text = judged.error();
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string line = text.substr(begin, end - begin);
        const std::string place = object.log().file() + ": " + object.path();
        object.log().refuse_as_is(line.starts_with(owner) ? place + "." + line.substr(owner.size()) : place + ": " + line);
        begin = end + 1;
    }
}

} // namespace windrow::vegetation::program
