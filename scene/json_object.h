// Typed reading of one JSON object: each access says what it expects, a fault names its path, and a key that nobody asked for
// is rejected, because a misspelt one would otherwise fall back to its default without a word.
//
//     JsonObject air = scene.object("air");
//     config.cell_size = air.real("cell_size", config.cell_size, {.min = 1e-6, .max = 1e6, .unit = "m"});
//     air.finish();
//
// A fault is noted in the ReadLog and the fallback is returned, so that one reading finds all faults.
#pragma once

#include "scene/read_log.h"

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace windrow::scene {

/// A key of an object, and what it means, for people who write scenes.
struct Key {
    Key(const char* its_name, const char* its_meaning = "") : name(its_name), meaning(its_meaning) {}
    const char* name;
    const char* meaning;
};

/// A word and what it stands for.
template <class Value>
using Word = std::pair<const char*, Value>;

class JsonObject {
  public:
    /// Rejects a value that is no object; reading goes on as if it were empty, and says no more about it.
    JsonObject(const nlohmann::json& value, std::string path, std::string pattern, ReadLog& log);

    // --- Values; an absent key gives the fallback ---------------------------------------------------------------------
    [[nodiscard]] double number(const Key& key, double fallback, const Range& rule);
    [[nodiscard]] std::optional<double> optional_number(const Key& key, const Range& rule);
    [[nodiscard]] double required_number(const Key& key, const Range& rule);
    /// The same in float, the library's unit of measure.
    [[nodiscard]] float real(const Key& key, float fallback, const Range& rule);
    [[nodiscard]] int integer(const Key& key, int fallback, const Range& rule);
    [[nodiscard]] std::int64_t whole(const Key& key, std::int64_t fallback, const Range& rule);
    [[nodiscard]] bool boolean(const Key& key, bool fallback);
    [[nodiscard]] std::string text(const Key& key, const std::string& fallback, const char* type = "string");
    [[nodiscard]] glm::dvec3 vector(const Key& key, glm::dvec3 fallback, const Range& rule);
    [[nodiscard]] std::optional<glm::dvec3> optional_vector(const Key& key, const Range& rule);
    [[nodiscard]] glm::ivec3 integers(const Key& key, glm::ivec3 fallback, const Range& rule);
    /// Two numbers; `names` tells the sentence what they are: "x, z".
    [[nodiscard]] glm::dvec2 pair(const Key& key, glm::dvec2 fallback, const Range& rule, const char* names);
    [[nodiscard]] glm::ivec2 whole_pair(const Key& key, glm::ivec2 fallback, const Range& rule, const char* names);
    [[nodiscard]] std::optional<glm::bvec3> optional_flags(const Key& key);
    /// A list of numbers; empty where absent.
    [[nodiscard]] std::vector<float> numbers(const Key& key, const Range& rule);
    /// One of some words, as what it stands for.
    template <class Value>
    [[nodiscard]] Value word(const Key& key, Value fallback, std::initializer_list<Word<Value>> words) {
        std::vector<std::string> spelt;
        std::string fallback_word;
        for (const auto& [text, value] : words) {
            spelt.emplace_back(text);
            if (value == fallback)
                fallback_word = text;
        }
        const std::size_t chosen = word_index(key, fallback_word, std::move(spelt));
        return chosen < words.size() ? words.begin()[chosen].second : fallback;
    }
    /// Index of the word; words.size() where absent or rejected. An empty fallback makes the key required.
    [[nodiscard]] std::size_t word_index(const Key& key, const std::string& fallback, std::vector<std::string> words);
    /// A name that must be one of `names`, as its index: a reference to something else in the file. `what` says of what.
    [[nodiscard]] std::optional<std::size_t> name(const Key& key, std::span<const std::string> names, const char* what,
                                                  bool required = false);

    // --- What holds more ----------------------------------------------------------------------------------------------
    /// An object; an empty one where absent.
    [[nodiscard]] JsonObject object(const Key& key);
    /// Items of an array; empty where absent.
    [[nodiscard]] std::span<const nlohmann::json> array(const Key& key, std::size_t most, const char* type = "array",
                                                        const Range& rule = {});
    /// Which one of `keys` the object holds; rejects none (unless `fallback` names one) and several. Returns keys.size() then.
    [[nodiscard]] std::size_t one_of(std::initializer_list<const char*> keys, const char* fallback = nullptr);
    /// Of two keys the object may hold one; rejects both.
    void not_both(const char* one, const char* other);
    /// Rejects `key` where `wanted` is missing; `why` ends the sentence.
    void needs(const char* key, const char* wanted, std::string_view why);
    /// The value as it stands, or null; the key is then known, and `type` describes it.
    [[nodiscard]] const nlohmann::json* find(const Key& key, const char* type, const Range& rule = {});

    /// Rejects every key that nobody asked for.
    void finish();

    /// Notes a fault in this object, or at a key of it: "path rest".
    void reject(std::string_view rest);
    void reject(const Key& key, std::string_view rest);

    [[nodiscard]] const std::string& path() const { return path_; }
    [[nodiscard]] const std::string& pattern() const { return pattern_; }
    [[nodiscard]] const nlohmann::json& value() const { return *value_; }
    [[nodiscard]] ReadLog& log() { return *log_; }
    /// From here on the pattern of the keys carries the kind of this object.
    void set_kind(std::string_view kind, const char* meaning);

    /// A number that keeps the rule, or nothing and a fault at `path`.
    static std::optional<double> check_number(const nlohmann::json& value, const std::string& path, const Range& rule,
                                              ReadLog& log);
    /// Three such numbers.
    static std::optional<glm::dvec3> check_vector(const nlohmann::json& value, const std::string& path, const Range& rule,
                                                  ReadLog& log);

  private:
    [[nodiscard]] std::optional<glm::dvec2> check_pair(const Key& key, const nlohmann::json* value, const Range& rule,
                                                       const char* names);
    const nlohmann::json* note(KnownKey key, const Key& asked);
    [[nodiscard]] std::string path_of(const Key& key) const;

    const nlohmann::json* value_;
    std::string path_;
    std::string pattern_;
    ReadLog* log_;
    std::vector<std::string> asked_;
    bool broken_ = false; ///< no object at all: what is missing in it is no further fault
};

} // namespace windrow::scene
