// JSON text, strictly read: what a lenient parser lets pass without a word is rejected with its place.
#pragma once

#include "fluid/result.h"

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace windrow::scene {

/// Deeper than any scene; beyond it a file is an accident or an attack.
inline constexpr std::size_t k_max_json_depth = 32;
/// A value of 2 bytes in the text may take 100 bytes in memory. A path of 1,000,000 points has 5,000,000.
inline constexpr std::size_t k_max_json_values = 6'000'000;

/// Parses JSON text. Rejects syntax errors (with line and column), NaN and Infinity, numbers that do not fit a double, keys that
/// stand twice in an object, nesting beyond k_max_json_depth, and more than k_max_json_values. `name` is the file's, for the sentence.
[[nodiscard]] Result<nlohmann::json> parse_json(std::string_view text, const std::string& name);

/// `$.motors` and `drive speed` make `$.motors["drive speed"]`; a plain word is joined by a dot.
[[nodiscard]] std::string join_json_path(std::string_view parent, std::string_view key);

/// A value as it stands in the file, cut to a length that fits a sentence.
[[nodiscard]] std::string quote_json(const nlohmann::json& value);

} // namespace windrow::scene
