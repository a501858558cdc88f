// Structs of C from and to those of C++, by a table of their fields.
//
//     WINDROW_C_STRUCT(windrow_canopy, windrow::Canopy, height, drag);
//
// `./dev schema` writes the rows of structs that have a table of settings (tools/make_bindings.py). A member of the C++ struct without
// a row does not compile; WINDROW_C_STRUCT_BUT counts those that read_rest and write_rest convert by hand. A struct with `struct_size`
// is one that may grow: what an older host does not have gets its default, what a newer host sets and this library cannot use is
// rejected.
#pragma once

#include "c_api/source/guard.h"
#include "fluid/core/validation.h"
#include "fluid/parallel.h"
#include "fluid/setting.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>

#define WINDROW_PARENTHESES ()
#define WINDROW_EXPAND(...) WINDROW_EXPAND_3(WINDROW_EXPAND_3(WINDROW_EXPAND_3(WINDROW_EXPAND_3(__VA_ARGS__))))
#define WINDROW_EXPAND_3(...) WINDROW_EXPAND_2(WINDROW_EXPAND_2(WINDROW_EXPAND_2(WINDROW_EXPAND_2(__VA_ARGS__))))
#define WINDROW_EXPAND_2(...) WINDROW_EXPAND_1(WINDROW_EXPAND_1(WINDROW_EXPAND_1(WINDROW_EXPAND_1(__VA_ARGS__))))
#define WINDROW_EXPAND_1(...) __VA_ARGS__
#define WINDROW_EACH(c, cpp, name, ...)                                                                                          \
    Field(#name, &c::name, &cpp::name) __VA_OPT__(, WINDROW_EACH_AGAIN WINDROW_PARENTHESES(c, cpp, __VA_ARGS__))
#define WINDROW_EACH_AGAIN() WINDROW_EACH
#define WINDROW_C_STRUCT_BUT(others, c, cpp, ...)                                                                                \
    template <>                                                                                                                  \
    struct Fields<c> {                                                                                                           \
        using Cpp = cpp;                                                                                                         \
        static constexpr const char* k_name = #c;                                                                                \
        static constexpr auto list() { return std::tuple{WINDROW_EXPAND(WINDROW_EACH(c, cpp, __VA_ARGS__))}; }                   \
    };                                                                                                                           \
    static_assert(detail::member_count<cpp>() == std::tuple_size_v<decltype(Fields<c>::list())> + (others), "a member has no "   \
                                                                                                            "row")
#define WINDROW_C_STRUCT(c, cpp, ...) WINDROW_C_STRUCT_BUT(0, c, cpp, __VA_ARGS__)
/// The init function of a struct.
#define WINDROW_C_INIT(c)                                                                                                        \
    WINDROW_EXPORT windrow_result c##_init(c* value, uint32_t struct_size) {                                                     \
        return windrow::c_api::init(value, struct_size);                                                                         \
    }

namespace windrow::c_api {

template <class C, class Value, class Cpp, class CppValue>
struct Field {
    constexpr Field(const char* its_name, Value C::*its_member, CppValue Cpp::*its_cpp)
        : name(its_name), member(its_member), cpp(its_cpp) {}
    const char* name;
    Value C::*member;
    CppValue Cpp::*cpp;
};

/// The table of a struct of C.
template <class C>
struct Fields;
template <class C>
concept HasFields = requires {
    typename Fields<C>::Cpp;
};
template <class C>
concept Versioned = HasFields<C> && requires(C value) {
    value.struct_size;
};

using Path = detail::FieldPath;
/// All reasons why a struct cannot be used. A class of this namespace, so that conversions by hand are found by it.
class Reasons : public detail::Reasons {};
struct Writing {}; // likewise

// --- Vectors ---------------------------------------------------------------------------------------------------------
inline glm::vec2 to_cpp(windrow_vec2 v) {
    return {v.x, v.y};
}
inline glm::vec3 to_cpp(windrow_vec3 v) {
    return {v.x, v.y, v.z};
}
inline glm::vec4 to_cpp(windrow_vec4 v) {
    return {v.x, v.y, v.z, v.w};
}
inline glm::quat to_cpp(windrow_quat v) {
    return glm::quat(v.w, v.x, v.y, v.z);
}
inline glm::dvec2 to_cpp(windrow_dvec2 v) {
    return {v.x, v.y};
}
inline glm::dvec3 to_cpp(windrow_dvec3 v) {
    return {v.x, v.y, v.z};
}
inline glm::dvec4 to_cpp(windrow_dvec4 v) {
    return {v.x, v.y, v.z, v.w};
}
inline glm::ivec2 to_cpp(windrow_ivec2 v) {
    return {v.x, v.y};
}
inline glm::ivec3 to_cpp(windrow_ivec3 v) {
    return {v.x, v.y, v.z};
}
inline glm::uvec2 to_cpp(windrow_uvec2 v) {
    return {v.x, v.y};
}
inline windrow_vec2 to_c(glm::vec2 v) {
    return {v.x, v.y};
}
inline windrow_vec3 to_c(glm::vec3 v) {
    return {v.x, v.y, v.z};
}
inline windrow_vec4 to_c(glm::vec4 v) {
    return {v.x, v.y, v.z, v.w};
}
inline windrow_quat to_c(glm::quat v) {
    return {v.x, v.y, v.z, v.w};
}
inline windrow_dvec2 to_c(glm::dvec2 v) {
    return {v.x, v.y};
}
inline windrow_dvec3 to_c(glm::dvec3 v) {
    return {v.x, v.y, v.z};
}
inline windrow_dvec4 to_c(glm::dvec4 v) {
    return {v.x, v.y, v.z, v.w};
}
inline windrow_ivec3 to_c(glm::ivec3 v) {
    return {v.x, v.y, v.z};
}

/// The same memory, where the layouts are the same.
template <class To, class From>
[[nodiscard]] To* same_layout(From* from) {
    using Plain = std::remove_const_t<From>;
    static_assert(sizeof(To) == sizeof(Plain) && alignof(To) <= alignof(Plain) && std::is_const_v<To> == std::is_const_v<From> &&
                  std::is_trivially_copyable_v<std::remove_const_t<To>> && std::is_trivially_copyable_v<Plain>);
    return reinterpret_cast<To*>(from);
}

/// A path of the API, whose text is UTF-8 on every system.
[[nodiscard]] inline std::filesystem::path path_of(const char* utf8) {
    const std::string_view text(utf8);
    return std::u8string(text.begin(), text.end());
}

/// A host's array of numbers whose type the call names; empty where it is null.
template <class Number, class Void>
[[nodiscard]] std::span<Number> numbers(Void* array, std::uint64_t count) {
    return {static_cast<Number*>(array), array != nullptr ? static_cast<std::size_t>(count) : 0};
}

// --- Enumerations ----------------------------------------------------------------------------------------------------
/// Number of values of an enumeration without words (setting.h).
template <class Enumeration>
inline constexpr int k_values = static_cast<int>(k_words<Enumeration>.size());

template <class Enumeration>
[[nodiscard]] bool read_choice(Reasons& reasons, const Path& path, std::int32_t from, Enumeration& to) {
    if (from < 0 || from >= k_values<Enumeration>) {
        reasons.add(path, " is ", from, ": give 0 to ", k_values<Enumeration> - 1, ".");
        return false;
    }
    to = static_cast<Enumeration>(from);
    return true;
}

// --- Reading ---------------------------------------------------------------------------------------------------------
template <class C>
void read_versioned(Reasons& reasons, const Path& path, const C* from, typename Fields<C>::Cpp& to);

template <class From, class To>
void read_value(Reasons& reasons, const Path& path, const From& from, To& to) {
    if constexpr (std::same_as<To, bool>)
        to = from != 0;
    else if constexpr (std::is_enum_v<To>)
        (void)read_choice(reasons, path, from, to);
    else if constexpr (std::is_arithmetic_v<To>) {
        static_assert(std::same_as<From, To>);
        to = from;
    } else if constexpr (requires { to = to_cpp(from); })
        to = to_cpp(from);
    else if constexpr (HasFields<std::remove_const_t<std::remove_pointer_t<From>>> && std::is_pointer_v<From>) {
        if constexpr (detail::k_is_optional<To>)
            to.reset();
        if (from != nullptr) {
            if constexpr (detail::k_is_optional<To>)
                read_versioned(reasons, path, from, to.emplace());
            else
                read_versioned(reasons, path, from, to);
        }
    } else if constexpr (HasFields<From>)
        read_fields(reasons, path, from, to);
    else
        read_rest(reasons, path, from, to);
}

template <class C>
void read_fields(Reasons& reasons, const Path& path, const C& from, typename Fields<C>::Cpp& to) {
    std::apply(
        [&](const auto&... field) {
            (read_value(reasons, Path{&path, field.name}, from.*field.member, to.*field.cpp), ...);
        },
        Fields<C>::list());
    if constexpr (requires { read_rest(reasons, path, from, to); })
        read_rest(reasons, path, from, to);
}

// --- Writing ---------------------------------------------------------------------------------------------------------
template <class C>
void write_fields(const typename Fields<C>::Cpp& from, C& to);

template <class From, class To>
void write_value(const From& from, To& to) {
    if constexpr (std::is_enum_v<From> || std::is_arithmetic_v<From>)
        to = static_cast<To>(from);
    else if constexpr (requires { to = to_c(from); })
        to = to_c(from);
    else if constexpr (std::is_pointer_v<To>)
        to = nullptr; // behind it is the host's
    else if constexpr (HasFields<To>)
        write_fields(from, to);
    else
        write_rest(Writing{}, from, to);
}

template <class C>
void write_fields(const typename Fields<C>::Cpp& from, C& to) {
    std::apply([&](const auto&... field) { (write_value(from.*field.cpp, to.*field.member), ...); }, Fields<C>::list());
    if constexpr (requires { write_rest(Writing{}, from, to); })
        write_rest(Writing{}, from, to);
}

/// The defaults of a struct.
template <class C>
[[nodiscard]] C default_of() {
    C value;
    std::memset(static_cast<void*>(&value), 0, sizeof value); // padding too: it may become a field
    write_fields(typename Fields<C>::Cpp{}, value);
    value.struct_size = sizeof(C);
    return value;
}

[[nodiscard]] inline ParallelFor loop_of(const windrow_parallel_for* parallel_for) {
    return parallel_for != nullptr ? ParallelFor{parallel_for->run, parallel_for->context} : ParallelFor{};
}

// --- Versioned structs -------------------------------------------------------------------------------------------------
/// False with a reason where the size of a struct that the host fills cannot be right. That of an older header's is a multiple of its
/// alignment: any other would cut a pointer in two.
template <Versioned C>
[[nodiscard]] bool has_size(Reasons& reasons, const Path& path, const C* from) {
    if (from->struct_size >= 2 * sizeof(std::uint32_t) && (from->struct_size > sizeof(C) || from->struct_size % alignof(C) == 0))
        return true;
    reasons.add(path, " has struct_size ", from->struct_size, ": call ", Fields<C>::k_name, "_init(&it, sizeof it) first.");
    return false;
}

template <Versioned C>
[[nodiscard]] bool take(Reasons& reasons, const Path& path, const C* from, C& taken) {
    if (!has_size(reasons, path, from))
        return false;
    const std::size_t size = from->struct_size;
    const auto* const bytes = reinterpret_cast<const unsigned char*>(from);
    if (size > sizeof(C) && std::any_of(bytes + sizeof(C), bytes + size, [](unsigned char byte) { return byte != 0; })) {
        reasons.add(path, " is a ", Fields<C>::k_name, " of ", size, " bytes with settings that windrow ", WINDROW_VERSION_STRING,
                    " does not have: use its headers, or leave them 0.");
        return false;
    }
    if (size < sizeof(C))
        taken = default_of<C>();
    std::memcpy(&taken, from, std::min(size, sizeof(C)));
    return true;
}

template <class C>
void read_versioned(Reasons& reasons, const Path& path, const C* from, typename Fields<C>::Cpp& to) {
    C taken;
    if (take(reasons, path, from, taken))
        read_fields(reasons, path, taken, to);
}

/// A struct of the host's as one of C++: an error with all reasons, or `use` of it.
template <Versioned C, class Use>
[[nodiscard]] windrow_result with(const C* from, const Use& use) {
    Reasons reasons;
    typename Fields<C>::Cpp value{};
    read_versioned(reasons, Path{nullptr, Fields<C>::k_name}, from, value);
    if (!reasons.empty())
        return fail(WINDROW_REJECTED, reasons.take());
    return done(use(value));
}

/// A call that makes an object of a handle from settings.
template <Versioned C, class Handle, class Make>
[[nodiscard]] windrow_result create_from(const C* settings, Handle** out, const Make& make) {
    if (out != nullptr)
        *out = nullptr;
    return call({{settings, "settings"}, {out, "the place of the new handle"}},
                [&] { return with(settings, [&](const auto& wanted) { return create(out, [&] { return make(wanted); }); }); });
}

template <Versioned C>
[[nodiscard]] windrow_result init(C* value, std::uint32_t size) {
    return call({{value, "the struct"}}, [&]() -> windrow_result {
        if (size < 2 * sizeof(std::uint32_t))
            return fail(WINDROW_REJECTED,
                        detail::message("struct_size is ", size, ": give the size of ", Fields<C>::k_name, "."));
        C all = default_of<C>();
        all.struct_size = size;
        std::memset(static_cast<void*>(value), 0, size);
        std::memcpy(static_cast<void*>(value), &all, std::min<std::size_t>(size, sizeof(C)));
        return WINDROW_OK;
    });
}

/// Whether `to` may be written: null counts as not wanted.
template <Versioned C>
[[nodiscard]] windrow_result check_output(const C* to) {
    if (to == nullptr || to->struct_size >= 2 * sizeof(std::uint32_t)) [[likely]]
        return WINDROW_OK;
    Reasons reasons;
    (void)has_size(reasons, Path{nullptr, Fields<C>::k_name}, to);
    return fail(WINDROW_REJECTED, reasons.take());
}

/// Fills a struct of the host's as far as it reaches.
template <Versioned C>
void give(const C& value, C* to) {
    if (to == nullptr)
        return;
    const std::uint32_t size = to->struct_size;
    C all = value;
    all.struct_size = size;
    std::memcpy(static_cast<void*>(to), &all, std::min<std::size_t>(size, sizeof(C)));
}
template <Versioned C>
void give_cpp(const typename Fields<C>::Cpp& from, C* to) {
    if (to == nullptr)
        return;
    C all{};
    write_fields(from, all);
    give(all, to);
}

} // namespace windrow::c_api
