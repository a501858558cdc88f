#include "gpu/buffer.h"

#include "fluid/core/message.h"
#include "gpu/device.h"
#include "gpu/functions.h"

#include <cassert>

namespace windrow::vulkan {
namespace {

struct Properties {
    VkMemoryPropertyFlags wanted = 0;
    VkMemoryPropertyFlags preferred = 0;
};

Properties properties_of(MemoryUse use) {
    switch (use) {
    case MemoryUse::upload:
        return {VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT};
    case MemoryUse::readback:
        return {VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT, VK_MEMORY_PROPERTY_HOST_CACHED_BIT};
    case MemoryUse::device:
    case MemoryUse::shared:
        break;
    }
    return {0, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT};
}

} // namespace

Result<Buffer> Buffer::create(Device& device, VkDeviceSize bytes, MemoryUse use, VkBufferUsageFlags more_usage) {
    const std::string what = detail::message("a buffer of ", bytes, " bytes");
    if (bytes == 0)
        return Error{"a buffer has 0 bytes: give at least 1."};
    if (bytes > device.limits().maxStorageBufferRange)
        return Error{detail::message(what, " is larger than shaders of this device can see (",
                                     device.limits().maxStorageBufferRange, ", maxStorageBufferRange): use a smaller box.")};
    if ((more_usage & VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT) != 0 && bytes > device.limits().maxUniformBufferRange)
        return Error{detail::message(what, " is larger than a uniform block of this device (",
                                     device.limits().maxUniformBufferRange, ", maxUniformBufferRange): use a smaller one.")};

    const Functions& functions = device.functions();
    const Host& host = device.host();
    Buffer buffer;
    buffer.device_ = &device;
    buffer.bytes_ = bytes;
    VkBufferCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
    info.size = bytes;
    info.usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT |
                 VK_BUFFER_USAGE_TRANSFER_DST_BIT | more_usage;
    if (use == MemoryUse::shared)
        device.share_with_readers(info);
    if (const VkResult result = make(functions, host, functions.vkCreateBuffer, info, buffer.buffer_); result != VK_SUCCESS)
        return call_error("vkCreateBuffer", what, result);

    VkMemoryRequirements requirements{};
    functions.vkGetBufferMemoryRequirements(host.device, buffer.handle(), &requirements);
    const Properties properties = properties_of(use);
    auto piece = device.memory().allocate(requirements, properties.wanted, properties.preferred, true);
    if (!piece)
        return piece.failure().after(what + ": ");
    buffer.piece_ = OwnedPiece(device.memory(), *piece);
    if (device.memory().measuring())
        return buffer;
    const VkDeviceSize atom = device.limits().nonCoherentAtomSize;
    buffer.piece_bytes_ = (requirements.size + atom - 1) / atom * atom;
    if (const VkResult result = functions.vkBindBufferMemory(host.device, buffer.handle(), piece->memory, piece->offset);
        result != VK_SUCCESS)
        return call_error("vkBindBufferMemory", what, result);
    return buffer;
}

// The whole allocation in whole atoms, as aligned by Memory.
VkMappedMemoryRange Buffer::range() const {
    assert(mapped() != nullptr);
    const MemoryPiece& piece = piece_.get();
    return {.sType = VK_STRUCTURE_TYPE_MAPPED_MEMORY_RANGE,
            .pNext = nullptr,
            .memory = piece.memory,
            .offset = piece.offset,
            .size = piece_bytes_};
}

// Also called for coherent memory, where the driver does nothing.
VkResult Buffer::invalidate() const {
    const VkMappedMemoryRange whole = range();
    return device_->functions().vkInvalidateMappedMemoryRanges(device_->host().device, 1, &whole);
}

VkResult Buffer::flush() const {
    const VkMappedMemoryRange whole = range();
    return device_->functions().vkFlushMappedMemoryRanges(device_->host().device, 1, &whole);
}

} // namespace windrow::vulkan
