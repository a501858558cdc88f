// Tutorial: trees in the wind, drawn by the renderer of this repository.
//
//     draw_trees [KIND [WIND [FRAMES]]]    KIND oak, birch, spruce, bush: that one alone; all (default): groves
//                                          WIND [m/s] at 10 m, 0 to 40 (default 6); FRAMES of 1/30 s (default 1), in folder trees
// 1. A kind of tree is a struct (vegetation/trees/tree_settings.h); presets give some by name, and a host may change any field.
// 2. A stand draws one kind at many places, which a host gives or has scattered over its ground.
// 3. Each frame: the wind, then the renderer (examples/draw_grass.cpp has its steps). The stand bends trunk, limbs and twigs by
// the wind at each of them, and lets them swing.

#include "examples/held.h"
#include "vegetation/render/renderer.h"
#include "vegetation/trees/tree_stand.h"

#include <charconv>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vulkan/vulkan.h>

using namespace windrow::vegetation;

namespace {

constexpr double k_frame = 1.0 / 30.0;              // [s]
constexpr glm::dvec3 k_field{4.0e5, 120.0, -2.5e5}; // [m] far from the world's origin
constexpr const char* k_usage =
    "usage: draw_trees [KIND [WIND [FRAMES]]], KIND oak, birch, spruce, bush or all, WIND 0 to 40 m/s, FRAMES 1 to 9999";

template <class T>
T number(int count, char** arguments, int which, T otherwise) {
    const std::string text = count > which ? arguments[which] : "";
    const auto read = std::from_chars(text.data(), text.data() + text.size(), otherwise);
    if (count > which && (read.ec != std::errc{} || read.ptr != text.data() + text.size()))
        give_up(k_usage);
    return otherwise;
}

// One tree before the eye, or groves of all kinds.
std::vector<trees::TreeStandSettings> stands_of(const std::string& kind) {
    const auto at = [](double x, double z) { return k_field + glm::dvec3(x, 0.0, z); };
    if (kind != "all")
        return {{.kind = held(trees::preset(kind)), .variants = 1, .places = {{.base = at(0.0, -10.0)}}}};
    struct Grove {
        const char* kind;
        int count;
        windrow::TreePlace near;
    };
    std::vector<trees::TreeStandSettings> stands;
    std::uint32_t seed = 3;
    for (const Grove& grove : {Grove{"oak", 90, {at(-13.0, -34.0), 1.05f, 20.0f}}, Grove{"birch", 70, {at(6.5, -31.0)}},
                               Grove{"spruce", 140, {at(27.0, -75.0)}}, Grove{"bush", 60, {at(-6.0, -21.0)}}})
        stands.push_back({.kind = held(trees::preset(grove.kind)),
                          .places = {grove.near},
                          .scatter = {.count = grove.count,
                                      .low = {k_field.x - 260.0, k_field.z - 420.0},
                                      .high = {k_field.x + 260.0, k_field.z - 40.0},
                                      .apart = 5.0,
                                      .seed = seed++,
                                      .clear = {{{k_field.x, k_field.z - 60.0}, 50.0}}}});
    return stands;
}

render::Scene scene_of(float speed) {
    render::Scene scene;
    scene.ground.corner = k_field - glm::dvec3(400.0, 0.0, 700.0);
    scene.ground.heights = held(windrow::HeightMap::create({161, 161}, 5.0f, [](glm::vec2) { return 0.0f; }));
    scene.camera.position = k_field + glm::dvec3(0.0, 2.2, 0.0);
    scene.camera.target = k_field + glm::dvec3(0.0, 4.2, -40.0);
    scene.look.even_from = 1.0f; // no grass is drawn here: the ground has its colour
    windrow::Config& wind = scene.wind.wind;
    wind.cells = {32, 12, 32};
    wind.cell_size = 1.5f;
    wind.boundaries = windrow::Boundaries::open_over_floor();
    wind.centre = k_field + glm::dvec3(0.0, 9.0, -24.0);
    wind.ambient = {0.93f * speed, 0.0f, -0.37f * speed};
    wind.gusts = {.intensity = speed > 0.0f ? 0.35f : 0.0f, .length = 18.0f};
    return scene;
}

} // namespace

int main(int argument_count, char** arguments) {
    const std::string kind = argument_count > 1 ? arguments[1] : "all";
    const auto speed = number(argument_count, arguments, 2, 6.0f);
    const int frames_wanted = number(argument_count, arguments, 3, 1);
    if (argument_count > 4 || !(speed >= 0.0f && speed <= 40.0f) || frames_wanted < 1 || frames_wanted > 9999)
        give_up(k_usage);
    std::error_code ignored; // write_ppm reports a folder that cannot be made
    std::filesystem::create_directories("trees", ignored);
    render::Scene scene = scene_of(speed);
    const auto stands = stands_of(kind);
    if (kind != "all") {
        const double tall = static_cast<double>(stands.front().kind.tree.height);
        scene.camera.target = stands.front().places.front().base + glm::dvec3(0.0, 0.5 * tall, 0.0);
        scene.camera.position = scene.camera.target + glm::dvec3(0.3 * tall, -0.3 * tall, 1.95 * tall);
    }
    const auto device = held(engine::Device::create(), 3);
    auto wind =
        held(windrow::vulkan::Wind::create(device->host(), scene.wind.wind, {.frames_in_flight = engine::k_frames_in_flight}), 3);
    held(wind.set_floor(k_field.y));

    const render::RenderSettings picture{
        .width = 960, .height = 540, .shadow_texels = 2048, .near_shadow = 50.0f, .far_shadow = 190.0f, .anchor = k_field};
    const auto renderer = held(render::Renderer::create(*device, scene, picture));
    std::vector<std::unique_ptr<trees::TreeStand>> drawn;
    for (const trees::TreeStandSettings& stand : stands) {
        const auto places = held(trees::places_of(stand, [&](double x, double z) { return scene.ground.height(x, z); }));
        drawn.push_back(held(trees::TreeStand::create(*device, renderer->draw_targets(), stand, places, k_field)));
        drawn.back()->set_time_step(k_frame);
        renderer->add(*drawn.back());
    }

    const auto frames = held(engine::Frames::create(*device), 3);
    for (int n = -59; n <= frames_wanted; ++n) { // two seconds of wind before the first picture
        const engine::Frame frame = held(frames->begin());
        renderer->begin(frame);
        held(wind.record(frame.commands, {.dt = k_frame, .slot = frame.slot}));
        if (n >= 1) {
            held(renderer->record(frame, scene.camera, wind));
            renderer->copy(frame);
        }
        held(frames->submit(frame));
        if (n >= 1) {
            held(frames->wait());
            char name[32];
            std::snprintf(name, sizeof name, "trees/frame_%04d.ppm", n);
            held(render::write_ppm(renderer->images().picture(), name));
        }
    }
    unsigned long long vertices = 0;
    for (const auto& stand : drawn)
        vertices += stand->drawn_vertices();
    std::printf("%s: %d frames in trees, %llu vertices in the last one\n", device->name().c_str(), frames_wanted, vertices);
}
