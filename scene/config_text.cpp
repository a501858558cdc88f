#include "scene/config_text.h"

#include "fluid/core/message.h"
#include "fluid/core/validation.h"

#include <cmath>
#include <concepts>
#include <type_traits>
#include <vector>

namespace windrow::scene {
namespace {

using detail::message;

/// The names of types that an initialiser has to spell. A new one without a name does not compile.
template <class Type>
inline constexpr const char* k_type_name = nullptr;
template <>
inline constexpr const char* k_type_name<BoundaryKind> = "windrow::BoundaryKind";
template <>
inline constexpr const char* k_type_name<Scheme> = "windrow::Scheme";
template <>
inline constexpr const char* k_type_name<Interpolation> = "windrow::Interpolation";
template <>
inline constexpr const char* k_type_name<LogProfile> = "windrow::LogProfile";
template <>
inline constexpr const char* k_type_name<Canopy> = "windrow::Canopy";
template <>
inline constexpr const char* k_type_name<Roughness> = "windrow::Roughness";
template <>
inline constexpr const char* k_type_name<Rows> = "windrow::Rows";
template <>
inline constexpr const char* k_type_name<glm::bvec3> = "glm::bvec3";

std::string number_text(bool value) {
    return value ? "true" : "false";
}
template <std::integral Number>
std::string number_text(Number value) {
    return message(value) + (std::is_unsigned_v<Number> ? "u" : "");
}
template <std::floating_point Number>
std::string number_text(Number value) {
    std::string digits = message(value);
    if (digits.find_first_of(".e") == std::string::npos)
        digits += ".0";
    return digits + (std::same_as<Number, float> ? "f" : "");
}

std::string joined(const std::vector<std::string>& parts) {
    std::string text = "{";
    for (const std::string& part : parts)
        text += (text.size() > 1 ? ", " : "") + part;
    return text + "}";
}

template <class Struct>
std::string struct_text(const Struct& value);

template <class Value>
inline constexpr bool k_is_vec = false;
template <int Count, class Number>
inline constexpr bool k_is_vec<glm::vec<Count, Number, glm::defaultp>> = true;

template <class Value>
std::string value_text(const Value& value) {
    if constexpr (std::is_enum_v<Value>) {
        static_assert(k_type_name<Value> != nullptr);
        return message(k_type_name<Value>, "::", k_words<Value>.at(static_cast<std::size_t>(value)));
    } else if constexpr (k_is_vec<Value>) {
        std::vector<std::string> parts;
        for (int n = 0; n < Value::length(); ++n)
            parts.push_back(number_text(value[n]));
        return joined(parts);
    } else if constexpr (detail::k_is_optional<Value>) { // which braces alone would not make
        using Held = typename Value::value_type;
        if constexpr (std::is_arithmetic_v<Held>)
            return number_text(*value);
        else {
            static_assert(k_type_name<Held> != nullptr);
            return k_type_name<Held> + value_text(*value);
        }
    } else if constexpr (detail::k_is_number_list<Value>) {
        std::vector<std::string> parts;
        for (const auto number : value)
            parts.push_back(number_text(number));
        return joined(parts);
    } else if constexpr (HasSettings<Value>) {
        return struct_text(value);
    } else {
        return number_text(value);
    }
}

template <class Struct>
std::string struct_text(const Struct& value) {
    static const Struct k_defaults{};
    std::vector<std::string> parts;
    for_each_setting(value, [&]<class Row>(const Row& row, const auto& member) {
        using Member = std::remove_cvref_t<decltype(member)>;
        if constexpr (Row::k_stored == Stored::everywhere && !std::same_as<Member, std::optional<RoughnessMap>>) {
            std::string text, before;
            if constexpr (detail::k_is_optional<Member>) {
                if (!member)
                    return;
                text = value_text(member);
            } else {
                text = value_text(member);
                before = value_text(k_defaults.*row.member);
            }
            if (text != before)
                parts.push_back(message(".", row.name, " = ", text));
        }
    });
    return joined(parts);
}

} // namespace

Result<std::string> write_cpp(const Config& config) {
    if (config.roughness && config.roughness->map)
        return Error{"$.air.roughness.map is a file, which C++ text cannot hold: read the scene file, or take the map out."};
    return "windrow::Config" + struct_text(config);
}

} // namespace windrow::scene
