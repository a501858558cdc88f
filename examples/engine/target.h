// What is drawn to: a picture with four samples a pixel and depth, offscreen, and its way into a file.
#pragma once

#include "vegetation/vulkan/device.h"

#include <string>

namespace windrow::vegetation::engine {

inline constexpr VkSampleCountFlagBits k_samples = VK_SAMPLE_COUNT_4_BIT; // every device has 1 and 4

class Target {
  public:
    Target(Device& device, VkExtent2D extent);

    [[nodiscard]] VkRenderPass render_pass() const { return render_pass_; }
    [[nodiscard]] VkExtent2D extent() const { return extent_; }
    /// Begins the render pass, with viewport and scissor over the whole.
    void begin(VkCommandBuffer commands) const;
    void end(VkCommandBuffer commands) const;
    /// After `end`: copies the picture to the host.
    void copy(VkCommandBuffer commands) const;
    /// After the copy is done: writes it as a binary PPM. False where the file cannot be written.
    [[nodiscard]] bool write_ppm(const std::string& path) const;

  private:
    void make_render_pass(Device& device);

    VkExtent2D extent_{};
    Image colour_{}, depth_{}, picture_{};
    Buffer pixels_{};
    VkRenderPass render_pass_ = VK_NULL_HANDLE;
    VkFramebuffer framebuffer_ = VK_NULL_HANDLE;
};

} // namespace windrow::vegetation::engine
