// Changes JSON by its structure: an input stays JSON, and mostly what its parser expects, so that executions reach the code behind
// the syntax. Members and values come from the inputs themselves and from the keys that the parser asks for.
#pragma once

#include "scene/read_log.h"

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace windrow::fuzz {

/// Defined by each target that the mutator is linked to. The keys that its parser asks of this text; empty where it keeps no list
/// of them.
[[nodiscard]] std::vector<scene::KnownKey> known_keys(std::string_view text);

class JsonMutator {
  public:
    /// Learns the members of an input: which keys an object has, and which values a key.
    void learn(const nlohmann::json& document);
    /// Learns keys with their range, words and fallback.
    void learn(const std::vector<scene::KnownKey>& keys);

    /// One change at a random place.
    void mutate(nlohmann::json& document, std::uint32_t seed);
    /// Puts a value of `other` in the place of one of the same key.
    void cross(nlohmann::json& document, const nlohmann::json& other, std::uint32_t seed);

  private:
    struct Node {
        nlohmann::json* value;
        nlohmann::json* parent; ///< null: the document
        std::string key;        ///< of a member; items have that of their array
        std::string parent_key;
    };
    static void collect(nlohmann::json& value, nlohmann::json* parent, const std::string& key, const std::string& parent_key,
                        std::vector<Node>& nodes);

    void learn_member(const std::string& parent_key, const std::string& key, const nlohmann::json& value);
    std::uint32_t below(std::size_t count) { return static_cast<std::uint32_t>(random_() % (count == 0 ? 1 : count)); }
    /// One of the values that a key had; null where none is known.
    [[nodiscard]] const nlohmann::json* known_value(const std::string& key);
    [[nodiscard]] double number_near(double value);
    void change_number(nlohmann::json& value);
    void change_text(Node& node);
    void change_array(nlohmann::json& value);
    void change_object(nlohmann::json& value, const std::string& key);
    [[nodiscard]] nlohmann::json odd_value();

    std::map<std::string, std::vector<std::string>> keys_;      ///< by the key of the object that has them
    std::map<std::string, std::vector<nlohmann::json>> values_; ///< by their own key
    std::minstd_rand random_;
};

/// Parses leniently; a discarded value where the text is not JSON or nests deeper than any parser of ours reads.
[[nodiscard]] nlohmann::json parse_shallow(std::string_view text);

} // namespace windrow::fuzz
