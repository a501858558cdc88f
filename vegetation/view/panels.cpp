#include "fluid/core/message.h"
#include "vegetation/view/controls.h"
#include "vegetation/view/desk.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <imgui_stdlib.h>
#include <numbers>

namespace windrow::vegetation::view {
namespace {

using detail::message;

constexpr float k_left = 300.0f, k_right = 200.0f; // [px] width of the panels

/// [m/s] Mean speed 10 m above the ground of a force of Beaufort's scale: WMO-No. 8, 0.836 B^1.5.
double speed_of_force(double force) {
    return 0.836 * std::pow(force, 1.5);
}

constexpr std::array k_winds{"0 calm",         "1 light air",      "2 light breeze", "3 gentle breeze", "4 moderate breeze",
                             "5 fresh breeze", "6 strong breeze",  "7 near gale",    "8 gale",          "9 strong gale",
                             "10 storm",       "11 violent storm", "12 hurricane"};

void red(const std::string& sentence) {
    if (sentence.empty())
        return;
    ImGui::PushStyleColor(ImGuiCol_Text, IM_COL32(255, 90, 80, 255));
    ImGui::TextWrapped("%s", sentence.c_str());
    ImGui::PopStyleColor();
}

/// An edited copy: shown in red, with its reason, while validation rejects it.
template <class Value, class Judge, class Take>
void edit_copy(Value& copy, const Judge& judge, const Take& take) {
    const auto valid = judge(copy);
    if (!valid)
        ImGui::PushStyleColor(ImGuiCol_FrameBg, IM_COL32(140, 30, 30, 255));
    const bool changed = edit(copy);
    if (!valid)
        ImGui::PopStyleColor();
    if (const auto now = judge(copy); !now)
        red(now.error());
    else if (changed)
        take(copy);
}

void play_controls(Desk& desk) {
    if (ImGui::Button(desk.playing ? "Pause" : "Play", {70.0f, 0.0f}))
        desk.playing = !desk.playing;
    ImGui::SameLine();
    if (ImGui::Button("Step")) {
        desk.playing = false;
        (void)desk.done(desk.session.step());
    }
    ImGui::SameLine();
    if (ImGui::Button("Restart") && desk.done(desk.session.restart()))
        desk.tell("restarted");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(80.0f);
    constexpr std::array rates{0.25, 0.5, 1.0, 2.0, 4.0};
    constexpr std::array names{"1/4", "1/2", "1", "2", "4 times"};
    int rate = static_cast<int>(std::ranges::find(rates, desk.rate) - rates.begin());
    if (ImGui::Combo("##rate", &rate, names.data(), static_cast<int>(names.size())))
        desk.rate = rates[static_cast<std::size_t>(rate)];
    const double first = desk.session.earliest(), last = desk.session.latest();
    double time = desk.session.time();
    ImGui::SetNextItemWidth(-1.0f);
    if (ImGui::SliderScalar("##time", ImGuiDataType_Double, &time, &first, &last, "%.2f s")) {
        desk.playing = false;
        if (desk.done(desk.session.seek(time)))
            desk.tell("went back");
    }
}

/// A dial of where the wind blows to, seen from above: x to the right, z down.
bool compass(double& angle) {
    constexpr float k_radius = 34.0f;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 middle(corner.x + k_radius, corner.y + k_radius);
    ImGui::InvisibleButton("compass", {2.0f * k_radius, 2.0f * k_radius});
    bool changed = false;
    if (ImGui::IsItemActive()) {
        const ImVec2 mouse = ImGui::GetIO().MousePos;
        angle = std::atan2(static_cast<double>(mouse.y - middle.y), static_cast<double>(mouse.x - middle.x));
        changed = true;
    }
    controls::explain("Where the mean wind blows to, seen from above: x to the right, z downward. Drag the needle.");
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddCircle(middle, k_radius - 1.0f, IM_COL32(200, 200, 200, 255), 32);
    const ImVec2 way(static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)));
    const float length = k_radius - 6.0f;
    list.AddLine({middle.x - length * way.x, middle.y - length * way.y}, {middle.x + length * way.x, middle.y + length * way.y},
                 IM_COL32(120, 180, 255, 255), 2.0f);
    list.AddCircleFilled({middle.x + length * way.x, middle.y + length * way.y}, 4.0f, IM_COL32(120, 180, 255, 255));
    return changed;
}

void wind_controls(Desk& desk) {
    Config air = desk.session.air();
    const glm::dvec2 level(air.ambient.x, air.ambient.z);
    double speed = glm::length(level);
    static double angle = 0.0; // kept while it is calm
    if (speed > 1e-3)
        angle = std::atan2(level.y, level.x);
    bool changed = compass(angle);
    ImGui::SameLine();
    ImGui::BeginGroup();
    int force = std::clamp(static_cast<int>(std::lround(std::pow(speed / 0.836, 2.0 / 3.0))), 0, 12);
    ImGui::SetNextItemWidth(170.0f);
    if (ImGui::Combo("##force", &force, k_winds.data(), static_cast<int>(k_winds.size()))) {
        speed = speed_of_force(force);
        changed = true;
    }
    controls::explain("Mean wind of a force of Beaufort's scale: 0.836 force^1.5 m/s (WMO-No. 8).");
    constexpr double k_least = 0.0, k_most = 40.0;
    ImGui::SetNextItemWidth(170.0f);
    changed = ImGui::SliderScalar("##speed", ImGuiDataType_Double, &speed, &k_least, &k_most, "%.1f m/s") || changed;
    ImGui::Text("to %.0f deg from x", angle * 180.0 / std::numbers::pi);
    ImGui::EndGroup();
    if (changed) {
        air.ambient.x = static_cast<float>(speed * std::cos(angle));
        air.ambient.z = static_cast<float>(speed * std::sin(angle));
        if (desk.done(desk.session.set_air(air)))
            desk.tell(message("wind ", air.ambient));
    }
}

void air_settings(Desk& desk) {
    if (!ImGui::CollapsingHeader("Air: every setting"))
        return;
    static std::optional<Config> copy;
    if (!copy || !ImGui::IsAnyItemActive())
        copy = desk.session.air();
    edit_copy(
        *copy, [](const Config& air) { return validate(air); },
        [&](const Config& air) { (void)desk.done(desk.session.set_air(air)); });
    if (desk.session.waits())
        ImGui::TextWrapped("Ambient wind and gusts act at once, all else from the next restart.");
}

/// What the left button does over the ground.
void hand_controls(Desk& desk) {
    for (int n = 0; n < k_tools; ++n) {
        const auto tool = static_cast<Tool>(n);
        if (n % 4 != 0)
            ImGui::SameLine();
        if (ImGui::RadioButton(name_of(tool).name, desk.tool == tool))
            desk.take(tool);
        controls::explain(message(name_of(tool).meaning, "\nKey ", n + 1));
    }
    if (desk.tool == Tool::choose || desk.tool == Tool::gust)
        return;
    constexpr float k_least = 0.2f, k_most = 10.0f;
    ImGui::SetNextItemWidth(120.0f);
    ImGui::SliderScalar("hand", ImGuiDataType_Float, &desk.brush, &k_least, &k_most, "%.1f m", ImGuiSliderFlags_Logarithmic);
    const auto& layers = desk.session.scene().picture.grass;
    if (desk.tool == Tool::paint && layers.size() > 1) {
        ImGui::SameLine();
        ImGui::SetNextItemWidth(90.0f);
        if (ImGui::BeginCombo("##layer", layers[static_cast<std::size_t>(desk.layer)].name.c_str())) {
            for (std::size_t n = 0; n < layers.size(); ++n)
                if (ImGui::Selectable(layers[n].name.c_str(), desk.layer == static_cast<int>(n)))
                    desk.layer = static_cast<int>(n);
            ImGui::EndCombo();
        }
    }
    const bool paints = desk.tool == Tool::paint || desk.tool == Tool::erase;
    if (paints && !layers.empty())
        if (const float finest = desk.session.finest_brush(static_cast<std::size_t>(desk.layer)); finest > desk.brush)
            ImGui::TextWrapped("This mask shows strokes from %.1f m on: give it more corners (mask.corners).",
                               static_cast<double>(finest));
}

void solver_controls(Desk& desk) {
    if (!ImGui::CollapsingHeader("Solver"))
        return;
    using program::Backend;
    const bool cpu = desk.session.solver() == Backend::cpu;
    if (ImGui::RadioButton("CPU", cpu))
        desk.set_solver(Backend::cpu);
    controls::explain("Keeps the last minute. Key B");
    ImGui::SameLine();
    if (ImGui::RadioButton("device", !cpu))
        desk.set_solver(Backend::vulkan);
    controls::explain("The air goes over as a snapshot. A device keeps no past. Key B");
    ImGui::SameLine();
    if (ImGui::Button("Compare"))
        desk.compare();
    controls::explain("Copies of the air make ten ticks on each. Key C");
    if (desk.difference) {
        const Session::Difference& found = *desk.difference;
        ImGui::TextWrapped("From %.2f s on, after %d ticks: they differ by %.2g m/s, %.2g of the fastest air.", found.time,
                           found.ticks, static_cast<double>(found.largest),
                           static_cast<double>(found.largest / std::max(found.fastest, 1e-30f)));
    }
}

void list_things(Desk& desk) {
    if (!ImGui::CollapsingHeader("Motors and obstacles", ImGuiTreeNodeFlags_DefaultOpen))
        return;
    const glm::dvec3 target = desk.eye.target();
    const glm::dvec3 foot(target.x, desk.ground(target.x, target.z), target.z);
    if (ImGui::Button("Add fan"))
        desk.add_fan(foot);
    ImGui::SameLine();
    if (ImGui::Button("Add house"))
        desk.add_house(foot);
    const auto row = [&](Choice choice, const std::string& name, const char* kind) {
        ImGui::PushID(static_cast<int>(2 * choice.place + (choice.kind == Choice::Kind::motor ? 1 : 0)));
        if (ImGui::Selectable((name + "  (" + kind + ")").c_str(), desk.chosen == choice))
            desk.chosen = choice;
        ImGui::PopID();
    };
    ImGui::BeginChild("things", {0.0f, 76.0f}, true);
    for (std::size_t n = 0; n < desk.session.motors().size(); ++n)
        if (!desk.session.removed_motor(n))
            row({Choice::Kind::motor, n}, desk.session.motors()[n].name,
                std::visit([](const auto& kind) { return kind.k_name; }, desk.session.motors()[n].motor));
    for (std::size_t n = 0; n < desk.session.obstacles().size(); ++n)
        if (desk.session.can_change_obstacle(n) && !desk.session.removed_obstacle(n))
            row({Choice::Kind::obstacle, n}, desk.session.obstacles()[n].name,
                std::visit([](const auto& kind) { return kind.k_name; }, desk.session.obstacles()[n].obstacle.shape));
    ImGui::EndChild();
}

void edit_chosen(Desk& desk) {
    static Choice shown;
    static Motor motor;
    static Obstacle obstacle;
    if (desk.chosen.kind == Choice::Kind::nothing) {
        shown = {};
        return;
    }
    const bool begun = shown != desk.chosen || !ImGui::IsAnyItemActive();
    const std::size_t place = desk.chosen.place;
    const bool is_motor = desk.chosen.kind == Choice::Kind::motor;
    const auto& motors = desk.session.motors();
    const auto& obstacles = desk.session.obstacles();
    ImGui::Separator();
    ImGui::Text("%s", (is_motor ? motors[place].name : obstacles[place].name).c_str());
    ImGui::SameLine();
    if (ImGui::SmallButton("Delete")) {
        desk.remove_chosen();
        return;
    }
    ImGui::PushItemWidth(150.0f);
    if (is_motor) {
        if (begun && (shown != desk.chosen || validate(motor)))
            motor = motors[place].motor;
        ImGui::PushID("motor");
        std::visit(
            [&]<class Kind>(Kind& kind) {
                edit_copy(
                    kind, [](const Kind& one) { return validate(Motor(one)); },
                    [&](const Kind& one) { (void)desk.done(desk.session.set_motor(place, one)); });
            },
            motor);
        ImGui::PopID();
    } else {
        if (begun && (shown != desk.chosen || validate(obstacle)))
            obstacle = obstacles[place].obstacle;
        ImGui::PushID("obstacle");
        edit_copy(
            obstacle, [](const Obstacle& one) { return validate(one); },
            [&](const Obstacle& one) { (void)desk.done(desk.session.set_obstacle(place, one)); });
        ImGui::PopID();
    }
    ImGui::PopItemWidth();
    shown = desk.chosen;
}

void file_controls(Desk& desk) {
    if (!ImGui::CollapsingHeader("Files"))
        return;
    const auto line = [&](const char* what, std::string& name, const auto& act) {
        ImGui::PushID(what);
        ImGui::SetNextItemWidth(190.0f);
        ImGui::InputText("##name", &name);
        ImGui::SameLine();
        if (ImGui::Button(what))
            act();
        ImGui::PopID();
    };
    line("Save scene", desk.scene_file, [&] {
        if (desk.done(desk.session.save(desk.scene_file)))
            desk.tell("saved " + desk.scene_file);
    });
    line("Picture", desk.picture_file, [&] { desk.wants_picture = true; });
    line("Field", desk.fields_file, [&] { desk.save_field(); });
    line("VDB", desk.vdb_file, [&] { desk.save_vdb(); });
    line("C++", desk.cpp_file, [&] { desk.save_cpp(); });
    line("Log", desk.log_folder, [&] { desk.save_log(); });
    line(desk.filming ? "Stop film" : "Film", desk.film_file, [&] { desk.filming ? desk.end_film() : desk.begin_film(); });
}

void view_controls(Desk& desk) {
    if (!ImGui::CollapsingHeader("View"))
        return;
    constexpr std::array eyes{"orbit", "fly", "follow", "scene's camera"};
    int mode = static_cast<int>(desk.eye.mode());
    ImGui::SetNextItemWidth(150.0f);
    if (ImGui::Combo("eye", &mode, eyes.data(), static_cast<int>(eyes.size())))
        desk.eye.set_mode(static_cast<EyeMode>(mode));
    constexpr std::array shows{"plants", "streaks", "arrows", "slice", "lean", "levels", "chunks"};
    int show = static_cast<int>(desk.show);
    ImGui::SetNextItemWidth(150.0f);
    if (ImGui::Combo("show", &show, shows.data(), static_cast<int>(shows.size()))) {
        const auto wanted = static_cast<program::Show>(show);
        if (desk.done(desk.session.player().change({.show = wanted})))
            desk.show = wanted;
    }
    if (desk.show == program::Show::levels)
        ImGui::TextWrapped("Levels of detail: near blades green, yellow as they become far ones, which are blue.");
    else if (desk.show == program::Show::lean)
        ImGui::TextWrapped("Lean of blades by the colours of speed, from 0 to 1.5 rad.");
    constexpr std::array cuts{"none", "pressure", "divergence"};
    int cut = static_cast<int>(desk.slice_of);
    ImGui::SetNextItemWidth(150.0f);
    if (ImGui::Combo("cut", &cut, cuts.data(), static_cast<int>(cuts.size())))
        desk.cut(static_cast<SliceOf>(cut));
    controls::explain(
        "The cells at the height below, coloured. Pressure is relative to that outside of the box; a device has none.");
    ImGui::PushItemWidth(150.0f);
    (void)edit(desk.overlay);
    ImGui::PopItemWidth();
}

/// Under the pointer: what the device's time goes to.
void explain_device(Desk& desk) {
    if (!ImGui::IsItemHovered())
        return;
    std::string text;
    for (const render::StageTime& stage : desk.session.player().times())
        text += message(text.empty() ? "" : "\n", stage.name, ": ", std::lround(1e-3 * stage.us), " ms");
    ImGui::SetTooltip("%s", text.c_str());
}

void draw_figures(Desk& desk) {
    const ImVec2 whole = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({whole.x - k_right, 0.0f});
    ImGui::SetNextWindowSize({k_right, std::min(whole.y, 392.0f)});
    ImGui::SetNextWindowBgAlpha(0.7f);
    ImGui::Begin("Figures", nullptr, ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize);
    ImGui::TextWrapped("%s", desk.device.c_str());
    desk.figures.speed.draw("fastest air", "m/s");
    desk.figures.cfl.draw("CFL", "");
    desk.figures.energy.draw("energy", "m^5/s^2");
    desk.figures.step_ms.draw("step", "ms");
    desk.figures.frame_ms.draw("frame", "ms");
    desk.figures.cpu_ms.draw("CPU a frame", "ms");
    desk.figures.device_ms.draw("device a frame", "ms");
    explain_device(desk);
    const Diagnostics last = desk.session.reader().diagnostics();
    ImGui::Text("%d motor%s in reach%s", last.motors_in_reach, last.motors_in_reach == 1 ? "" : "s",
                last.asleep ? ", asleep" : "");
    ImGui::End();
}

} // namespace

void Graph::draw(const char* name, const char* unit) const {
    const std::string label = message(name, ": ");
    ImGui::Text("%s%.4g %s", label.c_str(), static_cast<double>(last()), unit);
    ImGui::PushID(name);
    ImGui::SetNextItemWidth(-1.0f);
    ImGui::PlotLines("##graph", values_.data(), static_cast<int>(values_.size()), static_cast<int>(next_), nullptr, 0.0f, FLT_MAX,
                     {0.0f, 20.0f});
    ImGui::PopID();
}

void draw_panels(Desk& desk) {
    const ImVec2 whole = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.0f, 0.0f});
    ImGui::SetNextWindowSize({k_left, whole.y});
    ImGui::SetNextWindowBgAlpha(0.8f);
    ImGui::Begin("Scene", nullptr, ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse);
    play_controls(desk);
    ImGui::Separator();
    wind_controls(desk);
    red(desk.fault);
    hand_controls(desk);
    solver_controls(desk);
    list_things(desk);
    edit_chosen(desk);
    air_settings(desk);
    view_controls(desk);
    file_controls(desk);
    ImGui::End();
    draw_figures(desk);
}

} // namespace windrow::vegetation::view
