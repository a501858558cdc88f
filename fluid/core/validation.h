// Validation of settings by their tables (setting.h). A rule between settings is the struct's own function,
// `void check_rules(detail::Reasons&, const detail::FieldPath&, const Struct&)` in the struct's namespace.
#pragma once

#include "fluid/api.h"
#include "fluid/core/message.h"
#include "fluid/setting.h"

#include <cmath>
#include <concepts>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace windrow::detail {

/// Path of a setting: "motor.region.sphere.radius". A list on the stack, since a check allocates nothing but its sentence.
struct FieldPath {
    const FieldPath* owner = nullptr; ///< null: the outermost
    std::string_view name;            ///< empty: its settings are named by themselves; "[2]": an item
};
WINDROW_INTERNAL void append(std::string& text, const FieldPath& path);

/// Range of a number as text: "0 (never) to 1e9 s".
struct Bounds {
    Range range;
};
WINDROW_INTERNAL void append(std::string& text, const Bounds& bounds);

/// Range of a vector as text: "each component -1e4 to 1e4 m/s".
struct VectorBounds {
    Range range;
};
WINDROW_INTERNAL void append(std::string& text, const VectorBounds& bounds);

/// Names of a choice as text: "open, free_slip or periodic".
struct Choice {
    std::span<const char* const> words;
};
WINDROW_INTERNAL void append(std::string& text, const Choice& choice);

/// A unit behind a number, with a space before it.
struct Unit {
    std::string_view name;
};
WINDROW_INTERNAL void append(std::string& text, const Unit& unit);

/// A number as a person writes it: 500000, 0.25, 1e6, 1e-9.
struct Figure {
    double value;
};
WINDROW_INTERNAL void append(std::string& text, const Figure& figure);

template <class T>
inline constexpr bool k_is_optional = false;
template <class T>
inline constexpr bool k_is_optional<std::optional<T>> = true;
template <class T>
inline constexpr bool k_is_variant = false;
template <class... T>
inline constexpr bool k_is_variant<std::variant<T...>> = true;
template <class T>
inline constexpr bool k_is_list = false;
template <HasSettings T>
inline constexpr bool k_is_list<std::vector<T>> = true;
template <class T>
inline constexpr bool k_is_number_list = std::same_as<T, std::vector<float>>;

template <int Count, class Number, glm::qualifier Q>
[[nodiscard]] bool holds(const Range& range, const glm::vec<Count, Number, Q>& vector) {
    double square = 0.0;
    bool each = true;
    for (int n = 0; n < Count; ++n) {
        square += static_cast<double>(vector[n]) * static_cast<double>(vector[n]);
        each = each && range.holds(vector[n]);
    }
    if (range.measure == Measure::length)
        return range.holds(std::sqrt(square));
    return each && (range.measure != Measure::direction || vector != glm::vec<Count, Number, Q>(Number{0}));
}

template <class Value>
void check_value(Reasons& reasons, const FieldPath& path, const Value& value, const Range& range);

/// Every setting of a struct, and its rules.
template <class Struct>
void check_settings(Reasons& reasons, const FieldPath& path, const Struct& value) {
    for_each_setting(value, [&](const auto& setting, const auto& member) {
        check_value(reasons, FieldPath{&path, setting.name}, member, setting.range);
    });
    if constexpr (requires { check_rules(reasons, path, value); })
        check_rules(reasons, path, value);
}

/// A list of structs; the range bounds how many.
template <class Item>
void check_items(Reasons& reasons, const FieldPath& path, std::span<const Item> items, const Range& range) {
    if (!range.holds(items.size()))
        return reasons.add(path, " has ", items.size(), " entries: give ", Bounds{range}, ".");
    for (std::size_t n = 0; n < items.size(); ++n)
        check_settings(reasons, FieldPath{&path, message("[", n, "]")}, items[n]);
}

template <int Count, class Number, glm::qualifier Q>
void check_vector(Reasons& reasons, const FieldPath& path, const glm::vec<Count, Number, Q>& value, const Range& range) {
    if constexpr (!std::same_as<Number, bool>)
        if (!holds(range, value))
            reasons.add(path, " is ", value, Unit{range.unit}, ": give ", VectorBounds{range}, ".");
}

/// An orientation of any length but 0.
template <class Number, glm::qualifier Q>
void check_vector(Reasons& reasons, const FieldPath& path, const glm::qua<Number, Q>& value, const Range&) {
    const glm::vec<4, Number, Q> numbers(value.x, value.y, value.z, value.w);
    if (!holds(Range::direction(), numbers))
        reasons.add(path, " is ", numbers, ": give a finite quaternion x, y, z, w that is not 0.");
}

template <class Value>
void check_value(Reasons& reasons, const FieldPath& path, const Value& value, const Range& range) {
    if constexpr (std::same_as<Value, bool>) {
    } else if constexpr (std::is_arithmetic_v<Value>) {
        if (!range.holds(value))
            reasons.add(path, " is ", value, Unit{range.unit}, ": give ", Bounds{range}, ".");
    } else if constexpr (std::is_enum_v<Value>) {
        const auto index = static_cast<std::size_t>(value);
        if (index >= k_words<Value>.size())
            reasons.add(path, " is ", index, ": give ", Choice{k_words<Value>}, ".");
    } else if constexpr (k_is_optional<Value>) {
        if (value)
            check_value(reasons, path, *value, range);
    } else if constexpr (k_is_variant<Value>) {
        std::visit([&](const auto& kind) { check_settings(reasons, FieldPath{&path, kind.k_name}, kind); }, value);
    } else if constexpr (k_is_list<Value>) {
        check_items(reasons, path, std::span(value), range);
    } else if constexpr (k_is_number_list<Value>) {
        for (std::size_t n = 0; n < value.size(); ++n)
            check_value(reasons, FieldPath{&path, message("[", n, "]")}, value[n], range);
    } else if constexpr (HasSettings<Value>) {
        check_settings(reasons, path, value);
    } else if constexpr (requires { check_vector(reasons, path, value, range); }) {
        check_vector(reasons, path, value, range);
    } // what is left belongs to the host
}

/// The whole of a `validate`.
template <class Struct>
[[nodiscard]] Result<void> validate_settings(const Struct& value, std::string_view name = {}) {
    Reasons reasons;
    check_settings(reasons, FieldPath{nullptr, name}, value);
    return reasons.outcome();
}

} // namespace windrow::detail
