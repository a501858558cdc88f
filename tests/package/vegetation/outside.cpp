// outside PICTURE.ppm [bare]: a picture of 320 x 180 pixels, level ground under a sky, with grass in wind or bare.
//
// A program outside of the project. It uses installed headers and libraries only.
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vulkan/vulkan.h>
#include <windrow/fluid/wind.h>
#include <windrow/vegetation/render/grass_layer.h>
#include <windrow/vegetation/render/renderer.h>

namespace engine = windrow::vegetation::engine;
namespace grass = windrow::vegetation::grass;
namespace render = windrow::vegetation::render;

namespace {

constexpr double k_frame = 1.0 / 30.0; // [s]
constexpr int k_frames = 30;

template <class T>
T held(windrow::Result<T> result) {
    if (!result) {
        std::fprintf(stderr, "outside: %s\n", result.error().c_str());
        std::exit(1);
    }
    if constexpr (!std::is_void_v<T>)
        return *std::move(result);
}

render::Scene level_ground() {
    render::Scene scene;
    scene.camera.position = {0.0, 1.4, 20.0};
    scene.camera.target = {0.0, 0.9, 10.0};
    windrow::Config& wind = scene.wind.wind;
    wind.cells = {16, 8, 16};
    wind.boundaries = windrow::Boundaries::open_over_floor();
    wind.centre = {0.0, 4.0, 14.0};
    wind.ambient = {4.0f, 0.0f, -1.0f};
    return scene;
}

} // namespace

int main(int count, char** arguments) {
    if (count < 2 || count > 3 || (count == 3 && std::string(arguments[2]) != "bare")) {
        std::fprintf(stderr, "usage: outside PICTURE.ppm [bare]\n");
        return 2;
    }
    const render::Scene scene = level_ground();
    // The wind on the CPU comes with windrow::fluid: it checks the config that the GPU gets.
    (void)held(windrow::Wind::create(scene.wind.wind));

    const auto device = held(engine::Device::create());
    auto wind =
        held(windrow::vulkan::Wind::create(device->host(), scene.wind.wind, {.frames_in_flight = engine::k_frames_in_flight}));

    const auto renderer = held(render::Renderer::create(*device, scene, {.width = 320, .height = 180}));
    const auto mask = held(grass::PlacementMask::create({65, 65}, scene.ground.heights.extent(), 1.0f));
    const auto field =
        held(render::GrassLayer::create(*device, renderer->draw_targets(), scene.ground, mask, {.look = scene.look}));
    if (count == 2)
        renderer->add(*field);

    const auto frames = held(engine::Frames::create(*device));
    for (int n = 1; n <= k_frames; ++n) {
        const engine::Frame frame = held(frames->begin());
        renderer->begin(frame);
        held(wind.record(frame.commands, {.dt = k_frame, .slot = frame.slot}));
        if (n == k_frames) {
            held(renderer->record(frame, scene.camera, wind));
            renderer->copy(frame);
        }
        held(frames->submit(frame));
    }
    held(frames->wait());
    held(render::write_ppm(renderer->images().picture(), arguments[1]));
    std::printf("%s: %s\n", device->name().c_str(), arguments[1]);
    return 0;
}
