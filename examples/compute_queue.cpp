// Tutorial: the wind on a compute queue beside graphics.
//
//     compute_queue [FRAMES]     blows and draws so many frames of 1/60 s (default 60)
//
// 1. Ask for two queues: one of a family that only computes, or a second one of the drawing family. Where there is neither, one
//    queue takes both submissions, and everything else stays as it is.
// 2. Tell the wind the family that it runs on (Host::queue_family), and who samples: stages of its own family
//    (Host::reader_stages), or queues of others (Host::reader_queue_families).
// 3. Each frame is two submissions. The drawing waits for the wind of its frame. The wind waits for the drawing of the frame before,
//    whose textures it overwrites; what that frame does after sampling runs beside it (docs/vulkan.md).
// 4. A fence of the compute queue says that a slot's read-back is there.
#include "examples/queue_lane.h"
#include "shader_words/slice_frag.h"
#include "shader_words/slice_vert.h"
#include "vegetation/vulkan/canvas.h"
#include "vegetation/vulkan/wind_set.h"

#include <charconv>
#include <cstdio>
#include <string_view>
#include <vulkan/vulkan.h>
#include <windrow/fluid/vulkan/own_device.h>

namespace engine = windrow::vegetation::engine;
namespace vulkan = windrow::vulkan;
namespace words = windrow::vulkan::shader_words;

namespace {

constexpr double k_frame = 1.0 / 60.0;      // [s]
constexpr std::uint32_t k_pixels = 64;      // along each side: 16 m x 16 m of air from above
constexpr glm::dvec3 k_centre{4.0e5, 0, 0}; // [m] of the box, in the world
constexpr VkPipelineStageFlags k_wind_stages = VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_TRANSFER_BIT;
constexpr VkPipelineStageFlags k_sampling_stages = VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT;

void blow_and_draw(int frames) {
    // 1. The host's device and its queues.
    const auto own = engine::must(vulkan::OwnDevice::create({.queue = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT,
                                                             .compute_queue = true,
                                                             .get_instance_proc_addr = vkGetInstanceProcAddr}));
    const std::uint32_t drawing_family = own->host().queue_family, wind_family = own->compute_host().queue_family;
    std::printf("%s draws on queue family %u and blows on %s\n", own->facts().name.c_str(), drawing_family,
                wind_family != drawing_family          ? ("family " + std::to_string(wind_family) + ", which computes").c_str()
                : own->compute_queue() != own->queue() ? "a second queue of it"
                                                       : "the same queue: it has no other");

    // 2. Where the wind runs, and who samples it.
    vulkan::Host host = own->host();
    host.queue_family = wind_family;
    if (wind_family != drawing_family)
        host.reader_queue_families = {drawing_family};
    else
        host.reader_stages = k_sampling_stages;
    auto wind = engine::must(
        vulkan::Wind::create(host, {.cells = {32, 8, 32}, .cell_size = 0.5f, .centre = k_centre, .ambient = {3.0f, 0.0f, -2.0f}},
                             {.frames_in_flight = QueueLane::k_slots, .queries = vulkan::ReadBack::cells}));
    (void)engine::must(wind.motors().add(windrow::VortexMotor{.position = k_centre + glm::dvec3(0.0, 0.0, 4.0)}));

    const auto device = engine::must(engine::Device::adopt(own->host(), own->queue()));
    engine::Objects objects(*device);
    const engine::Canvas canvas(objects, {k_pixels, k_pixels}, VK_FORMAT_R8G8B8A8_UNORM, VK_SAMPLE_COUNT_1_BIT);
    engine::WindSet wind_set(objects);
    const VkPipelineLayout layout = engine::make_pipeline_layout(objects, std::array{wind_set.layout()});
    const VkPipeline pipeline =
        engine::make_pipeline(objects, {words::slice_vert, words::slice_frag, {}, layout, canvas.target()});

    // 3. Two submissions a frame, two frames in flight.
    const QueueLane blowing(host, own->compute_queue()), drawing(own->host(), own->queue());
    std::size_t slot = 0;
    for (int n = 0; n < frames; ++n) {
        slot = static_cast<std::size_t>(n) % QueueLane::k_slots;
        blowing.wait(slot); // what it read back is there
        drawing.wait(slot);
        blowing.submit(slot, n == 0 ? VK_NULL_HANDLE : drawing.signal(), k_wind_stages, [&](VkCommandBuffer commands) {
            engine::must(wind.record(commands, {.dt = k_frame, .slot = static_cast<int>(slot)}));
        });
        drawing.submit(slot, blowing.signal(), k_sampling_stages, [&](VkCommandBuffer commands) {
            device->begin_frame(commands, static_cast<int>(slot));
            const VkDescriptorSet set = wind_set.of(static_cast<int>(slot), wind, k_centre, {});
            canvas.begin(commands);
            vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline);
            vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout, 0, 1, &set, 0, nullptr);
            vkCmdDraw(commands, 3, 1, 0, 0);
            canvas.end(commands);
        });
    }
    drawing.wait(slot);

    // 4. A pixel beside the middle as the drawing queue sampled it, and the same place as the compute queue read it back.
    blowing.wait(slot);
    (void)wind.collect(static_cast<int>(slot));
    const auto* const pixel =
        reinterpret_cast<const unsigned char*>(canvas.pixels().data()) + 4 * (k_pixels / 2) * (k_pixels + 1);
    const glm::vec3 drawn = (glm::vec3(pixel[0], pixel[1], pixel[2]) / 255.0f - 0.5f) * 16.0f;
    const double metres = 0.5 * 16.0 / k_pixels; // half a pixel from the middle
    const glm::vec3 read = wind.velocity(k_centre + glm::dvec3(metres, 0.0, metres));
    std::printf("%d frames in %d submissions: wind (%.2f, %.2f, %.2f) m/s drawn, (%.2f, %.2f, %.2f) m/s read back\n", frames,
                2 * frames, drawn.x, drawn.y, drawn.z, read.x, read.y, read.z);
}

} // namespace

int main(int count, char** arguments) {
    int frames = 60;
    const std::string_view text = count > 1 ? arguments[1] : "60";
    const auto read = std::from_chars(text.data(), text.data() + text.size(), frames);
    if (count > 2 || read.ec != std::errc{} || read.ptr != text.data() + text.size() || frames < 1) {
        std::fprintf(stderr, "usage: compute_queue [FRAMES], FRAMES from 1\n");
        return 2;
    }
    try {
        blow_and_draw(frames);
    } catch (const std::runtime_error& failure) { // engine::Failure too
        std::fprintf(stderr, "%s\n", failure.what());
        return 2;
    }
    return 0;
}
