// Numbers from text and back, the same in every locale: a decimal comma in the user's settings must not change a scene.
#pragma once

#include "fluid/core/validation.h"
#include "fluid/files/text_lines.h"

#include <optional>
#include <string>
#include <string_view>

namespace windrow::scene {

/// The finite number that the whole of `text` spells; nothing for anything else. What is too small for a double is 0.
[[nodiscard]] inline std::optional<double> parse_number(std::string_view text) {
    return detail::number_of<double>(text);
}

/// The whole number that the whole of `text` spells.
[[nodiscard]] inline std::optional<long long> parse_whole_number(std::string_view text) {
    return detail::number_of<long long>(text);
}

/// A number as a person writes it: 500000, 0.25, 1e6, 1e-9.
[[nodiscard]] inline std::string figure(double value) {
    return detail::message(detail::Figure{value});
}

} // namespace windrow::scene
