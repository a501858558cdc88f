// Parameters that the host writes where the passes read them: nothing is copied by commands.
//
//   | area of slot 0 | area of slot 1 | ... | one block more |
//
// A recording puts its blocks into the area of its slot, one after another, so that those of recordings in flight stay as they are.
// What no longer fits goes to the last block, which the command buffer writes.
#pragma once

#include "gpu/buffer.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace windrow::vulkan {

/// Move-only. Blocks of at most `block` bytes: what a pass binds, from a dynamic offset on.
class HostBlocks {
  public:
    /// Empty.
    HostBlocks() = default;
    /// `area`: bytes of a slot, at least.
    [[nodiscard]] static Result<HostBlocks> create(Device& device, std::uint32_t slots, VkDeviceSize area, VkDeviceSize block);
    /// The recording of this slot begins; the earlier one is done.
    void begin(int slot) {
        next_ = area_ * static_cast<VkDeviceSize>(slot);
        end_ = next_ + area_;
    }
    /// Offset of a new block that holds these bytes; null: the area is full.
    [[nodiscard]] std::optional<std::uint32_t> put(std::span<const std::byte> bytes);
    /// Offset of the last block.
    [[nodiscard]] std::uint32_t last() const { return static_cast<std::uint32_t>(buffer_.bytes() - block_); }
    [[nodiscard]] VkDeviceSize block() const { return block_; }
    [[nodiscard]] const Buffer& buffer() const { return buffer_; }

  private:
    Buffer buffer_;
    VkDeviceSize area_ = 0, block_ = 0, alignment_ = 1;
    VkDeviceSize next_ = 0, end_ = 0;
};

} // namespace windrow::vulkan
