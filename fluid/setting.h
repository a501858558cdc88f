// The settings of a struct as a table: name, range, unit and meaning of each.
//
//     struct Canopy {
//         float height = 0.8f;
//         static constexpr auto settings() {
//             return std::tuple{Setting("height", &Canopy::height, {0.0, 1000.0, "m"}, "Height of the plants.")};
//         }
//     };
//
// Validation, scene files, their schema, snapshots and the tables in docs/ are made from these rows. A new setting is its
// declaration, with the default, and its row.
#pragma once

#include "api.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <tuple>
#include <type_traits>
#include <variant>

namespace windrow {

/// Quantity of a vector that a range bounds.
enum class Measure : std::uint8_t {
    component, ///< each component
    length,    ///< the length
    direction, ///< each component, and the length is not 0
};

/// Range of a number.
struct Range {
    double min = -std::numeric_limits<double>::infinity();
    double max = std::numeric_limits<double>::infinity();
    const char* unit = "";  ///< "m/s"; empty: none
    const char* zero = "";  ///< what 0 means where that is special: "never"
    bool above_min = false; ///< `min` itself is rejected
    Measure measure = Measure::component;
    const char* pair = "x, z"; ///< what two numbers are

    /// False for NaN. A float is compared with the bounds as floats, so that 0.9f holds a bound of 0.9.
    template <class Number>
    [[nodiscard]] constexpr bool holds(Number value) const {
        using Compared = std::conditional_t<std::is_floating_point_v<Number>, Number, double>;
        const auto number = static_cast<Compared>(value);
        return (above_min ? number > static_cast<Compared>(min) : number >= static_cast<Compared>(min)) &&
               number <= static_cast<Compared>(max);
    }
    [[nodiscard]] static constexpr Range above(double min, double max, const char* unit = "") {
        return {min, max, unit, "", true};
    }
    [[nodiscard]] static constexpr Range length(double min, double max, const char* unit) {
        return {min, max, unit, "", false, Measure::length};
    }
    /// The same of two numbers with these names.
    [[nodiscard]] constexpr Range of_pair(const char* names) const {
        Range named = *this;
        named.pair = names;
        return named;
    }
    /// Components of any finite size.
    [[nodiscard]] static constexpr Range direction() {
        constexpr double k_most = std::numeric_limits<float>::max();
        return {-k_most, k_most, "", "", false, Measure::direction};
    }
};

/// Ranges of settings in several structs.
inline constexpr Range k_fraction_range{0.0, 1.0};
inline constexpr Range k_size_range = Range::above(0.0, 1e6, "m");
inline constexpr Range k_speed_range{-1e4, 1e4, "m/s"};
inline constexpr Range k_seed_range{0.0, std::numeric_limits<std::uint32_t>::max()};
/// Of a position in the world: beyond it a double no longer resolves millimetres.
inline constexpr Range k_world_range{-1e12, 1e12, "m"};

/// Places where the value of a setting is stored.
enum class Stored : std::uint8_t {
    everywhere,   ///< in scene files and in snapshots
    in_snapshots, ///< in snapshots alone
    nowhere,      ///< it belongs to the host: threads, shared tables
};
template <Stored S>
using StoredAs = std::integral_constant<Stored, S>;
inline constexpr StoredAs<Stored::in_snapshots> k_in_snapshots;
inline constexpr StoredAs<Stored::nowhere> k_not_stored;

template <class Struct, class Value, Stored S = Stored::everywhere>
struct Setting {
    constexpr Setting(const char* its_name, Value Struct::*its_member, const Range& its_range, const char* its_meaning)
        : name(its_name), member(its_member), range(its_range), meaning(its_meaning) {}
    /// Of a struct, a choice or a flag.
    constexpr Setting(const char* its_name, Value Struct::*its_member, const char* its_meaning, StoredAs<S> = {})
        : Setting(its_name, its_member, Range{}, its_meaning) {}

    using Owner = Struct;
    static constexpr Stored k_stored = S;
    const char* name; ///< also the key in a scene file
    Value Struct::*member;
    Range range;
    const char* meaning; ///< what it is, why the default, what other values do
};
template <class Struct, class Value>
Setting(const char*, Value Struct::*, const Range&, const char*) -> Setting<Struct, Value>;
template <class Struct, class Value>
Setting(const char*, Value Struct::*, const char*) -> Setting<Struct, Value>;

/// The names of an enumeration's values, from 0 on; specialised beside it.
template <class Enumeration>
inline constexpr std::array<const char*, 0> k_words{};

/// The names of the structs that a variant takes, in its order.
template <class Variant>
inline constexpr std::array<const char*, 0> k_alternatives{};
template <class... Kinds>
inline constexpr std::array<const char*, sizeof...(Kinds)> k_alternatives<std::variant<Kinds...>>{Kinds::k_name...};

template <class Struct>
concept HasSettings = requires {
    std::remove_cvref_t<Struct>::settings();
};

namespace detail {

struct AnyMember {
    template <class Value>
    operator Value() const; // in unevaluated code only
};
/// Number of members of an aggregate.
template <class Struct, class... Members>
consteval std::size_t member_count() {
    if constexpr (requires { Struct{Members{}..., AnyMember{}}; })
        return member_count<Struct, Members..., AnyMember>();
    else
        return sizeof...(Members);
}

} // namespace detail

/// Calls visit(setting, value) for each setting in order; the struct may be const.
template <class Struct, class Visit>
requires HasSettings<Struct>
constexpr void for_each_setting(Struct& value, const Visit& visit) {
    using Plain = std::remove_const_t<Struct>;
    static_assert(detail::member_count<Plain>() == std::tuple_size_v<decltype(Plain::settings())>, "a member has no row");
    std::apply([&](const auto&... setting) { (visit(setting, value.*setting.member), ...); }, Plain::settings());
}

} // namespace windrow
