#include "fluid/vulkan/host_blocks.h"

#include "gpu/device.h"

#include <cstring>

namespace windrow::vulkan {
namespace {

VkDeviceSize rounded_up(VkDeviceSize bytes, VkDeviceSize alignment) {
    return (bytes + alignment - 1) / alignment * alignment;
}

} // namespace

Result<HostBlocks> HostBlocks::create(Device& device, std::uint32_t slots, VkDeviceSize area, VkDeviceSize block) {
    HostBlocks blocks;
    blocks.alignment_ = device.limits().minStorageBufferOffsetAlignment;
    blocks.area_ = rounded_up(area, blocks.alignment_);
    blocks.block_ = block;
    auto buffer = Buffer::create(device, slots * blocks.area_ + block, MemoryUse::upload);
    if (!buffer)
        return buffer.failure();
    blocks.buffer_ = *std::move(buffer);
    blocks.begin(0);
    return blocks;
}

std::optional<std::uint32_t> HostBlocks::put(std::span<const std::byte> bytes) {
    if (next_ + bytes.size() > end_)
        return std::nullopt;
    std::memcpy(buffer_.mapped() + next_, bytes.data(), bytes.size());
    const auto at = static_cast<std::uint32_t>(next_);
    next_ = rounded_up(next_ + bytes.size(), alignment_);
    return at;
}

} // namespace windrow::vulkan
