// A renderer on a host's own device: it draws in the host's command buffer, and what fails is an error, not the program's end.
#include "tests/parity/gpu.h"
#include "vegetation/render/grass_layer.h"
#include "vegetation/render/renderer.h"
#include "vegetation/render/wind_arrows.h"

#include <algorithm>

namespace windrow::vegetation::render {
namespace {

class LentDevice : public vulkan::Gpu {
  protected:
    static Scene small_scene() {
        Scene scene;
        scene.wind.wind.cells = {8, 8, 8};
        return scene;
    }
    const RenderSettings settings{.width = 64, .height = 48, .samples = 1, .shadow_texels = 64};
};

TEST_F(LentDevice, DrawsInTheHostsCommandBuffer) {
    const auto lent = engine::Device::adopt(own->host(), own->queue(), {.staged = true});
    ASSERT_TRUE(lent) << lent.error();
    const Scene scene = small_scene();
    {
        auto wind = vulkan::Wind::create((*lent)->host(), scene.wind.wind, {.frames_in_flight = engine::k_frames_in_flight});
        ASSERT_TRUE(wind) << wind.error();
        const auto renderer = Renderer::create(**lent, scene, settings);
        ASSERT_TRUE(renderer) << renderer.error();
        run([&](VkCommandBuffer commands) {
            const engine::Frame frame{.commands = commands, .slot = 0};
            (*lent)->begin_frame(commands, frame.slot);
            (*renderer)->begin(frame);
            EXPECT_TRUE(wind->record(commands, {.dt = 1.0 / 30.0, .slot = frame.slot}));
            EXPECT_TRUE((*renderer)->record(frame, scene.camera, *wind));
            (*renderer)->copy(frame);
        });
        run([&](VkCommandBuffer commands) { (*lent)->begin_frame(commands, 0); }); // what was staged for the frame before goes
        const Picture8 picture = (*renderer)->images().picture();
        EXPECT_TRUE(std::all_of(picture.values.begin(), picture.values.end(), [](std::uint8_t value) { return value > 0; }));
    }
    EXPECT_EQ((*lent)->memory_bytes(), 0u); // all of it went with its owners
}

TEST_F(LentDevice, IsRejectedWithAReason) {
    const auto no_queue = engine::Device::adopt(own->host(), VK_NULL_HANDLE);
    ASSERT_FALSE(no_queue);
    EXPECT_NE(no_queue.error().find("queue is null"), std::string::npos) << no_queue.error();
    EXPECT_FALSE(engine::Device::adopt({}, own->queue()));
    vulkan::Host host = own->host();
    host.queue_family = 1000;
    const auto no_family = engine::Device::adopt(host, own->queue());
    ASSERT_FALSE(no_family);
    EXPECT_NE(no_family.error().find("queue_family 1000"), std::string::npos) << no_family.error();
}

// The host's allocator gives memory so many times, then no more: each creation ends with a sentence and leaves nothing behind.
TEST_F(LentDevice, WithoutMemoryGivesAnErrorAtEachStep) {
    vulkan::Memory blocks(own->host(), device->functions());
    const vulkan::MemoryCallbacks memory = memory_of(blocks);
    int left = 0, held = 0;
    vulkan::Host host = own->host();
    host.memory.allocate = [&](const VkMemoryRequirements& needs, std::uint32_t type, vulkan::MemoryPiece& piece) {
        if (--left < 0)
            return VK_ERROR_OUT_OF_DEVICE_MEMORY;
        const VkResult given = memory.allocate(needs, type, piece);
        held += given == VK_SUCCESS ? 1 : 0;
        return given;
    };
    host.memory.release = [&](const vulkan::MemoryPiece& piece) {
        memory.release(piece);
        --held;
    };
    const Scene scene = small_scene();
    const auto mask = *grass::PlacementMask::create({2, 2}, scene.ground.heights.extent(), 1.0f);
    const GrassLayerSettings meadow{.field = {.chunk_cells = 8, .max_chunks = 1}, .max_blades = 1024};
    bool whole = false;
    int failed = 0;
    for (int granted = 0; !whole && granted < 200; granted += 3) {
        left = granted;
        const auto lent = engine::Device::adopt(host, own->queue());
        ASSERT_TRUE(lent) << lent.error();
        const auto renderer = Renderer::create(**lent, scene, settings);
        if (renderer) {
            const DrawTargets targets = (*renderer)->draw_targets();
            const auto grown = GrassLayer::create(**lent, targets, scene.ground, mask, meadow);
            if (!grown) {
                EXPECT_NE(grown.error().find("VK_ERROR_OUT_OF_DEVICE_MEMORY"), std::string::npos) << grown.error();
            }
            const auto arrows = WindArrows::create(**lent, targets, {});
            whole = grown && arrows;
        } else {
            EXPECT_NE(renderer.error().find("VK_ERROR_OUT_OF_DEVICE_MEMORY"), std::string::npos) << renderer.error();
            ++failed;
        }
    }
    EXPECT_TRUE(whole);
    EXPECT_GT(failed, 3);
    EXPECT_EQ(held, 0);
}

} // namespace
} // namespace windrow::vegetation::render
