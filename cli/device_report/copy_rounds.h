// A compute pass that copies from one buffer to another over and over: for launches, and for the bandwidth of caches and memory.
#pragma once

#include "gpu/device.h"

namespace windrow::cli {

/// Move-only.
class CopyRounds {
  public:
    /// `bytes` of both buffers together, a power of two from 64.
    [[nodiscard]] static Result<CopyRounds> create(vulkan::Device& device, VkDeviceSize bytes);
    void fill(VkCommandBuffer commands) const;
    /// For `dispatch`: bound once for many.
    void bind(VkCommandBuffer commands) const;
    /// A work group that does nothing.
    void launch(VkCommandBuffer commands) const;
    /// Indirect, of no work groups.
    void launch_nothing(VkCommandBuffer commands) const;
    /// All threads of a large device, until `bytes` were read and as many written, rounded up.
    void copy(VkCommandBuffer commands, VkDeviceSize bytes) const;
    /// [bytes] That `copy` reads.
    [[nodiscard]] static VkDeviceSize copied(VkDeviceSize bytes);
    /// What compute and transfer commands wrote is done.
    void barrier(VkCommandBuffer commands) const;
    /// `bytes` from `at` on, by a transfer.
    void transfer(VkCommandBuffer commands, VkDeviceSize at, VkDeviceSize bytes) const;

  private:
    void push(VkCommandBuffer commands, std::uint32_t count, std::uint32_t rounds) const;

    const vulkan::Functions* functions_ = nullptr;
    vulkan::Buffer from_, to_, nothing_; ///< nothing_: an indirect dispatch
    vulkan::Pipeline pipeline_;
    vulkan::Sets sets_;
};

} // namespace windrow::cli
