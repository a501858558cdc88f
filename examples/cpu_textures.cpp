// Tutorial: the wind on the CPU, its textures on a Vulkan device. For a game that wants the air on the host (a server, replays, a
// GPU that is full) and shaders that sample it.
//
//     cpu_textures [FILE]     blows for 20 s, draws the air to FILE (cpu_textures.ppm), compares the shader with the CPU
//
// 1. Make the wind, and advance it as always: an engine::CpuWind has a windrow::Wind, and what its shaders need.
// 2. That is, for an engine of your own (vegetation/vulkan/cpu_wind.cpp, wind_set.cpp): two images of RGBA16F with a texel a cell,
//    mapped staging buffers of as many bytes, a buffer of the gust tile, uniform buffers and sets.
// 3. In each frame write the cells as halves into the staging buffer (write_vectors) and copy it to one of the images; write the
//    FrameBlock, which places them in the world; fill the set by vulkan::SetWrites.
// 4. Draw. A shader that includes shaders/coupling/windrow_wind.glsl calls windrow_velocity(p), as with a wind on the device.
// 5. The shader gets what Wind::velocity returns, to the rounding of halves and of the texture unit's weights.
//
// What to see: air from the left, 1.2 m above the ground, combed along its direction; blue is slow, yellow fast. It parts before a
// tower and a house, is fast beside them and slow behind. A fan blows into it from below. Toward the marks, where the box ends, it
// fades to the ambient wind over 4 m.
#include "shader_words/air_frag.h"
#include "shader_words/plane_vert.h"
#include "shader_words/probe_frag.h"
#include "vegetation/vulkan/canvas.h"
#include "vegetation/vulkan/frames.h"
#include "vegetation/vulkan/wind_set.h"

#include <cstdio>
#include <fstream>
#include <glm/common.hpp>

namespace engine = windrow::vegetation::engine;
namespace words = windrow::vulkan::shader_words;

namespace {

constexpr glm::dvec3 k_middle{4.0e5, 1.2, -2.5e5};               // [m] of the picture, in the world: the anchor of the shaders
constexpr glm::ivec3 k_cells{72, 16, 40};                        // of half a metre
constexpr VkExtent2D k_picture{1280, 720}, k_probes{80, 3 * 45}; // places in 45 rows, a component below the other
constexpr glm::vec2 k_half_size{20.0f, 11.25f};                  // [m] of the picture

// The push constants of examples/shaders/plane.glsl. [m]
struct Plane {
    glm::vec4 tower{-9.0f, -3.0f, 1.6f, 0.0f}; ///< where, radius
    glm::vec4 house{1.0f, 1.5f, 1.5f, 2.5f};   ///< where, half size
    glm::vec2 half_size = k_half_size, pixels{k_picture.width, k_picture.height};
    glm::vec2 box_half = 0.25f * glm::vec2(k_cells.x, k_cells.z);
};

glm::dvec3 at(double x, double height, double z) {
    return k_middle + glm::dvec3(x, height - 1.2, z);
}

std::unique_ptr<engine::CpuWind> blown(engine::Device& device) {
    auto made = engine::must(engine::CpuWind::create(device, {.cells = k_cells,
                                                              .cell_size = 0.5f,
                                                              .boundaries = windrow::Boundaries::open_over_floor(),
                                                              .centre = at(0.0, 4.0, 0.0),
                                                              .ambient = {6.0f, 0.0f, 0.5f},
                                                              .profile = windrow::LogProfile{},
                                                              .gusts = {.intensity = 0.15f},
                                                              .blend_width = 8.0f}));
    windrow::Wind& wind = made->air();
    const auto tower = Plane{}.tower, house = Plane{}.house;
    const windrow::Cylinder cylinder{.radius = tower.z, .half_length = 3.0f};
    (void)engine::must(wind.obstacles().add({.position = at(tower.x, 3.0, tower.y), .shape = cylinder}));
    const windrow::Block block{.half_size = {house.z, 2.0f, house.w}};
    (void)engine::must(wind.obstacles().add({.position = at(house.x, 2.0, house.y), .shape = block}));
    (void)engine::must(wind.motors().add(windrow::JetMotor{.position = at(-7.0, 1.2, 8.5),
                                                           .direction = {0.3f, 0.0f, -1.0f},
                                                           .length = 6.0f,
                                                           .end_radius = 1.4f,
                                                           .law = windrow::Drive{.speed = 14.0f, .rate = 8.0f}}));
    for (int frame = 0; frame < 20 * 60; ++frame)
        (void)wind.advance(1.0 / 60.0);
    return made;
}

// Largest difference between a component that the shader wrote, as a float a pixel, and the CPU's. [m/s]
double apart(const windrow::Wind& wind, const engine::Canvas& probes) {
    std::vector<glm::dvec3> places;
    for (int n = 0; n < 80 * 45; ++n)
        places.push_back(k_middle + glm::dvec3((2.0 * (n % 80 + 0.5) / 80.0 - 1.0) * k_half_size.x, 0.0,
                                               (2.0 * (n / 80 + 0.5) / 45.0 - 1.0) * k_half_size.y));
    std::vector<glm::vec3> winds(places.size());
    wind.velocity(places, winds);
    const auto* const sampled = reinterpret_cast<const float*>(probes.pixels().data());
    float largest = 0.0f;
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::size_t n = 0; n < winds.size(); ++n)
            largest = std::max(largest, std::abs(sampled[axis * winds.size() + n] - winds[n][static_cast<int>(axis)]));
    return static_cast<double>(largest);
}

void draw_air(const std::string& file) {
    // 1. The wind.
    const auto device = engine::must(engine::Device::create());
    const auto on_cpu = blown(*device);
    const windrow::Wind& wind = on_cpu->air();

    // 2. The device's side of it.
    engine::Objects objects(*device);
    engine::WindSet wind_set(objects);
    const VkPipelineLayout layout = engine::make_pipeline_layout(objects, std::array{wind_set.layout()}, sizeof(Plane));
    const engine::Canvas picture(objects, k_picture, VK_FORMAT_R8G8B8A8_SRGB, VK_SAMPLE_COUNT_1_BIT);
    const engine::Canvas probes(objects, k_probes, VK_FORMAT_R32_SFLOAT, VK_SAMPLE_COUNT_1_BIT);
    const VkPipeline air = engine::make_pipeline(objects, {words::plane_vert, words::air_frag, {}, layout, picture.target()});
    const VkPipeline probe = engine::make_pipeline(objects, {words::plane_vert, words::probe_frag, {}, layout, probes.target()});

    // 3. The cells of a frame.
    const auto frames = engine::must(engine::Frames::create(*device));
    const engine::Frame frame = engine::must(frames->begin());
    engine::must(on_cpu->record(frame.commands, frame.slot));
    const VkDescriptorSet set = wind_set.of(frame.slot, *on_cpu, k_middle, {});

    // 4. What samples them.
    const Plane plane;
    for (const auto& [canvas, pipeline] : {std::pair{&picture, air}, {&probes, probe}}) {
        canvas->begin(frame.commands);
        vkCmdBindPipeline(frame.commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline);
        vkCmdBindDescriptorSets(frame.commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout, 0, 1, &set, 0, nullptr);
        vkCmdPushConstants(frame.commands, layout, VK_SHADER_STAGE_ALL, 0, sizeof plane, &plane);
        vkCmdDraw(frame.commands, 3, 1, 0, 0);
        canvas->end(frame.commands);
    }
    engine::must(frames->finish(frame));
    std::ofstream out(file, std::ios::binary);
    out << "P6\n" << k_picture.width << " " << k_picture.height << "\n255\n";
    for (std::size_t pixel = 0; pixel < picture.pixels().size(); pixel += 4)
        out.write(reinterpret_cast<const char*>(picture.pixels().data()) + pixel, 3);
    if (!out.flush())
        throw engine::Failure(file + " cannot be written: name a file in a folder that you may write to.");

    // 5. Both sides. Halves round by 2^-11 of the largest cell, a texture unit's weights by 3 / 2^(b + 1) of the largest difference
    // between neighbours, at most twice that cell; 1e-4 m/s is for places in floats.
    float most = 0.0f;
    for (const glm::vec4& cell : wind.field())
        most = std::max({most, std::abs(cell.x), std::abs(cell.y), std::abs(cell.z)});
    const double bound = most * (0x1p-11 + 2.0 * 1.5 / std::exp2(device->limits().subTexelPrecisionBits)) + 1e-4;
    std::printf(
        "%s: the shader is within %.5f m/s of the CPU at 3600 places, where %.5f may be rounding; air up to %.1f m/s, %s\n",
        device->name().c_str(), apart(wind, probes), bound, static_cast<double>(most), file.c_str());
}

} // namespace

int main(int count, char** arguments) {
    if (count > 2 || (count > 1 && arguments[1][0] == '-')) {
        std::fprintf(stderr, "usage: cpu_textures [FILE]\n");
        return 2;
    }
    const auto drawn = engine::guarded([&] { draw_air(count > 1 ? arguments[1] : "cpu_textures.ppm"); });
    if (!drawn)
        std::fprintf(stderr, "%s\n", drawn.error().c_str());
    return drawn ? 0 : 2;
}
