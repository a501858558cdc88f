// Writes settings as JSON by their tables (fluid/setting.h): every setting of a scene file, with the digits that name it. What
// `read_object` makes of it is the same settings again.
#pragma once

#include "fluid/core/validation.h"
#include "scene/number_text.h"
#include "scene/scene.h"

#include <cmath>
#include <concepts>
#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <nlohmann/json.hpp>
#include <string>

namespace windrow::scene {

/// A number as a person writes it: 30, not 30.0, and 0.1 for the float nearest to it.
template <class Number>
[[nodiscard]] nlohmann::json written(Number value) {
    if constexpr (std::is_floating_point_v<Number>) {
        if (value == std::trunc(value) && std::abs(value) < Number{1e15f})
            return static_cast<std::int64_t>(value);
        return parse_number(detail::message(value)).value_or(static_cast<double>(value));
    } else {
        return value;
    }
}
template <int Count, class Number>
[[nodiscard]] nlohmann::json written(const glm::vec<Count, Number, glm::defaultp>& values) {
    nlohmann::json list = nlohmann::json::array();
    for (int n = 0; n < Count; ++n)
        list.push_back(written(values[n]));
    return list;
}

template <class Struct>
[[nodiscard]] nlohmann::json write_object(const Struct& value);

template <class Value>
[[nodiscard]] nlohmann::json write_value(const Value& value) {
    if constexpr (std::is_enum_v<Value>)
        return k_words<Value>.at(static_cast<std::size_t>(value));
    else if constexpr (detail::k_is_variant<Value>)
        return std::visit([](const auto& kind) { return nlohmann::json{{kind.k_name, write_object(kind)}}; }, value);
    else if constexpr (HasSettings<Value>)
        return write_object(value);
    else if constexpr (detail::k_is_list<Value>) {
        nlohmann::json list = nlohmann::json::array();
        for (const auto& item : value)
            list.push_back(write_object(item));
        return list;
    } else if constexpr (detail::k_is_number_list<Value>) {
        nlohmann::json list = nlohmann::json::array();
        for (const float number : value)
            list.push_back(written(number));
        return list;
    } else
        return written(value);
}

/// Left out is what a file cannot hold, what is shared and has a file of its own, an optional without a value and a number that is infinite by default, and an empty text.
/// The settings of a struct without a name are the object's own.
template <class Struct>
[[nodiscard]] nlohmann::json write_object(const Struct& value) {
    nlohmann::json object = nlohmann::json::object();
    for_each_setting(value, [&]<class Row>(const Row& row, const auto& member) {
        using Member = std::remove_cvref_t<decltype(member)>;
        if constexpr (Row::k_stored != Stored::everywhere || requires { typename Member::element_type; }) {
        } else if constexpr (std::same_as<Member, glm::quat>) {
            if (member != Member(1.0f, 0.0f, 0.0f, 0.0f))
                object["turn_deg"] = written(turn_of(member));
        } else if constexpr (detail::k_is_optional<Member>) {
            if (member)
                object[row.name] = write_value(*member);
        } else if constexpr (std::is_floating_point_v<Member>) {
            if (std::isfinite(member))
                object[row.name] = written(member);
        } else if constexpr (std::same_as<Member, std::string>) {
            if (!member.empty())
                object[row.name] = member;
        } else if (*row.name == '\0') {
            object.update(write_value(member));
        } else {
            object[row.name] = write_value(member);
        }
    });
    return object;
}

} // namespace windrow::scene
