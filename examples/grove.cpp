// Tutorial: trees in the wind, drawn by the small renderer of vegetation/render.
//
//     grove [KIND [WIND [FRAMES [FOLDER]]]]    KIND oak, birch, spruce, bush: that one alone; all (default): groves on hills
//                                              WIND [m/s] at 10 m, 0 to 40 (default 6); so many frames of 1/30 s (default 1) into
//                                              FOLDER
//
// 1. A kind of tree is a struct (vegetation/trees/tree_settings.h); presets give some by name, and a host may change any field.
// 2. A stand draws one kind at many places, which a host gives or has scattered over its ground.
// 3. Each frame: the wind, then the renderer. The stand bends trunk, limbs and twigs by the wind at each of them, and lets them
// swing.

#include "coupling/plant_classes.h"
#include "vegetation/render/blades.h"
#include "vegetation/render/renderer.h"
#include "vegetation/trees/tree_stand.h"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>
#include <vulkan/vulkan.h>

using namespace windrow::vegetation;

namespace {

[[noreturn]] void give_up(const std::string& sentence, int code) {
    std::fprintf(stderr, "%s\n", sentence.c_str());
    std::exit(code);
}

constexpr double k_frame = 1.0 / 30.0;              // [s]
constexpr glm::dvec3 k_field{4.0e5, 120.0, -2.5e5}; // [m]

// The hills of small_meadow, wider: what lies far off are groves.
render::Ground hills() {
    auto heights = grass::HeightMap::create({161, 161}, 5.0f, [](glm::vec2 place) {
        const double x = static_cast<double>(place.x) - 400.0, z = static_cast<double>(place.y) - 700.0; // from the eye
        const double hill = 5.0 * (1.0 - std::cos(0.021 * z + 0.004 * x)) + 2.2 * std::sin(0.035 * x + 0.6) * std::sin(0.028 * z);
        const double far = 1.0 - std::exp(-(x * x + z * z) / (40.0 * 40.0));
        return static_cast<float>(hill * far + 8.0 * std::pow(std::hypot(x, z) / 300.0, 2.0));
    });
    if (!heights)
        give_up(heights.error(), 2);
    return {.corner = k_field - glm::dvec3(400.0, 0.0, 700.0), .heights = *std::move(heights)};
}

template <class T>
T held(windrow::Result<T> result, int code) {
    if (!result)
        give_up(result.error(), code);
    return *std::move(result);
}

void check(const windrow::Result<void>& result) {
    if (!result)
        give_up(result.error(), 2);
}

template <class T>
T number(int count, char** arguments, int which, T otherwise) {
    if (count <= which)
        return otherwise;
    T value = otherwise;
    const char* const end = arguments[which] + std::strlen(arguments[which]);
    const auto read = std::from_chars(arguments[which], end, value);
    if (read.ec != std::errc{} || read.ptr != end)
        give_up("usage: grove [KIND [WIND [FRAMES [FOLDER]]]], KIND oak, birch, spruce, bush or all, WIND in m/s", 2);
    return value;
}

// One tree before the eye, or groves of all kinds.
std::vector<trees::TreeStandSettings> stands_of(const std::string& kind, const render::Ground& ground) {
    std::vector<trees::TreeStandSettings> stands;
    const auto at = [&](double x, double z) {
        return glm::dvec3(k_field.x + x, ground.height(k_field.x + x, k_field.z + z), k_field.z + z);
    };
    if (kind != "all") {
        stands.push_back({.kind = held(trees::preset(kind), 2), .variants = 1, .places = {{.base = at(0.0, -10.0)}}});
        return stands;
    }
    struct Share {
        const char* kind;
        int count;
        std::vector<trees::TreePlace> places;
    };
    const Share shares[] = {
        {"oak", 90, {{at(-13.0, -34.0), 1.05f, 20.0f}, {at(21.0, -62.0), 1.15f, 200.0f}}},
        {"birch", 70, {{at(6.5, -31.0), 0.95f, 0.0f}, {at(10.5, -37.0), 1.1f, 80.0f}, {at(8.0, -41.0), 0.85f, 150.0f}}},
        {"spruce", 140, {{at(27.0, -75.0), 1.1f, 0.0f}, {at(33.0, -80.0), 0.9f, 90.0f}}},
        {"bush", 60, {{at(-6.0, -21.0), 1.0f, 0.0f}, {at(14.0, -28.0), 0.8f, 60.0f}}}};
    std::uint32_t seed = 3;
    for (const Share& share : shares)
        stands.push_back({.kind = held(trees::preset(share.kind), 2),
                          .places = share.places,
                          .scatter = {.count = share.count,
                                      .low = {k_field.x - 260.0, k_field.z - 420.0},
                                      .high = {k_field.x + 260.0, k_field.z - 40.0},
                                      .apart = 5.0,
                                      .groves = 0.9f,
                                      .seed = seed++,
                                      .clear = {{{k_field.x, k_field.z - 60.0}, 50.0}}}});
    return stands;
}

} // namespace

int main(int argument_count, char** arguments) {
    const std::string kind = argument_count > 1 ? arguments[1] : "all";
    const auto speed = number(argument_count, arguments, 2, 6.0f);
    const int frames_wanted = number(argument_count, arguments, 3, 1);
    const std::filesystem::path folder = argument_count > 4 ? arguments[4] : "grove";
    if (argument_count > 5 || !(speed >= 0.0f && speed <= 40.0f) || frames_wanted < 1 || frames_wanted > 9999)
        give_up("usage: grove [KIND [WIND [FRAMES [FOLDER]]]], WIND from 0 to 40 m/s, FRAMES from 1 to 9999", 2);
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
        give_up(folder.string() + " cannot be made (" + error.message() + "); name a folder that you may write to.", 2);

    render::Scene scene;
    scene.ground = hills();
    const bool alone = kind != "all";
    const auto stands = stands_of(kind, scene.ground);
    const double tall = static_cast<double>(stands.front().kind.tree.height);
    scene.camera.position = alone ? stands.front().places.front().base + glm::dvec3(0.3 * tall, 0.2 * tall, 1.95 * tall)
                                  : k_field + glm::dvec3(0.0, 2.2, 0.0);
    scene.camera.target =
        alone ? stands.front().places.front().base + glm::dvec3(0.0, 0.5 * tall, 0.0) : k_field + glm::dvec3(0.0, 4.2, -40.0);
    scene.camera.exposure = 0.85f;
    scene.sun = {.elevation_deg = 34.0f, .azimuth_deg = 152.0f};
    scene.fog.base = k_field.y;
    scene.look.even_from = 20.0f;
    scene.clouds = {.cover = 0.35f, .height = k_field.y + 900.0};
    scene.plants = {.stalk = windrow::grass(), .width = 0.012f, .own_bend = 0.6f, .own_bend_spread = 0.35f, .view_bend = 0.3f};
    scene.plants.stalk.length = 0.36f;
    windrow::Config& wind_config = scene.wind.wind;
    wind_config.cells = {32, 12, 32};
    wind_config.cell_size = 1.5f;
    wind_config.sides = windrow::Sides::open_over_floor();
    wind_config.centre = k_field + glm::dvec3(0.0, 9.0, -24.0);
    wind_config.ambient = {0.93f * speed, 0.0f, -0.37f * speed};
    wind_config.profile = windrow::LogProfile{};
    wind_config.gusts = {.intensity = speed > 0.0f ? 0.35f : 0.0f, .length = 18.0f};

    const auto device = held(engine::Device::create(), 3);
    auto wind =
        held(windrow::vulkan::Wind::create(device->host(), wind_config, {.frames_in_flight = engine::k_frames_in_flight}), 3);
    check(wind.set_floor(k_field.y));
    const auto renderer = held(render::Renderer::create(*device, scene,
                                                        {.width = 960,
                                                         .height = 540,
                                                         .shadow_texels = 2048,
                                                         .near_shadow = alone ? static_cast<float>(3.0 * tall) : 50.0f,
                                                         .far_shadow = 190.0f,
                                                         .anchor = k_field}),
                               2);
    std::vector<std::unique_ptr<trees::TreeStand>> drawn;
    std::size_t trees = 0;
    const auto ground = [&](double x, double z) { return scene.ground.height(x, z); };
    for (const trees::TreeStandSettings& stand : stands) {
        const auto places = held(trees::places_of(stand, ground), 2);
        drawn.push_back(held(trees::TreeStand::create(*device, renderer->draw_targets(), stand, places, k_field), 2));
        drawn.back()->set_time_step(k_frame);
        renderer->add(*drawn.back());
        trees += places.size();
    }

    const auto blades = held(
        render::scatter({.eye = scene.camera.position, .target = scene.camera.target, .near = 1.5f, .far = 55.0f, .count = 26000},
                        scene.ground, k_field),
        2);
    const auto grass = held(render::BladeGrid::create(*device, renderer->draw_targets(), scene.plants, scene.look, blades), 2);
    renderer->add(*grass);

    const auto frames = held(engine::Frames::create(*device), 3);
    for (double time = 0.0; time < 2.0; time += k_frame) { // gusts reach the box's middle
        const engine::Frame frame = held(frames->begin(), 1);
        (void)wind.record(frame.commands, {.dt = k_frame, .slot = frame.slot});
        check(frames->submit(frame));
    }
    for (int n = 1; n <= frames_wanted; ++n) {
        const engine::Frame frame = held(frames->begin(), 1);
        renderer->begin(frame);
        (void)wind.record(frame.commands, {.dt = k_frame, .slot = frame.slot});
        check(renderer->record(frame, scene.camera, wind));
        renderer->copy(frame);
        check(frames->finish(frame));
        renderer->clock().collect(frame.slot);
        char name[32];
        std::snprintf(name, sizeof name, "frame_%04d.png", n);
        check(render::write_png(renderer->images().picture(), folder / name));
    }
    std::uint64_t vertices = 0;
    for (const auto& stand : drawn)
        vertices += stand->drawn_vertices();
    std::printf("%s: %d frames, %zu trees, %llu vertices in the last one, %.1f MiB, in %s\n", device->name().c_str(),
                frames_wanted, trees, static_cast<unsigned long long>(vertices),
                static_cast<double>(device->memory_bytes()) / 1048576.0, folder.string().c_str());
    for (const render::StageTime& stage : renderer->clock().times())
        std::printf("%-8s %10.0f us\n", stage.name, stage.us);
    return 0;
}
