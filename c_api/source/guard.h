// Boundary between C and C++: arguments that are null, exceptions and errors become a result and the sentence of
// windrow_last_error.
#pragma once

#include "c_api/base.h"
#include "fluid/result.h"

#include <exception>
#include <initializer_list>
#include <new>
#include <stdexcept>
#include <string_view>
#include <type_traits>

#define WINDROW_EXPORT extern "C" WINDROW_C_API

namespace windrow::c_api {

/// Keeps the sentence for windrow_last_error, gives it to the logger, and returns `result`.
windrow_result fail(windrow_result result, std::string_view sentence) noexcept;
windrow_result fail(const Error& error) noexcept;
windrow_result fail_null(const char* argument) noexcept;
windrow_result fail_unsupported(const char* part) noexcept;
void warn(const char* sentence) noexcept;

/// What a call into the library came to.
template <class T>
[[nodiscard]] windrow_result done(const Result<T>& result) noexcept {
    return result ? windrow_result{WINDROW_OK} : fail(result.failure());
}
[[nodiscard]] inline windrow_result done(windrow_result result) noexcept {
    return result;
}

/// A pointer that must not be null.
struct Argument {
    const void* pointer;
    const char* name;
};

template <class Body>
[[nodiscard]] windrow_result guarded(const Body& body) noexcept {
    try {
        return done(body());
    } catch (const std::bad_alloc&) {
        return fail(WINDROW_OUT_OF_MEMORY, Error::k_out_of_memory);
    } catch (const std::length_error&) {
        return fail(WINDROW_OUT_OF_MEMORY, Error::k_out_of_memory);
    } catch (const std::exception& error) {
        return fail(WINDROW_UNEXPECTED, error.what());
    } catch (...) {
        return fail(WINDROW_UNEXPECTED, "unexpected exception inside the library: report it.");
    }
}

/// A call of the API: rejects null arguments, then runs `body`, which returns a windrow_result or a Result.
template <class Body>
[[nodiscard]] windrow_result call(std::initializer_list<Argument> arguments, const Body& body) noexcept {
    for (const Argument& argument : arguments)
        if (argument.pointer == nullptr) [[unlikely]]
            return fail_null(argument.name);
    return guarded(body);
}

/// A call that returns a value: zero for a null handle, or where it fails.
template <class Body>
[[nodiscard]] auto value_of(const void* handle, const char* name, const Body& body) noexcept {
    std::invoke_result_t<Body> value{};
    (void)call({{handle, name}}, [&] {
        value = body();
        return windrow_result{WINDROW_OK};
    });
    return value;
}

/// A call that makes an object of a handle: `make` returns Result<Value>, which becomes *out = new Handle{value}. Null on failure.
template <class Handle, class Make>
[[nodiscard]] windrow_result create(Handle** out, const Make& make) noexcept {
    if (out == nullptr)
        return fail_null("the place of the new handle");
    *out = nullptr;
    return guarded([&]() -> windrow_result {
        auto made = make();
        if (!made)
            return done(made);
        *out = new Handle{*std::move(made)};
        return WINDROW_OK;
    });
}

} // namespace windrow::c_api
