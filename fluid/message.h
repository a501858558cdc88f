// One sentence out of words and figures; figures in their shortest exact form, whatever the locale.
#pragma once

#include <charconv>
#include <concepts>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>

namespace windrow::detail {

inline void append(std::string& text, std::string_view part) {
    text += part;
}

template <class Number>
requires std::integral<Number> || std::floating_point<Number>
void append(std::string& text, Number value) {
    char digits[64];
    const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
    text.append(digits, end);
}

template <class Number, glm::qualifier Q>
void append(std::string& text, const glm::vec<3, Number, Q>& value) {
    text += '(';
    append(text, value.x);
    text += ", ";
    append(text, value.y);
    text += ", ";
    append(text, value.z);
    text += ')';
}

template <class... Parts>
[[nodiscard]] std::string message(const Parts&... parts) {
    std::string text;
    (append(text, parts), ...);
    return text;
}

/// Collects all reasons, a line each.
class Reasons {
  public:
    template <class... Parts>
    void add(const Parts&... parts) {
        if (!text_.empty())
            text_ += '\n';
        (append(text_, parts), ...);
    }
    [[nodiscard]] bool empty() const { return text_.empty(); }
    [[nodiscard]] std::string take() { return std::move(text_); }

  private:
    std::string text_;
};

} // namespace windrow::detail
