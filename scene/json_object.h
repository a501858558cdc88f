// Typed reading of one JSON object: each access says what it expects, a fault names its path, and a key that nobody asked for
// is refused, because a misspelt one would otherwise fall back to its default without a word.
//
//     JsonObject air = scene.object("air");
//     config.cell_size = air.real("cell_size", config.cell_size, {.least = 1e-6, .most = 1e6, .unit = "m"});
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

/// A word and what it stands for.
template <class Value>
using Word = std::pair<const char*, Value>;

class JsonObject {
  public:
    /// Refuses a value that is no object; reading goes on as if it were empty, and says no more about it.
    JsonObject(const nlohmann::json& value, std::string path, std::string pattern, ReadLog& log);

    // --- Values; an absent key gives the fallback ---------------------------------------------------------------------
    [[nodiscard]] double number(const char* key, double fallback, const NumberRule& rule);
    [[nodiscard]] std::optional<double> optional_number(const char* key, const NumberRule& rule);
    [[nodiscard]] double required_number(const char* key, const NumberRule& rule);
    /// The same in float, the library's unit of measure.
    [[nodiscard]] float real(const char* key, float fallback, const NumberRule& rule);
    [[nodiscard]] int integer(const char* key, int fallback, const NumberRule& rule);
    [[nodiscard]] std::int64_t whole(const char* key, std::int64_t fallback, const NumberRule& rule);
    [[nodiscard]] bool boolean(const char* key, bool fallback);
    [[nodiscard]] std::string text(const char* key, const std::string& fallback);
    [[nodiscard]] glm::dvec3 vector(const char* key, glm::dvec3 fallback, const NumberRule& rule);
    [[nodiscard]] std::optional<glm::dvec3> optional_vector(const char* key, const NumberRule& rule);
    [[nodiscard]] glm::ivec3 integers(const char* key, glm::ivec3 fallback, const NumberRule& rule);
    /// Two numbers; `names` tells the sentence what they are: "x, z".
    [[nodiscard]] glm::dvec2 pair(const char* key, glm::dvec2 fallback, const NumberRule& rule, const char* names);
    [[nodiscard]] glm::ivec2 whole_pair(const char* key, glm::ivec2 fallback, const NumberRule& rule, const char* names);
    [[nodiscard]] std::optional<glm::bvec3> optional_flags(const char* key);
    /// One of some words, as what it stands for.
    template <class Value>
    [[nodiscard]] Value word(const char* key, Value fallback, std::initializer_list<Word<Value>> words) {
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
    /// Index of the word; words.size() where absent or refused. An empty fallback makes the key required.
    [[nodiscard]] std::size_t word_index(const char* key, const std::string& fallback, std::vector<std::string> words);
    /// A name that must be one of `names`, as its index: a reference to something else in the file. `what` says of what.
    [[nodiscard]] std::optional<std::size_t> name(const char* key, std::span<const std::string> names, const char* what,
                                                  bool required = false);

    // --- What holds more ----------------------------------------------------------------------------------------------
    /// An object; an empty one where absent.
    [[nodiscard]] JsonObject object(const char* key);
    /// Items of an array; empty where absent.
    [[nodiscard]] std::span<const nlohmann::json> array(const char* key, std::size_t most);
    /// Which one of `keys` the object holds; refuses none (unless `fallback` names one) and several. Returns keys.size() then.
    [[nodiscard]] std::size_t one_of(std::initializer_list<const char*> keys, const char* fallback = nullptr);
    /// The value as it stands, or null; the key is then known, and `type` describes it.
    [[nodiscard]] const nlohmann::json* find(const char* key, const char* type);

    /// Refuses every key that nobody asked for.
    void finish();

    /// Notes a fault in this object, or at a key of it: "path rest".
    void refuse(std::string_view rest);
    void refuse(const char* key, std::string_view rest);

    [[nodiscard]] const std::string& path() const { return path_; }
    [[nodiscard]] const std::string& pattern() const { return pattern_; }
    [[nodiscard]] const nlohmann::json& value() const { return *value_; }
    [[nodiscard]] ReadLog& log() { return *log_; }
    /// From here on the pattern of the keys carries the kind of this object.
    void set_kind(std::string_view kind);

    /// A number that keeps the rule, or nothing and a fault at `path`.
    static std::optional<double> check_number(const nlohmann::json& value, const std::string& path, const NumberRule& rule,
                                              ReadLog& log);
    /// Three such numbers.
    static std::optional<glm::dvec3> check_vector(const nlohmann::json& value, const std::string& path, const NumberRule& rule,
                                                  ReadLog& log);

  private:
    [[nodiscard]] std::optional<glm::dvec2> check_pair(const char* key, const nlohmann::json* value, const NumberRule& rule,
                                                       const char* names);
    const nlohmann::json* note(KnownKey key, const char* name);
    [[nodiscard]] std::string path_of(const char* key) const;

    const nlohmann::json* value_;
    std::string path_;
    std::string pattern_;
    ReadLog* log_;
    std::vector<std::string> asked_;
    bool broken_ = false; ///< no object at all: what is missing in it is no further fault
};

} // namespace windrow::scene
