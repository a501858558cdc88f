#include "vegetation/view/desk.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

namespace windrow::vegetation::view {
namespace {

double held_down(int key) {
    return ImGui::IsKeyDown(key) ? 1.0 : 0.0;
}

/// A stick that does not rest in its middle is still.
double stick(float value) {
    return std::abs(value) > 0.15f ? static_cast<double>(value) : 0.0;
}

void use_gamepad(Desk& desk, double seconds) {
    GLFWgamepadstate pad;
    if (glfwJoystickIsGamepad(GLFW_JOYSTICK_1) == GLFW_FALSE || glfwGetGamepadState(GLFW_JOYSTICK_1, &pad) == GLFW_FALSE)
        return;
    const double speed = 8.0 * seconds;
    desk.eye.turn(1.5 * seconds * stick(pad.axes[GLFW_GAMEPAD_AXIS_RIGHT_X]),
                  1.5 * seconds * stick(pad.axes[GLFW_GAMEPAD_AXIS_RIGHT_Y]));
    desk.eye.fly({speed * stick(pad.axes[GLFW_GAMEPAD_AXIS_LEFT_X]), 0.0, -speed * stick(pad.axes[GLFW_GAMEPAD_AXIS_LEFT_Y])});
}

} // namespace

void use_keys(Desk& desk, double seconds) {
    use_gamepad(desk, seconds);
    const ImGuiIO& io = ImGui::GetIO();
    const std::vector<int> keys = std::exchange(desk.keys, {});
    if (io.WantTextInput)
        return;
    const auto pressed = [&](int key) { return std::find(keys.begin(), keys.end(), key) != keys.end(); };
    if (pressed(GLFW_KEY_ESCAPE))
        desk.closes = true;
    if (pressed(GLFW_KEY_SPACE)) {
        desk.playing = !desk.playing;
        desk.tell(desk.playing ? "plays" : "pauses");
    }
    if (pressed(GLFW_KEY_PERIOD)) {
        desk.playing = false;
        if (desk.done(desk.session.step()))
            desk.tell("made a step");
    }
    if (pressed(GLFW_KEY_COMMA)) { // back by a second
        desk.playing = false;
        if (desk.done(desk.session.seek(std::max(desk.session.time() - 1.0, desk.session.earliest()))))
            desk.tell("went back");
    }
    if (pressed(GLFW_KEY_LEFT_BRACKET))
        desk.rate = std::max(0.25, 0.5 * desk.rate);
    if (pressed(GLFW_KEY_RIGHT_BRACKET))
        desk.rate = std::min(4.0, 2.0 * desk.rate);
    const glm::dvec3 target = desk.eye.target();
    const glm::dvec3 foot(target.x, desk.ground(target.x, target.z), target.z);
    if (pressed(GLFW_KEY_H))
        desk.add_house(foot);
    if (pressed(GLFW_KEY_N))
        desk.add_fan(foot);
    if (pressed(GLFW_KEY_G)) {
        desk.take(desk.tool == Tool::gust ? Tool::choose : Tool::gust);
    }
    for (int n = 0; n < k_tools; ++n)
        if (pressed(GLFW_KEY_1 + n))
            desk.take(static_cast<Tool>(n));
    if (pressed(GLFW_KEY_B))
        desk.set_solver(desk.session.solver() == program::Backend::cpu ? program::Backend::vulkan : program::Backend::cpu);
    if (pressed(GLFW_KEY_C))
        desk.compare();
    if (pressed(GLFW_KEY_X))
        desk.cut(static_cast<SliceOf>((static_cast<int>(desk.slice_of) + 1) % k_slices));
    if (pressed(GLFW_KEY_V))
        desk.save_vdb();
    if (pressed(GLFW_KEY_K))
        desk.save_cpp();
    if (pressed(GLFW_KEY_L))
        desk.save_log();
    if (pressed(GLFW_KEY_DELETE))
        desk.remove_chosen();
    if (pressed(GLFW_KEY_S + k_control)) {
        if (desk.done(desk.session.save(desk.scene_file)))
            desk.tell("saved " + desk.scene_file);
        return;
    }
    if (pressed(GLFW_KEY_F))
        desk.save_field();
    if (pressed(GLFW_KEY_P))
        desk.wants_picture = true;
    if (pressed(GLFW_KEY_F5) && desk.done(desk.session.restart()))
        desk.tell("restarted");
    if (pressed(GLFW_KEY_F1))
        desk.panel = !desk.panel;
    if (pressed(GLFW_KEY_F2))
        desk.tell("handles" + handles_text(desk));
    const double speed = (io.KeyShift ? 40.0 : 8.0) * seconds;
    desk.eye.fly({speed * (held_down(GLFW_KEY_D) - held_down(GLFW_KEY_A)),
                  speed * (held_down(GLFW_KEY_E) - held_down(GLFW_KEY_Q)),
                  speed * (held_down(GLFW_KEY_W) - (io.KeyCtrl ? 0.0 : held_down(GLFW_KEY_S)))});
}

} // namespace windrow::vegetation::view
