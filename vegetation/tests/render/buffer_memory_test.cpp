// Which type of memory each use of a buffer has, on devices with heaps as GPUs have them, and a picture that does not depend on
// it.
#include "tests/parity/fake_memory.h"
#include "vegetation/render/bodies.h"
#include "vegetation/tests/render/grass_stage.h"
#include "vegetation/vulkan/buffer_memory.h"

#include <array>
#include <gtest/gtest.h>

namespace windrow::vegetation::engine {
namespace {

constexpr VkDeviceSize k_mebi = VkDeviceSize{1} << 20;
constexpr VkMemoryPropertyFlags k_own = VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT;
constexpr VkMemoryPropertyFlags k_seen = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
constexpr VkMemoryPropertyFlags k_cached = VK_MEMORY_PROPERTY_HOST_CACHED_BIT;

// In the order of Use: fixed, work, frame, staging, readback.
using Types = std::array<std::uint32_t, 5>;

struct MemoryLayout {
    std::vector<VkDeviceSize> heaps{};
    std::vector<vulkan::FakeMemory::Type> types{};
};

Types types_on(const MemoryLayout& layout, bool staged = false) {
    vulkan::FakeMemory fake(layout.heaps, layout.types);
    BufferMemory memory({}, vulkan::FakeMemory::functions(), staged);
    Types found{};
    for (std::size_t use = 0; use < found.size(); ++use) {
        const auto piece = memory.allocate({.size = 1000, .alignment = 16, .memoryTypeBits = ~0u}, static_cast<Use>(use));
        EXPECT_TRUE(piece) << piece.error();
        found[use] = fake.of(piece->memory).type;
        EXPECT_EQ(piece->mapped != nullptr, memory.in_place(static_cast<Use>(use)));
    }
    EXPECT_EQ(memory.taken(), fake.bytes());
    return found;
}

const MemoryLayout k_one{{4096 * k_mebi}, {{k_own | k_seen | k_cached, 0}}};
// As a driver lists them: of the system's memory the write-combined type stands before the cached one.
const MemoryLayout k_separate{{8192 * k_mebi, 16384 * k_mebi}, {{0, 1}, {k_own, 0}, {k_seen, 1}, {k_seen | k_cached, 1}}};
const MemoryLayout k_window{{8192 * k_mebi, 16384 * k_mebi, 256 * k_mebi},
                            {{k_seen, 1}, {k_seen | k_cached, 1}, {k_own | k_seen, 2}, {k_own, 0}}};
const MemoryLayout k_resizable{{8192 * k_mebi, 16384 * k_mebi},
                               {{k_own | k_seen, 0}, {k_own, 0}, {k_seen, 1}, {k_seen | k_cached, 1}}};
const MemoryLayout k_uncached{{8192 * k_mebi, 16384 * k_mebi}, {{k_own | k_seen, 0}, {k_own, 0}, {k_seen, 1}}};

TEST(BufferMemory, IsOfTheOneTypeOfASoftwareDevice) {
    EXPECT_EQ(types_on(k_one), (Types{0, 0, 0, 0, 0}));
}

TEST(BufferMemory, OfASeparateDeviceIsItsOwnAndIsFilledByCopies) {
    EXPECT_EQ(types_on(k_separate), (Types{1, 1, 1, 2, 3}));
}

// The window of 256 MiB is for what the host writes in each frame: fixed data, work and staging keep out of it.
TEST(BufferMemory, OfAFrameAloneIsInTheWindow) {
    EXPECT_EQ(types_on(k_window), (Types{3, 3, 2, 0, 1}));
    EXPECT_EQ(types_on(k_resizable), (Types{1, 1, 0, 2, 3}));
}

TEST(BufferMemory, ForReadingBackIsUncachedWhereNoTypeIsCached) {
    EXPECT_EQ(types_on(k_uncached), (Types{1, 1, 0, 2, 2}));
}

TEST(BufferMemory, IsStagedWhereItIsAsked) {
    EXPECT_EQ(types_on(k_resizable, true), (Types{1, 1, 1, 2, 3}));
    vulkan::FakeMemory fake(k_one.heaps, k_one.types);
    const BufferMemory memory({}, vulkan::FakeMemory::functions(), true);
    EXPECT_FALSE(memory.in_place(Use::fixed));
    EXPECT_FALSE(memory.in_place(Use::frame));
}

// Grass, ground and a body that moves, drawn with data in place and with data that the device copies.
TEST(StagedData, DrawsTheSamePictureToTheBit) {
    std::array<render::Picture8, 2> pictures;
    for (const bool staged : {false, true}) {
        std::vector<std::string> messages;
        {
            render::Scene scene;
            scene.wind.wind.cells = {16, 8, 16};
            scene.wind.wind.ambient = {3.0f, 0.0f, 1.0f};
            scene.wind.wind.gusts = {.intensity = 0.3f, .length = 6.0f};
            render::test::GrassStage stage(
                scene, {.width = 160, .height = 96, .shadow_texels = 64},
                {.validation = true, .on_message = [&](const std::string& text) { messages.push_back(text); }, .staged = staged});
            stage.grow(*grass::PlacementMask::create({9, 9}, scene.ground.heights.extent(), 1.0f), {});
            const auto body =
                must(render::Bodies::create(*stage.device, stage.renderer->draw_targets(), std::array{render::fan_blades(0.8f)}));
            stage.renderer->add(*body);
            for (int n = 0; n < 4; ++n) {
                glm::mat4 placed(1.0f);
                placed[3] = {0.2f * static_cast<float>(n), 0.0f, -6.0f, 1.0f};
                body->place(0, placed);
                stage.draw(scene.camera, 1.0 / 30.0);
            }
            pictures[staged ? 1 : 0] = stage.renderer->images().picture();
        }
        for (const std::string& message : messages)
            ADD_FAILURE() << "the validation layer reports: " << message;
    }
    EXPECT_EQ(pictures[0].values, pictures[1].values);
    EXPECT_GT(std::count_if(pictures[0].values.begin(), pictures[0].values.end(), [](std::uint8_t v) { return v > 20; }), 10000);
}

} // namespace
} // namespace windrow::vegetation::engine
