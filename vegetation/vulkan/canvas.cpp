#include "vegetation/vulkan/canvas.h"

#include "vegetation/vulkan/calls.h"

namespace windrow::vegetation::engine {

Canvas::Canvas(Objects& objects, VkExtent2D extent, VkFormat format, VkSampleCountFlagBits samples)
    : device_(objects.device()), extent_(extent), samples_(samples) {
    constexpr VkFormat depth_format = VK_FORMAT_D16_UNORM;
    constexpr VkImageUsageFlags drawn = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
    const Image depth = objects.image({.format = depth_format,
                                       .extent = extent,
                                       .samples = samples,
                                       .usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT,
                                       .aspect = VK_IMAGE_ASPECT_DEPTH_BIT});
    picture_ = objects.image({.format = format, .extent = extent, .usage = drawn | VK_IMAGE_USAGE_TRANSFER_SRC_BIT});
    pixels_ = objects.buffer(Use::readback, VkDeviceSize{4} * extent.width * extent.height, VK_BUFFER_USAGE_TRANSFER_DST_BIT);
    using Role = Attachment::Role;
    constexpr VkImageLayout copied = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
    std::vector<Attachment> attachments{
        {.format = format, .samples = samples, .view = picture_.view, .cleared = true, .end = copied},
        {.role = Role::depth,
         .format = depth_format,
         .samples = samples,
         .view = depth.view,
         .cleared = true,
         .kept = false,
         .end = VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL}};
    if (samples != VK_SAMPLE_COUNT_1_BIT) {
        const Image several = objects.image({.format = format, .extent = extent, .samples = samples, .usage = drawn});
        attachments[0].view = several.view;
        attachments[0].kept = false;
        attachments[0].end = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
        attachments.push_back({.role = Role::resolve, .format = format, .view = picture_.view, .end = copied});
    }
    pass_.emplace(objects, extent, attachments);
}

void Canvas::end(VkCommandBuffer commands) const {
    vkCmdEndRenderPass(commands);
    copy_to_host(commands, extent_, std::array{ImageCopy{picture_.image, pixels_.buffer}});
}

std::span<const std::byte> Canvas::pixels() const {
    return {static_cast<const std::byte*>(device_.read_back(pixels_)), static_cast<std::size_t>(pixels_.bytes)};
}

} // namespace windrow::vegetation::engine
