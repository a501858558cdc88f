#include "fluid/core/message.h"
#include "vegetation/view/controls.h"
#include "vegetation/view/desk.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <imgui_stdlib.h>
#include <numbers>
#include <system_error>

namespace windrow::vegetation::view {
namespace {

using detail::message;

constexpr float k_left = 330.0f, k_right = 250.0f; // [px] width of the panels

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
    ImGui::SameLine();
    bool gust = desk.tool == Tool::gust;
    if (ImGui::Checkbox("Slide gusts", &gust))
        desk.tool = gust ? Tool::gust : Tool::choose;
    controls::explain("Pull the pointer over the ground: a push of air along that way, as fast as it is long.");
    const auto row = [&](Choice choice, const std::string& name, const char* kind) {
        ImGui::PushID(static_cast<int>(2 * choice.place + (choice.kind == Choice::Kind::motor ? 1 : 0)));
        if (ImGui::Selectable((name + "  (" + kind + ")").c_str(), desk.chosen == choice))
            desk.chosen = choice;
        ImGui::PopID();
    };
    ImGui::BeginChild("things", {0.0f, 110.0f}, true);
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
    line("Log", desk.log_folder, [&] {
        std::error_code error;
        std::filesystem::create_directories(desk.log_folder, error);
        if (desk.done(desk.session.save_log(desk.log_folder)))
            desk.tell("wrote the log " + desk.log_folder);
    });
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
    ImGui::PushItemWidth(150.0f);
    (void)edit(desk.overlay);
    ImGui::PopItemWidth();
}

void draw_figures(Desk& desk) {
    const ImVec2 whole = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({whole.x - k_right, 0.0f});
    ImGui::SetNextWindowSize({k_right, std::min(whole.y, 400.0f)});
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
    const Diagnostics last = desk.session.reader().diagnostics();
    ImGui::Text("%d motors in reach%s", last.motors_in_reach, last.asleep ? ", asleep" : "");
    ImGui::End();
}

} // namespace

void Graph::draw(const char* name, const char* unit) const {
    const std::string label = message(name, ": ");
    ImGui::Text("%s%.4g %s", label.c_str(), static_cast<double>(last()), unit);
    ImGui::PushID(name);
    ImGui::SetNextItemWidth(-1.0f);
    ImGui::PlotLines("##graph", values_.data(), static_cast<int>(values_.size()), static_cast<int>(next_), nullptr, 0.0f, FLT_MAX,
                     {0.0f, 26.0f});
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
    list_things(desk);
    edit_chosen(desk);
    air_settings(desk);
    view_controls(desk);
    file_controls(desk);
    ImGui::End();
    draw_figures(desk);
}

} // namespace windrow::vegetation::view
