// A storage buffer and its memory.
#pragma once

#include "fluid/api.h"
#include "gpu/handle.h"
#include "gpu/memory.h"

#include <cstddef>

namespace windrow::vulkan {

class Device;

/// Kind of a buffer's memory.
enum class MemoryUse {
    device,   ///< on the device; written by copies and shaders alone
    shared,   ///< the same, read by the host's shaders on Host::reader_queue_families too
    upload,   ///< host-visible and coherent, on the device where that exists: written by the host, read by the device
    readback, ///< host-visible and cached: written by the device, read by the host
};

/// Move-only. A storage buffer that copies can read and write; indirect dispatches too.
class WINDROW_INTERNAL Buffer {
  public:
    /// Empty.
    Buffer() = default;
    /// `bytes` from 1 to maxStorageBufferRange, since shaders see the whole. The error names the size, the call and its VkResult.
    [[nodiscard]] static Result<Buffer> create(Device& device, VkDeviceSize bytes, MemoryUse use,
                                               VkBufferUsageFlags more_usage = 0);
    [[nodiscard]] VkBuffer handle() const { return buffer_.get(); }
    [[nodiscard]] VkDeviceSize bytes() const { return bytes_; }
    /// Null for MemoryUse::device and MemoryUse::shared.
    [[nodiscard]] std::byte* mapped() const { return static_cast<std::byte*>(piece_.get().mapped); }
    /// Makes the device's writes visible to the host where memory is not coherent (readback), or the other way (upload). For
    /// buffers that are mapped.
    [[nodiscard]] VkResult invalidate() const;
    [[nodiscard]] VkResult flush() const;

  private:
    [[nodiscard]] VkMappedMemoryRange range() const;

    const Device* device_ = nullptr;
    OwnedPiece piece_; // above what is bound to it, which goes first
    Handle<VkBuffer, &Functions::vkDestroyBuffer> buffer_;
    VkDeviceSize bytes_ = 0;
    VkDeviceSize piece_bytes_ = 0;
};

} // namespace windrow::vulkan
