// Tutorial: grass in the wind, drawn by the renderer of this repository.
//
//     draw_grass [FRAMES [FOLDER]]     draws so many frames of 1/30 s (default 6) into FOLDER (grass): frame_0001.ppm ...
//
// 1. Say what the picture is of: a Scene has the eye, the sun, the fog, the ground, the plants and their look, the wind.
// 2. Make the engine's device, lend it to the wind (examples/embed_vulkan.cpp says more), and give it to the renderer.
// 3. Add what is to be drawn: here a layer of grass on all of the ground. Whatever derives from render::Drawable will do.
// 4. In each frame record the wind, then the renderer: shadows, light, motion since the last frame, the toned picture.

#include "examples/held.h"
#include "vegetation/render/grass_layer.h"
#include "vegetation/render/renderer.h"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string_view>
#include <vulkan/vulkan.h>

using namespace windrow::vegetation;

namespace {

constexpr double k_frame = 1.0 / 30.0;              // [s]
constexpr double k_settle = 2.0;                    // [s] of wind before the first picture
constexpr glm::dvec3 k_field{4.0e5, 120.0, -2.5e5}; // [m] the eye's place, far from the world's origin

// Soft hills, 400 m across, with a dip where the eye stands: sums of cosines, ours.
render::Ground hills() {
    auto heights = windrow::HeightMap::create({161, 161}, 2.5f, [](glm::vec2 place) {
        const double x = static_cast<double>(place.x) - 200.0, z = static_cast<double>(place.y) - 320.0; // from the eye
        const double hill = 5.0 * (1.0 - std::cos(0.021 * z + 0.004 * x)) + 2.2 * std::sin(0.035 * x + 0.6) * std::sin(0.028 * z);
        const double far = 1.0 - std::exp(-(x * x + z * z) / (40.0 * 40.0));
        return static_cast<float>(hill * far + 0.12 * std::sin(0.4 * x) * std::sin(0.37 * z));
    });
    return {.corner = k_field - glm::dvec3(200.0, 0.0, 320.0), .heights = held(std::move(heights))};
}

// Blades, 14 along a metre of each axis: longer than a meadow's, with its stiffness. They are fewer and wider from 3 m on, have
// half of their vertices from 9 m on, and end at 45 m, where the ground has their colour.
grass::GrassSettings meadow() {
    grass::GrassSettings field{
        .density = 14.0f, .split_distance = 9.0f, .cut_distance = 45.0f, .thin_from = 3.0f, .thin_power = 1.45f};
    field.blade = {.stalk = {.length = 0.36f}, .width = 0.012f, .rest_bend = 0.6f, .rest_bend_spread = 0.35f, .view_bend = 0.3f};
    return field;
}

render::Scene grassland() {
    render::Scene scene;
    scene.ground = hills();
    scene.camera.position = k_field + glm::dvec3(0.0, 1.25, 0.0);
    scene.camera.target = scene.camera.position + glm::dvec3(0.0, -0.85, -10.0);
    scene.camera.exposure = 0.72f;
    scene.fog.base = k_field.y;
    scene.plants = meadow().blade; // what the ground far away looks like
    windrow::Config& wind = scene.wind.wind;
    wind.cells = {48, 12, 48};
    wind.cell_size = 0.5f;
    wind.boundaries = windrow::Boundaries::open_over_floor();
    wind.centre = k_field + glm::dvec3(0.0, 3.0, -8.0);
    wind.ambient = {2.8f, 0.0f, -1.1f};
    wind.profile = windrow::LogProfile{};
    wind.gusts = {.intensity = 0.4f, .length = 12.0f};
    scene.wind.motors.push_back(windrow::JetMotor{.position = k_field + glm::dvec3(4.0, 0.6, -9.0),
                                                  .direction = {-0.95f, -0.12f, 0.2f},
                                                  .length = 6.0f,
                                                  .start_radius = 0.8f,
                                                  .end_radius = 1.6f,
                                                  .law = windrow::Drive{.speed = 9.0f, .rate = 8.0f}});
    scene.wind.sampling = {.detail = 0.6f, .detail_length = 0.5f};
    return scene;
}

} // namespace

int main(int argument_count, char** arguments) {
    int frames_wanted = 6;
    const std::filesystem::path folder = argument_count > 2 ? arguments[2] : "grass";
    if (argument_count > 1) {
        const std::string_view text = arguments[1];
        const auto read = std::from_chars(text.data(), text.data() + text.size(), frames_wanted);
        if (read.ec != std::errc{} || read.ptr != text.data() + text.size() || frames_wanted < 1 || frames_wanted > 9999 ||
            argument_count > 3)
            give_up("usage: draw_grass [FRAMES [FOLDER]], FRAMES from 1 to 9999");
    }
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
        give_up(folder.string() + " cannot be made (" + error.message() + "); name a folder that you may write to.");

    const render::Scene scene = grassland();
    const auto device = held(engine::Device::create(), 3);
    auto wind =
        held(windrow::vulkan::Wind::create(device->host(), scene.wind.wind, {.frames_in_flight = engine::k_frames_in_flight}), 3);
    held(wind.set_floor(k_field.y));
    for (const windrow::Motor& motor : scene.wind.motors)
        (void)held(wind.motors().add(motor));

    const auto renderer = held(render::Renderer::create(*device, scene, {.width = 640, .height = 360, .anchor = k_field}));
    const auto everywhere = held(grass::PlacementMask::create({2, 2}, scene.ground.heights.extent(), 1.0f));
    const auto layer = held(render::GrassLayer::create(*device, renderer->draw_targets(), scene.ground, everywhere,
                                                       {.field = meadow(), .look = scene.look}));
    layer->set_time_step(k_frame); // its blades swing
    renderer->add(*layer);

    const auto frames = held(engine::Frames::create(*device), 3);
    for (double time = 0.0; time < k_settle; time += k_frame) { // gusts reach the box's middle
        const engine::Frame frame = held(frames->begin(), 1);
        (void)held(wind.record(frame.commands, {.dt = k_frame, .slot = frame.slot}), 1);
        held(frames->submit(frame));
    }
    for (int n = 1; n <= frames_wanted; ++n) {
        const engine::Frame frame = held(frames->begin(), 1);
        renderer->begin(frame);
        (void)held(wind.record(frame.commands, {.dt = k_frame, .slot = frame.slot}), 1);
        render::Camera camera = scene.camera;
        camera.position.x += 0.25 * k_frame * n; // a slow step aside
        held(renderer->record(frame, camera, wind));
        renderer->copy(frame);
        held(frames->finish(frame));
        renderer->clock().collect(frame.slot);
        char name[32];
        std::snprintf(name, sizeof name, "frame_%04d.ppm", n);
        held(render::write_ppm(renderer->images().picture(), folder / name));
    }

    std::printf("%s: %d frames of 640 x 360 px, %d chunks of grass, %.1f MiB beside the wind's %.1f MiB, in %s\n",
                device->name().c_str(), frames_wanted, layer->report().colour_chunks,
                static_cast<double>(device->memory_bytes()) / 1048576.0, static_cast<double>(wind.memory_bytes()) / 1048576.0,
                folder.string().c_str());
    for (const render::StageTime& stage : renderer->clock().times())
        std::printf("%-8s %10.0f us\n", stage.name, stage.us);
    return 0;
}
