#include "examples/engine/target.h"

#include <cstddef>
#include <fstream>
#include <vulkan/vulkan.h>

namespace windrow::vegetation::engine {
namespace {

// Formats that every device draws to.
constexpr VkFormat k_colour = VK_FORMAT_R8G8B8A8_SRGB;
constexpr VkFormat k_depth = VK_FORMAT_D16_UNORM;

VkAttachmentDescription attachment(VkFormat format, VkSampleCountFlagBits samples, VkAttachmentLoadOp load,
                                   VkAttachmentStoreOp store, VkImageLayout end) {
    VkAttachmentDescription made{};
    made.format = format;
    made.samples = samples;
    made.loadOp = load;
    made.storeOp = store;
    made.stencilLoadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE;
    made.stencilStoreOp = VK_ATTACHMENT_STORE_OP_DONT_CARE;
    made.initialLayout = VK_IMAGE_LAYOUT_UNDEFINED; // written whole
    made.finalLayout = end;
    return made;
}

} // namespace

Target::Target(Device& device, VkExtent2D extent) : extent_(extent) {
    colour_ = device.make_image(k_colour, extent, k_samples,
                                VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSIENT_ATTACHMENT_BIT,
                                VK_IMAGE_ASPECT_COLOR_BIT);
    depth_ = device.make_image(k_depth, extent, k_samples,
                               VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSIENT_ATTACHMENT_BIT,
                               VK_IMAGE_ASPECT_DEPTH_BIT);
    picture_ =
        device.make_image(k_colour, extent, VK_SAMPLE_COUNT_1_BIT,
                          VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT, VK_IMAGE_ASPECT_COLOR_BIT);
    pixels_ = device.make_buffer(VkDeviceSize{4} * extent.width * extent.height, VK_BUFFER_USAGE_TRANSFER_DST_BIT);
    make_render_pass(device);

    const VkImageView views[] = {colour_.view, depth_.view, picture_.view};
    VkFramebufferCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO;
    info.renderPass = render_pass_;
    info.attachmentCount = 3;
    info.pAttachments = views;
    info.width = extent.width;
    info.height = extent.height;
    info.layers = 1;
    must(vkCreateFramebuffer(device.device, &info, nullptr, &framebuffer_), "vkCreateFramebuffer");
    device.at_end([vulkan = device.device, made = framebuffer_] { vkDestroyFramebuffer(vulkan, made, nullptr); });
}

void Target::make_render_pass(Device& device) {
    const VkAttachmentDescription attachments[] = {
        attachment(k_colour, k_samples, VK_ATTACHMENT_LOAD_OP_DONT_CARE, VK_ATTACHMENT_STORE_OP_DONT_CARE,
                   VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL), // the sky covers it whole
        attachment(k_depth, k_samples, VK_ATTACHMENT_LOAD_OP_CLEAR, VK_ATTACHMENT_STORE_OP_DONT_CARE,
                   VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL),
        attachment(k_colour, VK_SAMPLE_COUNT_1_BIT, VK_ATTACHMENT_LOAD_OP_DONT_CARE, VK_ATTACHMENT_STORE_OP_STORE,
                   VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL)};
    const VkAttachmentReference colour{0, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
    const VkAttachmentReference depth{1, VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL};
    const VkAttachmentReference picture{2, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
    VkSubpassDescription subpass{};
    subpass.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS;
    subpass.colorAttachmentCount = 1;
    subpass.pColorAttachments = &colour;
    subpass.pResolveAttachments = &picture;
    subpass.pDepthStencilAttachment = &depth;
    // All frames draw to the same images: the one before has drawn, and its copy is done, before this one begins.
    constexpr VkPipelineStageFlags draws = VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT |
                                           VK_PIPELINE_STAGE_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_LATE_FRAGMENT_TESTS_BIT;
    constexpr VkAccessFlags writes = VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT | VK_ACCESS_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT;
    constexpr VkAccessFlags reads = VK_ACCESS_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_DEPTH_STENCIL_ATTACHMENT_READ_BIT;
    const VkSubpassDependency dependencies[] = {
        {VK_SUBPASS_EXTERNAL, 0, draws | VK_PIPELINE_STAGE_TRANSFER_BIT, draws, writes, writes | reads, 0},
        {0, VK_SUBPASS_EXTERNAL, draws, VK_PIPELINE_STAGE_TRANSFER_BIT, writes, VK_ACCESS_TRANSFER_READ_BIT, 0}};
    VkRenderPassCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO;
    info.attachmentCount = 3;
    info.pAttachments = attachments;
    info.subpassCount = 1;
    info.pSubpasses = &subpass;
    info.dependencyCount = 2;
    info.pDependencies = dependencies;
    must(vkCreateRenderPass(device.device, &info, nullptr, &render_pass_), "vkCreateRenderPass");
    device.at_end([vulkan = device.device, made = render_pass_] { vkDestroyRenderPass(vulkan, made, nullptr); });
}

void Target::begin(VkCommandBuffer commands) const {
    VkClearValue clear[3]{};
    clear[1].depthStencil.depth = 1.0f;
    VkRenderPassBeginInfo info{};
    info.sType = VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO;
    info.renderPass = render_pass_;
    info.framebuffer = framebuffer_;
    info.renderArea.extent = extent_;
    info.clearValueCount = 3;
    info.pClearValues = clear;
    vkCmdBeginRenderPass(commands, &info, VK_SUBPASS_CONTENTS_INLINE);
    const VkViewport viewport{0.0f, 0.0f, static_cast<float>(extent_.width), static_cast<float>(extent_.height), 0.0f, 1.0f};
    const VkRect2D scissor{{0, 0}, extent_};
    vkCmdSetViewport(commands, 0, 1, &viewport);
    vkCmdSetScissor(commands, 0, 1, &scissor);
}

void Target::end(VkCommandBuffer commands) const {
    vkCmdEndRenderPass(commands);
}

void Target::copy(VkCommandBuffer commands) const {
    VkBufferImageCopy region{};
    region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    region.imageExtent = {extent_.width, extent_.height, 1};
    vkCmdCopyImageToBuffer(commands, picture_.image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, pixels_.buffer, 1, &region);
    VkMemoryBarrier barrier{};
    barrier.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER;
    barrier.srcAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT;
    barrier.dstAccessMask = VK_ACCESS_HOST_READ_BIT;
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_PIPELINE_STAGE_HOST_BIT, 0, 1, &barrier, 0, nullptr, 0,
                         nullptr);
}

bool Target::write_ppm(const std::string& path) const {
    std::string bytes = "P6\n" + std::to_string(extent_.width) + " " + std::to_string(extent_.height) + "\n255\n";
    const auto* const from = static_cast<const char*>(pixels_.mapped);
    const std::size_t count = std::size_t{extent_.width} * extent_.height;
    bytes.reserve(bytes.size() + 3 * count);
    for (std::size_t pixel = 0; pixel < count; ++pixel)
        bytes.append(from + 4 * pixel, 3);
    std::ofstream file(path, std::ios::binary);
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    file.close();
    return file.good();
}

} // namespace windrow::vegetation::engine
