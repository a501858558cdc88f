#include "vegetation/vulkan/render_pass.h"

#include "vegetation/vulkan/calls.h"

namespace windrow::vegetation::engine {

RenderPass::RenderPass(Objects& objects, VkExtent2D extent, std::span<const Attachment> attachments)
    : extent_(extent), attachments_(static_cast<std::uint32_t>(attachments.size())), clear_(attachments.size()) {
    std::vector<VkAttachmentDescription> descriptions;
    std::vector<VkAttachmentReference> colours, resolves;
    std::vector<VkImageView> views;
    SharedKey key(SharedKind::render_pass);
    VkAttachmentReference depth{VK_ATTACHMENT_UNUSED, VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL};
    for (const Attachment& attachment : attachments) {
        const auto number = static_cast<std::uint32_t>(descriptions.size());
        VkAttachmentDescription made{};
        made.format = attachment.format;
        made.samples = attachment.samples;
        made.loadOp = attachment.cleared ? VK_ATTACHMENT_LOAD_OP_CLEAR : VK_ATTACHMENT_LOAD_OP_DONT_CARE;
        made.storeOp = attachment.kept ? VK_ATTACHMENT_STORE_OP_STORE : VK_ATTACHMENT_STORE_OP_DONT_CARE;
        made.stencilLoadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE;
        made.stencilStoreOp = VK_ATTACHMENT_STORE_OP_DONT_CARE;
        made.initialLayout = VK_IMAGE_LAYOUT_UNDEFINED;
        made.finalLayout = attachment.end;
        key.add(attachment.role).add(made.format).add(made.samples).add(made.loadOp).add(made.storeOp).add(made.finalLayout);
        descriptions.push_back(made);
        views.push_back(attachment.view);
        if (attachment.role == Attachment::Role::depth) {
            depth.attachment = number;
            clear_[number].depthStencil.depth = 1.0f;
        } else {
            auto& list = attachment.role == Attachment::Role::colour ? colours : resolves;
            list.push_back({number, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL});
        }
    }
    VkSubpassDescription subpass{};
    subpass.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS;
    subpass.colorAttachmentCount = static_cast<std::uint32_t>(colours.size());
    subpass.pColorAttachments = colours.data();
    subpass.pResolveAttachments = resolves.empty() ? nullptr : resolves.data();
    subpass.pDepthStencilAttachment = depth.attachment == VK_ATTACHMENT_UNUSED ? nullptr : &depth;
    constexpr VkPipelineStageFlags draws = VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT |
                                           VK_PIPELINE_STAGE_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_LATE_FRAGMENT_TESTS_BIT;
    constexpr VkPipelineStageFlags users =
        VK_PIPELINE_STAGE_VERTEX_SHADER_BIT | VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT | VK_PIPELINE_STAGE_TRANSFER_BIT;
    constexpr VkAccessFlags writes = VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT | VK_ACCESS_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT;
    constexpr VkAccessFlags reads = VK_ACCESS_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_DEPTH_STENCIL_ATTACHMENT_READ_BIT;
    const VkSubpassDependency dependencies[] = {
        {VK_SUBPASS_EXTERNAL, 0, draws | users, draws, writes, writes | reads, 0},
        {0, VK_SUBPASS_EXTERNAL, draws, users, writes, VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_TRANSFER_READ_BIT, 0}};
    VkRenderPassCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO;
    info.attachmentCount = attachments_;
    info.pAttachments = descriptions.data();
    info.subpassCount = 1;
    info.pSubpasses = &subpass;
    info.dependencyCount = 2;
    info.pDependencies = dependencies;
    render_pass_ = objects.shared(
        key, [&](Objects& owner) { return owner.make(vkCreateRenderPass, vkDestroyRenderPass, info, "vkCreateRenderPass"); });

    VkFramebufferCreateInfo frame_info{};
    frame_info.sType = VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO;
    frame_info.renderPass = render_pass_;
    frame_info.attachmentCount = attachments_;
    frame_info.pAttachments = views.data();
    frame_info.width = extent.width;
    frame_info.height = extent.height;
    frame_info.layers = 1;
    framebuffer_ = objects.make(vkCreateFramebuffer, vkDestroyFramebuffer, frame_info, "vkCreateFramebuffer");
}

void RenderPass::begin(VkCommandBuffer commands) const {
    VkRenderPassBeginInfo info{};
    info.sType = VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO;
    info.renderPass = render_pass_;
    info.framebuffer = framebuffer_;
    info.renderArea.extent = extent_;
    info.clearValueCount = attachments_;
    info.pClearValues = clear_.data();
    vkCmdBeginRenderPass(commands, &info, VK_SUBPASS_CONTENTS_INLINE);
    set_area(commands, {{0, 0}, extent_});
}

void copy_to_host(VkCommandBuffer commands, VkExtent2D extent, std::span<const ImageCopy> copies) {
    VkBufferImageCopy region{};
    region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    region.imageExtent = {extent.width, extent.height, 1};
    // The frame before may still copy to the same buffers.
    const VkMemoryBarrier again{VK_STRUCTURE_TYPE_MEMORY_BARRIER, nullptr, VK_ACCESS_TRANSFER_WRITE_BIT,
                                VK_ACCESS_TRANSFER_WRITE_BIT};
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_PIPELINE_STAGE_TRANSFER_BIT, 0, 1, &again, 0, nullptr, 0,
                         nullptr);
    for (const ImageCopy& copy : copies)
        vkCmdCopyImageToBuffer(commands, copy.from, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, copy.to, 1, &region);
    const VkMemoryBarrier seen{VK_STRUCTURE_TYPE_MEMORY_BARRIER, nullptr, VK_ACCESS_TRANSFER_WRITE_BIT, VK_ACCESS_HOST_READ_BIT};
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_PIPELINE_STAGE_HOST_BIT, 0, 1, &seen, 0, nullptr, 0,
                         nullptr);
}

void set_area(VkCommandBuffer commands, VkRect2D area) {
    const VkViewport viewport{static_cast<float>(area.offset.x),
                              static_cast<float>(area.offset.y),
                              static_cast<float>(area.extent.width),
                              static_cast<float>(area.extent.height),
                              0.0f,
                              1.0f};
    vkCmdSetViewport(commands, 0, 1, &viewport);
    vkCmdSetScissor(commands, 0, 1, &area);
}

} // namespace windrow::vegetation::engine
