// What copies and fills write into buffers is what is read back.
#include "tests/parity/gpu.h"

#include <cstdint>
#include <cstring>
#include <random>
#include <utility>

namespace windrow::vulkan {
namespace {

class Buffers : public Gpu {};

TEST_F(Buffers, KeepWhatAnUpdateWrites) {
    const Buffer on_device = buffer(64, MemoryUse::device);
    const Buffer back = buffer(64, MemoryUse::readback);
    EXPECT_EQ(on_device.mapped(), nullptr);
    EXPECT_EQ(on_device.bytes(), 64u);
    std::vector<std::uint32_t> values(16);
    for (std::uint32_t i = 0; i < 16; ++i)
        values[i] = 0x01010101u * i;
    run([&](VkCommandBuffer commands) {
        const VkBufferCopy whole{0, 0, 64};
        device->functions().vkCmdUpdateBuffer(commands, on_device.handle(), 0, 64, values.data());
        barrier(commands);
        device->functions().vkCmdCopyBuffer(commands, on_device.handle(), back.handle(), 1, &whole);
        barrier(commands);
    });
    EXPECT_EQ(read<std::uint32_t>(back, 16), values);
}

TEST_F(Buffers, CarryWhatTheHostUploads) {
    constexpr std::size_t count = 100'003;
    const Buffer up = buffer(count, MemoryUse::upload);
    const Buffer on_device = buffer(count, MemoryUse::device);
    const Buffer back = buffer(count, MemoryUse::readback);
    std::mt19937 random(1);
    std::vector<std::uint8_t> values(count);
    for (auto& value : values)
        value = static_cast<std::uint8_t>(random());
    std::memcpy(up.mapped(), values.data(), count);
    ASSERT_EQ(up.flush(), VK_SUCCESS);
    run([&](VkCommandBuffer commands) {
        const VkBufferCopy whole{0, 0, count};
        device->functions().vkCmdCopyBuffer(commands, up.handle(), on_device.handle(), 1, &whole);
        barrier(commands);
        device->functions().vkCmdCopyBuffer(commands, on_device.handle(), back.handle(), 1, &whole);
        barrier(commands);
    });
    EXPECT_EQ(read<std::uint8_t>(back, count), values);
}

// Made and freed in random order, on all three places: what one holds, no other has changed.
TEST_F(Buffers, DoNotOverlap) {
    struct Filled {
        Buffer buffer;
        Buffer back;
        std::uint32_t value;
    };
    std::mt19937 random(2);
    std::vector<Filled> all;
    for (std::uint32_t n = 0; n < 120; ++n) {
        const VkDeviceSize bytes = 4 * (1 + random() % 5000);
        all.push_back({buffer(bytes, n % 2 == 0 ? MemoryUse::device : MemoryUse::upload), buffer(bytes, MemoryUse::readback), n});
        if (n % 3 == 2)
            all.erase(all.begin() + static_cast<std::ptrdiff_t>(random() % all.size()));
    }
    run([&](VkCommandBuffer commands) {
        for (const Filled& filled : all) {
            device->functions().vkCmdFillBuffer(commands, filled.buffer.handle(), 0, VK_WHOLE_SIZE, filled.value);
            device->functions().vkCmdFillBuffer(commands, filled.back.handle(), 0, VK_WHOLE_SIZE, ~filled.value);
        }
    });
    for (const Filled& filled : all) {
        const std::size_t count = filled.back.bytes() / 4;
        ASSERT_EQ(read<std::uint32_t>(filled.back, count), std::vector<std::uint32_t>(count, ~filled.value));
    }
    run([&](VkCommandBuffer commands) {
        for (const Filled& filled : all) {
            const VkBufferCopy whole{0, 0, filled.buffer.bytes()};
            device->functions().vkCmdCopyBuffer(commands, filled.buffer.handle(), filled.back.handle(), 1, &whole);
        }
        barrier(commands);
    });
    for (const Filled& filled : all) {
        const std::size_t count = filled.back.bytes() / 4;
        ASSERT_EQ(read<std::uint32_t>(filled.back, count), std::vector<std::uint32_t>(count, filled.value));
    }
    EXPECT_GE(device->memory().taken(), device->memory().given());
    all.clear();
    EXPECT_EQ(device->memory().given(), 0u);
    EXPECT_EQ(device->memory().taken(), 0u);
}

TEST_F(Buffers, MoveAndLeaveNothingBehind) {
    Buffer first = buffer(256, MemoryUse::upload);
    const VkBuffer handle = first.handle();
    Buffer second = std::move(first);
    EXPECT_EQ(first.handle(), VkBuffer{VK_NULL_HANDLE});
    EXPECT_EQ(second.handle(), handle);
    second = buffer(512, MemoryUse::device); // frees what it held
    EXPECT_EQ(second.bytes(), 512u);
    second = {};
    EXPECT_EQ(device->memory().given(), 0u);
    EXPECT_EQ(device->memory().blocks(), 0);
}

} // namespace
} // namespace windrow::vulkan
