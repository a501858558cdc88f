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

/// What a caller can do about a failure: mend its arguments, free memory and call again, make the device again, free a disk or whatever
/// else the system has no more of.
enum class Fault { rejected, out_of_memory, device_lost, system_lacks };

/// Reason of a failure. `message` is one sentence (or several, one per line) with the fix.
/// Creation and copies do not throw: without memory for the sentence it is "out of memory", which does not allocate.
struct Error {
    Error() = default;
    Error(std::string&& text, Fault kind = Fault::rejected) noexcept : message(std::move(text)), fault(kind) {}
    template <std::convertible_to<std::string_view> Text>
    Error(const Text& text, Fault kind = Fault::rejected) noexcept {
        take({}, std::string_view(text), kind);
    }
    Error(const Error& other) noexcept { take({}, other.message, other.fault); }
    Error(Error&&) noexcept = default;
    Error& operator=(Error other) noexcept {
        message.swap(other.message);
        fault = other.fault;
        return *this;
    }
    ~Error() = default;

    /// The same reason behind the name of a place: "$.picture.trees: ".
    [[nodiscard]] Error after(std::string_view place) const noexcept {
        Error whole;
        whole.take(place, message, fault);
        return whole;
    }

    std::string message;
    Fault fault = Fault::rejected;

    static constexpr const char* k_out_of_memory = "out of memory";

  private:
    void take(std::string_view place, std::string_view text, Fault kind) noexcept {
        try {
            message = place;
            message += text;
            fault = kind;
        } catch (...) {
            message = k_out_of_memory;
            fault = Fault::out_of_memory;
        }
    }
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
    [[nodiscard]] const std::string& error() const { return failure().message; }
    /// The whole Error, to hand it on: `return made.failure();`.
    [[nodiscard]] const Error& failure() const { return *std::get_if<1>(&content_); }

  private:
    std::variant<T, Error> content_;
};

/// Success, or an Error.
template <>
class [[nodiscard]] Result<void> {
  public:
    Result() = default;
    Result(Error error) : error_(std::move(error)), failed_(true) {}

    [[nodiscard]] bool has_value() const noexcept { return !failed_; }
    explicit operator bool() const noexcept { return !failed_; }
    [[nodiscard]] const std::string& error() const { return error_.message; }
    [[nodiscard]] const Error& failure() const { return error_; }

  private:
    Error error_;
    bool failed_ = false;
};

} // namespace windrow
