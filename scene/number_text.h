// Numbers from text and back, the same in every locale: a decimal comma in the user's settings must not change a scene.
#pragma once

#include "fluid/core/validation.h"

#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace windrow::scene {

/// The finite number that the whole of `text` spells; nothing for anything else. What is too small for a double is 0.
[[nodiscard]] inline std::optional<double> parse_number(std::string_view text) {
    if (text.starts_with('+'))
        text.remove_prefix(1);
    double value = 0.0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (end != text.data() + text.size() || text.empty() || fault == std::errc::invalid_argument)
        return std::nullopt;
    if (fault == std::errc::result_out_of_range) {
        // from_chars reports both ends of the range alike; of a number this short only a negative exponent makes it too small.
        const bool tiny = text.size() <= 64 && (text.find("e-") != text.npos || text.find("E-") != text.npos);
        return tiny ? std::optional(0.0) : std::nullopt;
    }
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

/// The whole number that the whole of `text` spells.
[[nodiscard]] inline std::optional<long long> parse_whole_number(std::string_view text) {
    long long value = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (fault != std::errc{} || end != text.data() + text.size())
        return std::nullopt;
    return value;
}

/// A number as a person writes it: 500000, 0.25, 1e6, 1e-9.
[[nodiscard]] inline std::string figure(double value) {
    return detail::message(detail::Figure{value});
}

} // namespace windrow::scene
