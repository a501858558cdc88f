// A render pass of one subpass and its framebuffer, from a list of attachments.
#pragma once

#include "objects.h"

namespace windrow::vegetation::engine {

struct Attachment {
    enum class Role { colour, depth, resolve };
    Role role = Role::colour; ///< `resolve` takes the colours in their order
    VkFormat format = VK_FORMAT_UNDEFINED;
    VkSampleCountFlagBits samples = VK_SAMPLE_COUNT_1_BIT;
    VkImageView view = VK_NULL_HANDLE;
    bool cleared = false; ///< to 0, or depth 1; else what was there does not matter
    bool kept = true;     ///< what was drawn is asked for later
    VkImageLayout end = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
};

class RenderPass {
  public:
    /// What it draws to was used by the frame before and is used after it by shaders and transfers: it waits for both.
    RenderPass(Objects& objects, VkExtent2D extent, std::span<const Attachment> attachments);

    [[nodiscard]] VkRenderPass handle() const { return render_pass_; }
    /// Begins it, with viewport and scissor over the whole.
    void begin(VkCommandBuffer commands) const;

  private:
    VkExtent2D extent_{};
    std::uint32_t attachments_ = 0;
    std::vector<VkClearValue> clear_{};
    VkRenderPass render_pass_ = VK_NULL_HANDLE;
    VkFramebuffer framebuffer_ = VK_NULL_HANDLE;
};

struct ImageCopy {
    VkImage from = VK_NULL_HANDLE;
    VkBuffer to = VK_NULL_HANDLE;
};
/// Copies colour images in VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL to read-backs, which the host sees once the frame is done.
void copy_to_host(VkCommandBuffer commands, VkExtent2D extent, std::span<const ImageCopy> copies);
/// Viewport and scissor.
void set_area(VkCommandBuffer commands, VkRect2D area);

} // namespace windrow::vegetation::engine
