// What a field of grass costs a frame, and what quadtree, culling and levels save of it.
//
//     windrow_grass_bench [most metres]          default 500: 9,000,000 places at 6 a metre
//
// Fields of 16 m to 500 m, an eye 1.7 m above the middle that turns once around in 16 frames; settings as by default. Vertices a
// frame, the mean of the 16: of all places of the field (nothing left out, 15 each), of the chunks that the quadtree finds (15
// each), and of what culling by blade and levels leave. These are counts: the same on every machine. Times: the CPU's share of a
// frame (walk, slots, recording), and the passes, submitted and waited for, less an empty submission; the least of 5 turns. The
// first frame makes its blades.
#include "fluid/vulkan/own_device.h"
#include "vegetation/bench/grass_eyes.h"
#include "vegetation/grass/grass_field.h"
#include "vegetation/render/grass_layer.h"
#include "vegetation/render/renderer.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <memory>
#include <string>
#include <vector>

using namespace windrow::vegetation;

namespace {

constexpr int k_turns = 5;

template <class Body>
double milliseconds(const Body& body) {
    const auto start = std::chrono::steady_clock::now();
    body();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

template <class Value>
Value held(windrow::Result<Value> result) {
    if (!result) {
        std::fprintf(stderr, "%s\n", result.error().c_str());
        std::exit(3);
    }
    return *std::move(result);
}
void held(const windrow::Result<void>& result) {
    if (!result) {
        std::fprintf(stderr, "%s\n", result.error().c_str());
        std::exit(3);
    }
}

// Vertices that the draws of the colour's view come to.
double vertices_of(engine::Device& device, const grass::GrassField& field, const std::vector<grass::Chunk>& chunks) {
    const auto draws = held(
        device.read<VkDrawIndirectCommand>(field.draw_buffer(), 0, 4 * static_cast<std::size_t>(field.settings().max_chunks)));
    double vertices = 0.0;
    for (const grass::Chunk chunk : chunks)
        for (int level = 0; level < 2; ++level) {
            const VkDrawIndirectCommand& draw = draws[static_cast<std::size_t>(4 * field.slot_of(chunk) + level)];
            vertices += static_cast<double>(draw.vertexCount) * draw.instanceCount;
        }
    return vertices;
}

void measure(windrow::vulkan::OwnDevice& own, engine::Device& device, float metres) {
    const windrow::HeightMap heights = held(grass::bench::rolling_hills(metres));
    const grass::PlacementMask mask = held(grass::PlacementMask::create({257, 257}, heights.extent(), 1.0f));
    const grass::GrassSettings settings;
    grass::GrassField field = held(grass::GrassField::create(device, heights, mask, settings));
    const double places = static_cast<double>(field.tree().cells().x) * field.tree().cells().y;
    double walk = 1e30, passes = 1e30, first = 0.0, empty = 1e30, in_chunks = 0.0, drawn = 0.0, most = 0.0;
    const auto frame = [&](const grass::GrassCamera& camera, double& recorded) {
        return milliseconds([&] {
            held(own.run([&](VkCommandBuffer commands) {
                recorded = milliseconds([&] { (void)held(field.record_cull(commands, camera)); });
            }));
        });
    };
    for (int turn = 0; turn < k_turns; ++turn) {
        double walk_here = 0.0, passes_here = 0.0;
        for (int n = 0; n < grass::bench::k_frames; ++n) {
            const grass::GrassCamera camera = grass::bench::camera_at(heights, n);
            double recorded = 0.0;
            empty = std::min(empty, milliseconds([&] { held(own.run([](VkCommandBuffer) {})); }));
            const double whole = frame(camera, recorded);
            walk_here += recorded / grass::bench::k_frames;
            passes_here += (whole - recorded) / grass::bench::k_frames;
            if (turn == 0 && n == 0)
                first = whole - recorded;
            if (turn == 0) {
                std::vector<grass::Chunk> chunks;
                field.tree().visible(grass::frustum_planes(camera.view_projection, glm::dvec3(0.0)), camera.eye,
                                     settings.cut_distance, chunks);
                in_chunks += 15.0 * settings.chunk_cells * settings.chunk_cells * static_cast<double>(chunks.size()) /
                             grass::bench::k_frames;
                drawn += vertices_of(device, field, chunks) / grass::bench::k_frames;
                most = std::max(most, static_cast<double>(chunks.size()));
            }
        }
        walk = std::min(walk, walk_here);
        passes = std::min(passes, passes_here);
    }
    std::printf("%5.0f m %9.0f places | vertices %11.0f %10.0f %9.0f | chunks <= %3.0f | CPU %.3f ms, passes %.2f ms, first "
                "frame %.1f ms | "
                "%.1f MB\n",
                static_cast<double>(metres), places, 15.0 * places, in_chunks, drawn, most, walk, passes - empty, first - empty,
                static_cast<double>(field.memory_bytes()) / 1e6);
}

// A meadow that is drawn in gusts with detail: stages by the device's clock, medians.
void measure_motion(engine::Device& device, float metres, int width, int height) {
    constexpr int k_warm = 4, k_timed = 24;
    constexpr double k_step = 1.0 / 60.0;
    render::Scene scene;
    scene.ground = {.corner = glm::dvec3(0.0), .heights = held(grass::bench::rolling_hills(metres))};
    const glm::dvec3 middle(0.5 * static_cast<double>(metres), 3.0, 0.5 * static_cast<double>(metres));
    scene.wind.wind = {.centre = middle + glm::dvec3(0.0, 4.0, 0.0), .ambient = {3.4f, 0.0f, 4.2f}};
    scene.wind.wind.gusts = {.intensity = 0.4f, .length = 14.0f};
    scene.wind.sampling = {.detail = 0.5f, .detail_length = 0.5f};
    auto wind =
        held(windrow::vulkan::Wind::create(device.host(), scene.wind.wind, {.frames_in_flight = engine::k_frames_in_flight}));
    const auto frames = held(engine::Frames::create(device));
    const grass::PlacementMask mask = held(grass::PlacementMask::create({257, 257}, scene.ground.heights.extent(), 1.0f));
    struct Case {
        const char* name;
        bool springs, waves;
        std::unique_ptr<render::Renderer> renderer{};
        std::unique_ptr<render::GrassLayer> grass{};
        std::map<std::string, std::vector<double>> stages{};
    } cases[] = {{"neither", false, false}, {"springs", true, false}, {"waves", false, true}, {"both", true, true}};
    for (Case& each : cases) {
        scene.look.wave = each.waves ? render::PlantLook{}.wave : 0.0f;
        each.renderer = held(render::Renderer::create(device, scene, {.width = width, .height = height}));
        each.grass = held(render::GrassLayer::create(device, each.renderer->draw_targets(), scene.ground, mask,
                                                     {.look = scene.look, .springs = each.springs}));
        each.renderer->add(*each.grass);
        each.grass->set_time_step(4.0 * k_step);
    }
    render::Camera camera;
    camera.position = {middle.x, static_cast<double>(scene.ground.heights.height(glm::vec2(middle.x, middle.z))) + 1.7, middle.z};
    camera.target = camera.position + glm::dvec3(10.0, -0.8, 3.0);
    for (int round = 0; round < k_warm + k_timed; ++round)
        for (Case& each : cases) {
            const engine::Frame frame = held(frames->begin());
            each.renderer->begin(frame);
            (void)held(wind.record(frame.commands, {.dt = k_step, .slot = frame.slot}));
            held(each.renderer->record(frame, camera, wind));
            held(frames->finish(frame));
            each.renderer->clock().collect(frame.slot);
            double whole = 0.0;
            for (const render::StageTime& stage : each.renderer->clock().times()) {
                if (round >= k_warm)
                    each.stages[stage.name].push_back(stage.us);
                whole += std::strcmp(stage.name, "wind") != 0 ? stage.us : 0.0;
            }
            if (round >= k_warm)
                each.stages["frame"].push_back(whole);
        }
    const auto median = [](std::vector<double> values) {
        std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
        return values[values.size() / 2];
    };
    std::printf("motion, %d x %d: ms of a stage, and over that of neither; the frame is without its wind\n", width, height);
    for (Case& each : cases) {
        std::printf("%8s", each.name);
        for (const char* const stage : {"prepare", "colour", "frame"}) {
            const double ms = 1e-3 * median(each.stages[stage]);
            std::printf(" | %s %8.3f %5.3f", stage, ms, ms / (1e-3 * median(cases[0].stages[stage])));
        }
        std::printf("\n");
    }
}

} // namespace

int main(int count, char** arguments) {
    const double most = count > 1 ? std::atof(arguments[1]) : 500.0;
    const auto own = held(windrow::vulkan::OwnDevice::create({.queue = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT}));
    const auto device = held(engine::Device::adopt(own->host(), own->queue()));
    std::printf("%s, %s\n", own->facts().name.c_str(), own->facts().driver.c_str());
    std::printf(
        "field, places | vertices of the field, of its chunks in view, drawn | chunks in view | times a frame | memory\n");
    for (const float metres : {16.0f, 50.0f, 160.0f, 500.0f})
        if (static_cast<double>(metres) <= most)
            measure(*own, *device, metres);
    measure_motion(*device, 160.0f, 640, 360);
    return 0;
}
