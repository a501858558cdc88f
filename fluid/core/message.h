// Message of words and figures; figures in their shortest exact form in every locale. Nothing here throws: without memory the
// message is "out of memory".
#pragma once

#include "fluid/api.h"
#include "fluid/result.h"

#include <charconv>
#include <concepts>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <new>
#include <stdexcept>
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

template <int Count, class Number, glm::qualifier Q>
void append(std::string& text, const glm::vec<Count, Number, Q>& value) {
    for (int n = 0; n < Count; ++n) {
        text += n == 0 ? "(" : ", ";
        append(text, value[n]);
    }
    text += ')';
}

template <class... Parts>
void append_each(std::string& text, const Parts&... parts) {
    (append(text, parts), ...);
}

template <class... Parts>
void append_all(std::string& text, const Parts&... parts) noexcept {
    try {
        append_each(text, parts...);
    } catch (...) {
        text = Error::k_out_of_memory;
    }
}

template <class... Parts>
[[nodiscard]] std::string message(const Parts&... parts) noexcept {
    std::string text;
    append_all(text, parts...);
    return text;
}

[[nodiscard]] inline Error out_of_memory() {
    return Error{"out of memory: use a smaller box or fewer items, or free memory and call again.", Fault::out_of_memory};
}

/// Result of `call`, or an Error without memory. `call` must allocate before it changes anything.
template <class Call>
[[nodiscard]] auto where_memory_lasts(const Call& call) -> decltype(call()) {
    try {
        return call();
    } catch (const std::bad_alloc&) {
    } catch (const std::length_error&) {
    }
    return out_of_memory();
}

/// The same for a call that returns nothing: false where it finds no memory.
template <class Call>
[[nodiscard]] bool memory_lasts(const Call& call) {
    return where_memory_lasts([&]() -> Result<void> {
               call();
               return {};
           })
        .has_value();
}

/// Collects all reasons, a line each.
class Reasons {
  public:
    template <class... Parts>
    void add(const Parts&... parts) noexcept {
        append_all(text_, std::string_view(text_.empty() ? "" : "\n"), parts...);
    }
    void add_all_of(const Result<void>& judged) noexcept {
        if (!judged)
            add(std::string_view(judged.error()));
    }
    [[nodiscard]] bool empty() const { return text_.empty(); }
    [[nodiscard]] std::string take() { return std::move(text_); }
    [[nodiscard]] Result<void> outcome() {
        if (empty())
            return {};
        return Error{take()};
    }

  private:
    std::string text_;
};

} // namespace windrow::detail
