// Tutorial: the wind on the GPU, inside an engine's own renderer. A walker crosses a meadow, a fan blows over it.
//
//     embed_vulkan [FRAMES [FILE]]     draws so many frames of 1/60 s (default 150), and the last to FILE (embed_vulkan.ppm)
//
// 1. Make your device as you always do. `requirements` says what to ask for, `check` whether a physical device has it. This
//    example takes the small Vulkan layer of vegetation/vulkan.
// 2. Lend the device (vulkan::Host). The wind makes buffers, images and pipelines on it; it never submits and never waits.
// 3. In each frame move things, and record the wind before what samples it, outside of a render pass.
// 4. Draw. A shader that includes shaders/coupling/windrow_wind.glsl calls windrow_velocity(p) (examples/shaders/grass.vert). It
//    needs one descriptor set (vegetation/vulkan/wind_set.h), and no barrier: the recording ends with one.
// 5. Ask on the CPU too: queried_points() has the wind at Frame::points, as old as the frames in flight and up to a tick more.
//
// What to see: grass leans with gusts that run over the field as pale waves, behind the walker and before the fan.
#include "shader_words/figure_frag.h"
#include "shader_words/figure_vert.h"
#include "shader_words/grass_frag.h"
#include "shader_words/grass_vert.h"
#include "shader_words/sky_frag.h"
#include "shader_words/sky_vert.h"
#include "vegetation/vulkan/canvas.h"
#include "vegetation/vulkan/frames.h"
#include "vegetation/vulkan/wind_set.h"

#include <charconv>
#include <cstdio>
#include <fstream>
#include <glm/gtc/matrix_transform.hpp>
#include <vulkan/vulkan.h>

namespace engine = windrow::vegetation::engine;
namespace words = windrow::vulkan::shader_words;

namespace {

constexpr double k_frame = 1.0 / 60.0;                               // [s]
constexpr glm::dvec3 k_field{4.0e5, 0.0, -2.5e5};                    // [m] the middle of the meadow, in the world
constexpr glm::dvec3 k_start{-9.0, 0.0, 0.0}, k_walk{4.0, 0.0, 0.0}; // [m] where the walker begins, [m/s] its velocity
constexpr glm::dvec3 k_fan_hub{6.3, 1.25, -6.0};                     // [m] from the middle of the meadow
constexpr glm::vec3 k_fan_axis{-0.98f, -0.12f, 0.16f};
constexpr glm::vec3 k_eye{0.0f, 2.3f, 9.0f}; // [m] from the middle of the meadow
constexpr VkExtent2D k_extent{1280, 720};
constexpr std::uint32_t k_blades = 40000, k_capsules = 7 + 1 + 5 + 24, k_capsule_vertices = 6 * 8 * 12; // as the shaders count

// The push constants of examples/shaders/scene.glsl, 128 bytes.
struct Scene {
    glm::mat4 view_projection{1.0f};
    glm::vec4 eye{k_eye, k_blades}, walker{0.0f}, fan{0.0f}, fan_axis{glm::normalize(k_fan_axis), 0.9f};
};

Scene scene_at(double time) {
    glm::mat4 projection = glm::perspectiveRH_ZO(glm::radians(44.0f), 16.0f / 9.0f, 0.5f, 160.0f);
    projection[1][1] = -projection[1][1]; // Vulkan's clip space has y down
    return {.view_projection = projection * glm::lookAtRH(k_eye, k_eye + glm::vec3(0.0f, -0.19f, -1.0f), {0.0f, 1.0f, 0.0f}),
            .walker = glm::vec4(glm::vec3(k_start + time * k_walk), 0.0f),
            .fan = glm::vec4(glm::vec3(k_fan_hub), static_cast<float>(9.0 * time))};
}

void draw_meadow(int frames_wanted, const std::string& file) {
    // 1. The engine's device, and a picture with four samples a pixel.
    const auto device = engine::must(engine::Device::create());
    engine::Objects objects(*device);
    const engine::Canvas canvas(objects, k_extent, VK_FORMAT_R8G8B8A8_SRGB, VK_SAMPLE_COUNT_4_BIT);

    // 2. The wind on it: half a metre a cell around the walker, gusts over open ground.
    const auto body_at = [](double time) { return k_field + k_start + time * k_walk + glm::dvec3(0.0, 0.8, 0.0); };
    auto wind = engine::must(windrow::vulkan::Wind::create(
        device->host(),
        {.cells = {48, 12, 48},
         .cell_size = 0.5f,
         .boundaries = windrow::Boundaries::open_over_floor(),
         .centre = k_field + k_start + glm::dvec3(0.0, 3.0, 0.0),
         .ambient = {-0.8f, 0.0f, 3.0f},
         .profile = windrow::LogProfile{},
         .gusts = {.intensity = 0.35f, .length = 10.0f}},
        {.frames_in_flight = engine::k_frames_in_flight, .queries = windrow::vulkan::ReadBack::points}));
    const auto walker = engine::must(wind.motors().add(
        windrow::WakeMotor{.position = body_at(0.0), .radius = 0.9f, .law = windrow::WakeDrive{.per_metre = 20.0f}}));
    (void)engine::must(wind.motors().add(windrow::JetMotor{.position = k_field + k_fan_hub,
                                                           .direction = k_fan_axis,
                                                           .length = 7.0f,
                                                           .start_radius = 0.9f,
                                                           .end_radius = 1.6f,
                                                           .law = windrow::Drive{.speed = 12.0f, .rate = 8.0f}}));
    engine::WindSet wind_set(objects);
    const std::array sets{wind_set.layout()};
    const VkPipelineLayout layout = engine::make_pipeline_layout(objects, sets, sizeof(Scene));
    const engine::PassTarget target = canvas.target();
    const VkPipeline sky = engine::make_pipeline(objects, {words::sky_vert, words::sky_frag, {}, layout, target});
    const VkPipeline figures = engine::make_pipeline(objects, {words::figure_vert, words::figure_frag, {}, layout, target});
    const VkPipeline grass = engine::make_pipeline(
        objects, {words::grass_vert, words::grass_frag, {}, layout, target, VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP});

    const auto frames = engine::must(engine::Frames::create(*device));
    int dispatches = 0;
    for (int n = 1; n <= frames_wanted; ++n) {
        const engine::Frame frame = engine::must(frames->begin());
        const VkCommandBuffer commands = frame.commands;
        // 3. The wind of this frame.
        (void)wind.motors().move(walker, body_at(n * k_frame));
        (void)wind.follow(k_field + k_start + n * k_frame * k_walk);
        const std::array asked{body_at(n * k_frame)};
        engine::must(wind.record(commands, {.dt = k_frame, .slot = frame.slot, .points = asked}));
        dispatches += wind.dispatches();

        // 4. What samples it. Ripples of half a metre are finer than the cells: windrow_apparent adds them.
        const VkDescriptorSet set = wind_set.of(frame.slot, wind, k_field, {.detail = 0.6f, .detail_length = 0.5f});
        const Scene scene = scene_at(n * k_frame);
        canvas.begin(commands);
        vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout, 0, 1, &set, 0, nullptr);
        vkCmdPushConstants(commands, layout, VK_SHADER_STAGE_ALL, 0, sizeof scene, &scene);
        const auto draw = [&](VkPipeline pipeline, std::uint32_t vertices, std::uint32_t instances) {
            vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline);
            vkCmdDraw(commands, vertices, instances, 0, 0);
        };
        draw(sky, 3, 1);
        draw(figures, k_capsule_vertices, k_capsules);
        draw(grass, 7, k_blades);
        canvas.end(commands);
        engine::must(frames->submit(frame));
    }
    engine::must(frames->wait());
    std::ofstream out(file, std::ios::binary);
    out << "P6\n" << k_extent.width << " " << k_extent.height << "\n255\n";
    const auto* const pixels = reinterpret_cast<const char*>(canvas.pixels().data());
    for (std::size_t pixel = 0; pixel < canvas.pixels().size(); pixel += 4)
        out.write(pixels + pixel, 3);
    if (!out.flush())
        throw engine::Failure(file + " cannot be written: name a file in a folder that you may write to.");

    // 5. What the CPU knows.
    const auto asked = wind.queried_points();
    const glm::dvec3 felt(asked ? asked->velocities.front() : glm::vec4(0.0f));
    std::printf("%s: %d frames, %.1f dispatches a frame, wind at the walker (%.2f, %.2f, %.2f) m/s as of %.0f ms ago, %s\n",
                device->name().c_str(), frames_wanted, static_cast<double>(dispatches) / frames_wanted, felt.x, felt.y, felt.z,
                1e3 * wind.query_age(), file.c_str());
}

} // namespace

int main(int count, char** arguments) {
    int frames = 150;
    const std::string text = count > 1 ? arguments[1] : "150";
    const auto read = std::from_chars(text.data(), text.data() + text.size(), frames);
    if (count > 3 || read.ec != std::errc{} || read.ptr != text.data() + text.size() || frames < 3) {
        std::fprintf(stderr, "usage: embed_vulkan [FRAMES [FILE]], FRAMES from 3: the wind at the end was read back by then\n");
        return 2;
    }
    const auto drawn = engine::guarded([&] { draw_meadow(frames, count > 2 ? arguments[2] : "embed_vulkan.ppm"); });
    if (!drawn)
        std::fprintf(stderr, "%s\n", drawn.error().c_str());
    return drawn ? 0 : 2;
}
