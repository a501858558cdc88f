#include "vegetation/view/controls.h"

#include <imgui_stdlib.h>

namespace windrow::vegetation::view {

std::string range_text(const Range& range) {
    std::string text;
    const bool low = std::isfinite(range.min) && range.min > -1e30, high = std::isfinite(range.max) && range.max < 1e30;
    if (range.measure == Measure::direction)
        return "any direction";
    if (low && high)
        text = windrow::detail::message(range.above_min ? "above " : "", range.min, " to ", range.max);
    else if (low)
        text = windrow::detail::message(range.above_min ? "above " : "", range.min, range.above_min ? "" : " or more");
    else
        text = "any number";
    if (*range.unit != '\0')
        text += std::string(" ") + range.unit;
    if (*range.zero != '\0')
        text += std::string("; 0: ") + range.zero;
    return text;
}

namespace controls {

void note(const char* name, const std::string& text, double min, double max, bool bounded) {
    if (control_records != nullptr)
        control_records->push_back({name, text, min, max, bounded});
}

void explain(const std::string& text) {
    if (!ImGui::IsItemHovered())
        return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * 24.0f);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

float drag_speed(double value, const Range& range) {
    const double wide = range.max - range.min;
    const double of_range = std::isfinite(wide) ? wide / 200.0 : 1.0;
    return static_cast<float>(std::clamp(std::max(value / 100.0, 1e-3), std::min(of_range, 1e-3), std::max(of_range, 1e-3)));
}

bool edit_choice(const char* label, int& chosen, const char* const* names, int count, const std::string& text) {
    note(label, text, 0.0, count - 1, true);
    const bool changed = ImGui::Combo(label, &chosen, names, count);
    explain(text);
    return changed;
}

bool edit_flag(const char* label, bool& flag, const std::string& text) {
    note(label, text, 0.0, 1.0, true);
    const bool changed = ImGui::Checkbox(label, &flag);
    explain(text);
    return changed;
}

bool edit_text(const char* label, std::string& words, const std::string& text) {
    note(label, text, 0.0, 0.0, false);
    const bool changed = ImGui::InputText(label, &words);
    explain(text);
    return changed;
}

bool begin_group(const char* label, const std::string& text) {
    note(label, text, 0.0, 0.0, false);
    const bool open = control_records != nullptr ? (ImGui::TreePush(label), true) : ImGui::TreeNode(label);
    if (control_records == nullptr)
        explain(text);
    return open;
}

void end_group() {
    ImGui::TreePop();
}

bool edit_switch(const char* label, bool& on, const std::string& text) {
    note(label, text, 0.0, 1.0, true);
    const bool changed = ImGui::Checkbox(label, &on);
    explain(text);
    return changed;
}

} // namespace controls
} // namespace windrow::vegetation::view
