// Pipeline statistics of the colour pass: invocations of its stages, and the savings of the vertex cache.
//
// Not of the shadow's pass: it has no fragment stage, where Mesa 22.3's llvmpipe ends with a fault while it counts.
#pragma once

#include "../vulkan/frames.h"

namespace windrow::vegetation::render {

struct VertexCounts {
    std::uint64_t vertices = 0;    ///< that the draws named: instances times vertices
    std::uint64_t invocations = 0; ///< of the vertex stage
    std::uint64_t fragments = 0;   ///< invocations of the fragment stage
};

class VertexCounter {
  public:
    explicit VertexCounter(engine::Objects& objects);

    /// Whether the device has pipeline statistics; without them nothing is recorded or reported.
    [[nodiscard]] bool counts() const { return pool_ != VK_NULL_HANDLE; }
    /// Begins a frame, outside of a render pass; what was recorded for its slot before is done.
    void begin(VkCommandBuffer commands, int slot);
    /// Around the draws of the pass, within it.
    void enter(VkCommandBuffer commands);
    void leave(VkCommandBuffer commands);
    /// Of a slot's frame, which the host has waited for.
    [[nodiscard]] VertexCounts collect(int slot) const;

  private:
    VkDevice device_ = VK_NULL_HANDLE;
    VkQueryPool pool_ = VK_NULL_HANDLE;
    std::uint32_t query_ = 0;
};

} // namespace windrow::vegetation::render
