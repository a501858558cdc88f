// Which memory a buffer is in, by what it is for.
#pragma once

#include "gpu/memory.h"
#include "vegetation/vulkan/device.h"

namespace windrow::vegetation::engine {

/// Blocks of device memory, cut into pieces. A GPU has memory of its own, which the host may see in whole (ReBAR), through a
/// window of 256 MiB, or not at all; a software device has one type for all.
class BufferMemory {
  public:
    /// `staged`: as if the host saw no memory of the device's own, for tests.
    BufferMemory(const vulkan::Host& host, const vulkan::Functions& functions, bool staged);

    /// A piece, mapped for uses that the host writes or reads in place. The error is a sentence.
    [[nodiscard]] Result<vulkan::MemoryPiece> allocate(const VkMemoryRequirements& needs, Use use);
    [[nodiscard]] Result<vulkan::MemoryPiece> allocate_image(const VkMemoryRequirements& needs);
    void release(const vulkan::MemoryPiece& piece) { memory_.release(piece); }
    /// Whether the host writes a buffer of this use in place; else it writes a staging buffer, and the device copies.
    [[nodiscard]] bool in_place(Use use) const;

    /// [bytes] Given out, and taken from the driver for it.
    [[nodiscard]] VkDeviceSize given() const { return memory_.given(); }
    [[nodiscard]] VkDeviceSize taken() const { return memory_.taken(); }

  private:
    vulkan::Memory memory_;
    bool staged_ = false;
};

} // namespace windrow::vegetation::engine
