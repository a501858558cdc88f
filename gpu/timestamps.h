// Pool of timestamp queries, written by commands and read back when the host reports that these are done. Nothing here waits.
#pragma once

#include "fluid/api.h"
#include "gpu/handle.h"

#include <cstdint>
#include <span>

namespace windrow::vulkan {

class Device;

/// Move-only. One for each frame in flight.
class WINDROW_INTERNAL Timestamps {
  public:
    /// Empty.
    Timestamps() = default;
    /// `count` moments. Rejects a queue family that counts no time (timestampValidBits is 0).
    [[nodiscard]] static Result<Timestamps> create(Device& device, std::uint32_t count);

    /// Forgets all moments; before the first `write`, outside of a render pass. By a command, not from the host: Vulkan 1.2 has
    /// that only as a feature which the host's device need not have.
    void reset(VkCommandBuffer commands) const;
    /// The moment at which all commands so far are done.
    void write(VkCommandBuffer commands, std::uint32_t n) const;
    /// The first moments; false where one of them is not in, or the call fails, and then nothing is to be read from them.
    [[nodiscard]] bool read(std::span<std::uint64_t> moments) const;
    /// [us] Between two moments. A counter of few bits runs over: right up to one turn of it.
    [[nodiscard]] double microseconds(std::uint64_t from, std::uint64_t to) const;
    [[nodiscard]] std::uint32_t count() const { return count_; }

  private:
    const Functions* functions_ = nullptr;
    VkDevice device_ = VK_NULL_HANDLE;
    Handle<VkQueryPool, &Functions::vkDestroyQueryPool> pool_;
    std::uint32_t count_ = 0;
    std::uint64_t valid_ = 0;  ///< bits that count
    double microsecond_ = 0.0; ///< [us] of one count
};

} // namespace windrow::vulkan
