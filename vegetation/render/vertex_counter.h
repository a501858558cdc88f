// Pipeline statistics of the colour pass by drawable: invocations of its stages, and the savings of the vertex cache.
//
// Not of the shadow's pass: it has no fragment stage, where Mesa 22.3's llvmpipe ends with a fault while it counts.
#pragma once

#include "../vulkan/frames.h"

#include <array>
#include <vector>

namespace windrow::vegetation::render {

struct VertexCounts {
    std::uint64_t vertices = 0;    ///< that the draws named: instances times vertices
    std::uint64_t invocations = 0; ///< of the vertex stage
    std::uint64_t fragments = 0;   ///< invocations of the fragment stage
};

struct DrawnCounts {
    const char* name = "";
    VertexCounts counts{};
};

class VertexCounter {
  public:
    explicit VertexCounter(engine::Objects& objects);

    /// Whether the device has pipeline statistics; without them nothing is recorded or reported.
    [[nodiscard]] bool counts() const { return pool_ != VK_NULL_HANDLE; }
    /// Begins a frame, outside of a render pass; what was recorded for its slot before is done.
    void begin(VkCommandBuffer commands, int slot);
    /// Around the draws of one drawable, within the pass. The name must outlive the counter. At most 128 a frame: it counts none
    /// beyond.
    void enter(VkCommandBuffer commands, const char* name);
    void leave(VkCommandBuffer commands);
    /// Of a slot's frame, which the host has waited for, in the order of the draws.
    [[nodiscard]] std::vector<DrawnCounts> collect(int slot) const;

  private:
    static constexpr std::uint32_t k_most = 128;
    VkDevice device_ = VK_NULL_HANDLE;
    VkQueryPool pool_ = VK_NULL_HANDLE;
    int slot_ = 0;
    bool open_ = false;
    std::array<std::vector<const char*>, engine::k_frames_in_flight> names_{};
};

/// Of all drawables together.
[[nodiscard]] VertexCounts sum_of(const std::vector<DrawnCounts>& drawn);

} // namespace windrow::vegetation::render
