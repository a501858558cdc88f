// Result of a call that can fail: a value, or an error sentence with the field, its value and the fix.
// No exception crosses the API: a call without memory returns an Error too, and leaves its object unchanged.
#pragma once

#include "api.h"

#include <concepts>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace windrow {

/// Reason of a failure. `message` is one sentence (or several, one per line) with the fix.
/// Creation does not throw: without memory for the sentence it is "out of memory", which does not allocate.
struct Error {
    Error() = default;
    Error(std::string&& text) noexcept : message(std::move(text)) {}
    template <std::convertible_to<std::string_view> Text>
    Error(const Text& text) noexcept {
        try {
            message = std::string_view(text);
        } catch (...) {
            message = k_out_of_memory;
        }
    }

    std::string message;

    static constexpr const char* k_out_of_memory = "out of memory";
};

/// A value or an Error. `if (result)` asks whether it holds a value; `*result` and `result->` reach it (undefined without one).
template <class T>
class [[nodiscard]] Result {
  public:
    Result(T value) : content_(std::in_place_index<0>, std::move(value)) {}
    Result(Error error) : content_(std::in_place_index<1>, std::move(error)) {}

    [[nodiscard]] bool has_value() const noexcept { return content_.index() == 0; }
    explicit operator bool() const noexcept { return has_value(); }

    T& operator*() & { return *std::get_if<0>(&content_); }
    const T& operator*() const& { return *std::get_if<0>(&content_); }
    T&& operator*() && { return std::move(*std::get_if<0>(&content_)); }
    T* operator->() { return std::get_if<0>(&content_); }
    const T* operator->() const { return std::get_if<0>(&content_); }

    /// The message; valid only where has_value() is false.
    [[nodiscard]] const std::string& error() const { return std::get_if<1>(&content_)->message; }

  private:
    std::variant<T, Error> content_;
};

/// Success, or an Error.
template <>
class [[nodiscard]] Result<void> {
  public:
    Result() = default;
    Result(Error error) : error_(std::move(error.message)), failed_(true) {}

    [[nodiscard]] bool has_value() const noexcept { return !failed_; }
    explicit operator bool() const noexcept { return !failed_; }
    [[nodiscard]] const std::string& error() const { return error_; }

  private:
    std::string error_;
    bool failed_ = false;
};

} // namespace windrow
