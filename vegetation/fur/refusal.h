// Why a mesh, its file or its bones are refused: one sentence with field, value and fix. Figures in their shortest exact form.
#pragma once

#include "fluid/result.h"

#include <charconv>
#include <concepts>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>

namespace windrow::vegetation::fur {

inline void append(std::string& text, std::string_view part) {
    text += part;
}

template <class Number>
requires std::integral<Number> || std::floating_point<Number>
void append(std::string& text, Number value) {
    char digits[64];
    text.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}

inline void append(std::string& text, const glm::vec3& value) {
    for (int axis = 0; axis < 3; ++axis) {
        text += axis == 0 ? "(" : ", ";
        append(text, value[axis]);
    }
    text += ')';
}

template <class... Parts>
[[nodiscard]] std::string sentence(const Parts&... parts) {
    std::string text;
    (append(text, parts), ...);
    return text;
}

template <class... Parts>
[[nodiscard]] windrow::Error refusal(const Parts&... parts) {
    return {sentence(parts...)};
}

/// Collects all reasons, a line each.
class Refusals {
  public:
    /// NaN fails every comparison, and is refused too.
    void between(std::string_view field, double value, double least, double most) {
        if (!(value >= least && value <= most))
            add(sentence(field, " is ", value, ": give ", least, " to ", most, "."));
    }
    void add(const std::string& reason) { text_ += (text_.empty() ? "" : "\n") + reason; }
    [[nodiscard]] windrow::Result<void> outcome() const {
        if (text_.empty())
            return {};
        return windrow::Error{text_};
    }

  private:
    std::string text_;
};

} // namespace windrow::vegetation::fur
