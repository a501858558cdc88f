// Map that a fragment stage draws over its whole, once a frame, for later passes to read with a filter.
#pragma once

#include "../vulkan/render_pass.h"

#include <cstdint>
#include <span>

namespace windrow::vegetation::render {

class DrawnMap {
  public:
    DrawnMap(engine::Objects& objects, VkFormat format, VkExtent2D extent);
    /// Of `layout`, whose set 0 is the frame's; the fragment stage gets `ndc` at location 0 as full_screen.vert hands it on.
    void make(engine::Objects& objects, VkPipelineLayout layout, std::span<const std::uint32_t> fragment);

    /// Outside of a render pass, with the layout's sets bound.
    void record(VkCommandBuffer commands) const;
    [[nodiscard]] VkImageView view() const { return image_.view; }
    /// Linear, clamped at the edges.
    [[nodiscard]] VkSampler sampler() const { return sampler_; }

  private:
    engine::Image image_{};
    VkSampler sampler_ = VK_NULL_HANDLE;
    engine::RenderPass pass_;
    VkPipeline pipeline_ = VK_NULL_HANDLE;
};

} // namespace windrow::vegetation::render
