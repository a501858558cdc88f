// Controls of Dear ImGui made from the tables of settings: name, unit, range, default and meaning of each row.
//
//     Motor motor = session.motors()[n].motor;
//     if (view::edit(motor) && !session.set_motor(n, motor)) ...       // what a table or a rule rejects is shown in red
//
// A slider moves within the row's range; what is typed may leave it, and validation then says why.
#pragma once

#include "fluid/core/message.h"
#include "fluid/core/validation.h"
#include "fluid/setting.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <imgui.h>
#include <string>
#include <vector>

namespace windrow::vegetation::view {

/// What a control was given, for the test that compares it with the table.
struct ControlRecord {
    std::string name, text; ///< of the row; what a pointer over it reads
    double min = 0.0, max = 0.0;
    bool bounded = false;
};
/// Where controls are noted; null: nowhere.
inline std::vector<ControlRecord>* control_records = nullptr;

/// "0 to 10 m/s".
[[nodiscard]] std::string range_text(const Range& range);

namespace controls {

template <class Number>
inline constexpr ImGuiDataType k_type = std::is_same_v<Number, float>           ? ImGuiDataType_Float
                                        : std::is_same_v<Number, double>        ? ImGuiDataType_Double
                                        : std::is_same_v<Number, int>           ? ImGuiDataType_S32
                                        : std::is_same_v<Number, std::uint32_t> ? ImGuiDataType_U32
                                                                                : ImGuiDataType_COUNT;

template <class Value>
inline constexpr bool k_is_vector = false;
template <int Count, class Number>
inline constexpr bool k_is_vector<glm::vec<Count, Number, glm::defaultp>> = true;

/// A bound as a control has it: that of the row, within what the type holds.
template <class Number>
[[nodiscard]] Number bound(double value) {
    constexpr auto lowest = static_cast<double>(std::numeric_limits<Number>::lowest()),
                   highest = static_cast<double>(std::numeric_limits<Number>::max());
    return value <= lowest ? std::numeric_limits<Number>::lowest()
                           : (value >= highest ? std::numeric_limits<Number>::max() : static_cast<Number>(value));
}

void note(const char* name, const std::string& text, double min, double max, bool bounded);
/// Under the pointer: meaning, range and default.
void explain(const std::string& text);

/// How far a pixel of a drag goes: a hundredth of the value, or of a small range.
[[nodiscard]] float drag_speed(double value, const Range& range);

template <class Number>
bool edit_numbers(const char* label, Number* values, int count, const Range& range, const std::string& text) {
    const Number min = bound<Number>(range.min), max = bound<Number>(range.max);
    const bool bounded = range.measure == Measure::component; // a length bounds no single component
    note(label, text, static_cast<double>(min), static_cast<double>(max), bounded);
    double most = 0.0;
    for (int n = 0; n < count; ++n)
        most = std::max(most, std::abs(static_cast<double>(values[n])));
    const bool changed =
        ImGui::DragScalarN(label, k_type<Number>, values, count, drag_speed(most, range), bounded ? &min : nullptr,
                           bounded ? &max : nullptr, std::is_floating_point_v<Number> ? "%.4g" : nullptr);
    explain(text);
    return changed;
}

[[nodiscard]] bool edit_choice(const char* label, int& chosen, const char* const* names, int count, const std::string& text);
[[nodiscard]] bool edit_flag(const char* label, bool& flag, const std::string& text);
[[nodiscard]] bool edit_text(const char* label, std::string& words, const std::string& text);
[[nodiscard]] bool begin_group(const char* label, const std::string& text);
void end_group();
[[nodiscard]] bool edit_switch(const char* label, bool& on, const std::string& text);

} // namespace controls

template <class Struct>
bool edit(Struct& value);

/// The control of one member; `start` is its default.
template <class Member>
bool edit_member(const char* name, Member& member, const Member& start, const Range& range, std::string text) {
    using namespace controls;
    if constexpr (std::is_same_v<Member, bool>)
        return edit_flag(name, member, text);
    else if constexpr (std::is_arithmetic_v<Member> && k_type<Member> != ImGuiDataType_COUNT) {
        text += windrow::detail::message("\n", range_text(range), ", default ", start);
        return edit_numbers(name, &member, 1, range, text);
    } else if constexpr (std::is_same_v<Member, glm::quat>) {
        glm::vec3 turn = glm::degrees(glm::eulerAngles(member));
        constexpr Range k_turn{-360.0, 360.0, "deg"};
        const bool changed = edit_numbers(name, &turn.x, 3, k_turn, text + "\nPitch, yaw and roll, " + range_text(k_turn));
        if (changed)
            member = glm::quat(glm::radians(turn));
        return changed;
    } else if constexpr (k_is_vector<Member>) {
        using Number = typename Member::value_type;
        if constexpr (std::is_same_v<Number, bool>) {
            return false; // axes that the box follows
        } else {
            text += windrow::detail::message("\n", range_text(range));
            return edit_numbers(name, &member[0], Member::length(), range, text);
        }
    } else if constexpr (std::is_enum_v<Member>) {
        int chosen = static_cast<int>(member);
        const auto& words = k_words<Member>;
        if (!edit_choice(name, chosen, words.data(), static_cast<int>(words.size()), text))
            return false;
        member = static_cast<Member>(chosen);
        return true;
    } else if constexpr (std::is_same_v<Member, std::string>) {
        return edit_text(name, member, text);
    } else if constexpr (windrow::detail::k_is_optional<Member>) {
        using Value = typename Member::value_type;
        bool on = member.has_value();
        bool changed = edit_switch(name, on, text);
        if (changed)
            member = on ? Member(Value{}) : std::nullopt;
        ImGui::PushID(name);
        if (member)
            changed = edit_member(name, *member, Value{}, range, text) || changed;
        ImGui::PopID();
        return changed;
    } else if constexpr (windrow::detail::k_is_variant<Member>) {
        int chosen = static_cast<int>(member.index());
        bool changed = false;
        const auto& names = k_alternatives<Member>;
        if (edit_choice(name, chosen, names.data(), static_cast<int>(names.size()), text)) {
            [&]<std::size_t... N>(std::index_sequence<N...>) {
                ((static_cast<int>(N) == chosen ? void(member.template emplace<N>()) : void()), ...);
            }
            (std::make_index_sequence<std::variant_size_v<Member>>());
            changed = true;
        }
        ImGui::PushID(name);
        ImGui::Indent();
        changed = std::visit([](auto& kind) { return edit(kind); }, member) || changed;
        ImGui::Unindent();
        ImGui::PopID();
        return changed;
    } else if constexpr (HasSettings<Member>) {
        if (*name == '\0')
            return edit(member);
        if (!begin_group(name, text))
            return false;
        const bool changed = edit(member);
        end_group();
        return changed;
    } else {
        return false; // files, tables and lists are the scene file's
    }
}

/// A control for each row of the table that a scene file has; true where a value changed.
template <class Struct>
bool edit(Struct& value) {
    static const Struct k_defaults{};
    bool changed = false;
    for_each_setting(value, [&]<class Row>(const Row& row, auto& member) {
        if constexpr (Row::k_stored == Stored::everywhere)
            changed = edit_member(row.name, member, k_defaults.*row.member, row.range, row.meaning) || changed;
    });
    return changed;
}

} // namespace windrow::vegetation::view
