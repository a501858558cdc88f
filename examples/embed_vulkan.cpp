// Tutorial: the wind on the GPU, inside an engine's own renderer. A walker crosses a meadow, a fan blows over it.
//
//     embed_vulkan [FRAMES [FILE]]     draws so many frames of 1/60 s (default 150), and the last to FILE (embed_vulkan.ppm)
//
// 1. Make your device as you always do. `requirements` says what to ask for, `check` whether a physical device has it: one
//    feature of Vulkan 1.0, no extension. The engine in small lies in examples/engine: device, frames in flight, picture.
// 2. Lend the device. The wind makes buffers, images and pipelines on it; it never submits and never waits.
// 3. In each frame tell the wind where things are, and record it before what samples it, outside of a render pass. The slot says
//    which frame in flight this is: what was recorded for it before is done, and its answer is read now.
// 4. Draw. A shader that includes shaders/coupling/windrow_wind.glsl calls windrow_velocity(p)
//    (examples/shaders/grass.vert). It needs one descriptor set (vegetation/vulkan/wind_set.cpp), and no barrier: the recording
//    has ended with one.
// 5. Ask on the CPU too: velocity() answers from what was read back, as old as the frames in flight and up to a tick more.
//
// What to see: grass leans with gusts that run over the field as pale waves; behind the walker it is drawn along; before the fan
// it lies flat. All of it far from the world's origin, in float shaders: positions are relative to an anchor near the camera.

#include "vegetation/vulkan/frames.h"
#include "examples/engine/meadow.h"
#include "examples/engine/target.h"
#include "vegetation/vulkan/wind_set.h"
#include "fluid/vulkan/wind.h"

#include <charconv>
#include <cstdio>
#include <cstring>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <vulkan/vulkan.h>

using namespace windrow::vegetation;

namespace {

constexpr double k_frame = 1.0 / 60.0;            // [s]
constexpr glm::dvec3 k_field{4.0e5, 0.0, -2.5e5}; // [m] the middle of the meadow, in the world
constexpr float k_blades = 40000.0f;              // of grass
constexpr glm::dvec3 k_walk{4.0, 0.0, 0.0};       // [m/s] the walker's velocity
constexpr glm::dvec3 k_fan_hub{6.3, 1.25, -6.0};  // [m] from the middle of the meadow
constexpr glm::vec3 k_fan_axis{-0.98f, -0.12f, 0.16f};
constexpr glm::dvec3 k_eye{0.0, 2.3, 9.0}; // [m] from the middle of the meadow

// His feet, and the middle of his body.
glm::dvec3 walker_at(double time) {
    return k_field + glm::dvec3(-9.0, 0.0, 0.0) + time * k_walk;
}
glm::dvec3 body_at(double time) {
    return walker_at(time) + glm::dvec3(0.0, 0.8, 0.0);
}

// Vulkan's clip space has y down and depth from 0 to 1.
glm::mat4 view_projection(VkExtent2D extent) {
    const float aspect = static_cast<float>(extent.width) / static_cast<float>(extent.height);
    glm::mat4 projection = glm::perspectiveRH_ZO(glm::radians(44.0f), aspect, 0.5f, 160.0f);
    projection[1][1] = -projection[1][1];
    const glm::vec3 eye(k_eye);
    return projection * glm::lookAtRH(eye, eye + glm::vec3(0.0f, -0.19f, -1.0f), glm::vec3(0.0f, 1.0f, 0.0f));
}

engine::Scene scene_at(double time, VkExtent2D extent) {
    return {.view_projection = view_projection(extent),
            .eye = glm::vec4(glm::vec3(k_eye), k_blades),
            .walker = glm::vec4(glm::vec3(walker_at(time) - k_field), 0.0f),
            .fan = glm::vec4(glm::vec3(k_fan_hub), static_cast<float>(9.0 * time)),
            .fan_axis = glm::vec4(glm::normalize(k_fan_axis), 0.9f)};
}

} // namespace

int main(int argument_count, char** arguments) {
    int frames_wanted = 150;
    const char* const file = argument_count > 2 ? arguments[2] : "embed_vulkan.ppm";
    if (argument_count > 1) {
        const char* const end = arguments[1] + std::strlen(arguments[1]);
        const auto read = std::from_chars(arguments[1], end, frames_wanted);
        if (read.ec != std::errc{} || read.ptr != end || frames_wanted < 3 || argument_count > 3)
            engine::give_up(
                "usage: embed_vulkan [FRAMES [FILE]], FRAMES from 3: the wind that is told at the end was read back by then", 2);
    }

    // 1. The engine's device.
    const windrow::vulkan::Requirements needs = windrow::vulkan::requirements();
    engine::Device device(needs.api_version, needs.features, [](VkInstance instance, VkPhysicalDevice candidate) {
        const auto fit = windrow::vulkan::check(instance, candidate, vkGetInstanceProcAddr);
        return fit ? std::string() : fit.error();
    });
    const engine::Target target(device, {1280, 720});

    // 2. The wind on it: half a metre a cell around the walker, gusts over open ground.
    const windrow::vulkan::Host host{.instance = device.instance,
                                     .physical_device = device.physical,
                                     .device = device.device,
                                     .queue_family = device.family,
                                     .get_instance_proc_addr = vkGetInstanceProcAddr};
    auto wind = windrow::vulkan::Wind::create(host,
                                              {.cells = {48, 12, 48},
                                               .cell_size = 0.5f,
                                               .sides = windrow::Sides::open_over_floor(),
                                               .centre = walker_at(0.0) + glm::dvec3(0.0, 3.0, 0.0),
                                               .ambient = {-0.8f, 0.0f, 3.0f},
                                               .profile = windrow::LogProfile{},
                                               .gusts = {.intensity = 0.35f, .length = 10.0f}},
                                              {.frames_in_flight = engine::k_frames_in_flight});
    if (!wind)
        engine::give_up(wind.error(), 3); // says what is wrong, and the fix
    const auto walker = wind->motors().add(
        windrow::WakeMotor{.position = body_at(0.0), .radius = 0.9f, .law = windrow::WakeDrive{.per_metre = 20.0f}});
    const auto fan = wind->motors().add(windrow::JetMotor{.position = k_field + k_fan_hub,
                                                          .direction = k_fan_axis,
                                                          .length = 7.0f,
                                                          .start_radius = 0.9f,
                                                          .end_radius = 1.6f,
                                                          .law = windrow::Drive{.speed = 12.0f, .rate = 8.0f}});
    if (!walker || !fan)
        engine::give_up(walker ? fan.error() : walker.error(), 2);

    engine::WindSet wind_set(device);
    const engine::Meadow meadow(device, target.render_pass(), wind_set.layout());
    engine::Frames frames(device);
    int dispatches = 0;
    for (int n = 1; n <= frames_wanted; ++n) {
        const engine::Frame frame = frames.begin();
        const double time = n * k_frame;

        // 3. The wind of this frame.
        (void)wind->motors().move(*walker, body_at(time));
        (void)wind->follow(walker_at(time));
        (void)wind->record(frame.commands, {.dt = k_frame, .slot = frame.slot});
        dispatches += wind->dispatches();

        // 4. What samples it. Ripples of half a metre are finer than the cells: windrow_apparent adds them.
        const VkDescriptorSet set = wind_set.of(frame.slot, *wind, k_field, {.detail = 0.6f, .detail_length = 0.5f});
        target.begin(frame.commands);
        meadow.draw(frame.commands, scene_at(time, target.extent()), set);
        target.end(frame.commands);
        if (n == frames_wanted)
            target.copy(frame.commands);
        frames.submit(frame);
    }
    frames.wait();
    if (!target.write_ppm(file))
        engine::give_up(std::string(file) + " cannot be written: name a file in a folder that you may write to.", 2);

    // 5. What the CPU knows.
    const glm::vec3 felt = wind->velocity(body_at(frames_wanted * k_frame));
    std::printf("%s: %d frames, %.1f dispatches a frame, wind at the walker (%.2f, %.2f, %.2f) m/s as of %.0f ms ago, %s\n",
                device.name.c_str(), frames_wanted, static_cast<double>(dispatches) / frames_wanted, static_cast<double>(felt.x),
                static_cast<double>(felt.y), static_cast<double>(felt.z), 1e3 * wind->query_age(), file);
    return 0;
}
