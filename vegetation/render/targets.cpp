#include "vegetation/render/targets.h"

#include <cstring>
#include <glm/gtc/packing.hpp>
#include <vulkan/vulkan.h>

namespace windrow::vegetation::render {
namespace {

constexpr VkFormat k_light = VK_FORMAT_R16G16B16A16_SFLOAT;
constexpr VkFormat k_motion = VK_FORMAT_R16G16_SFLOAT;
constexpr VkFormat k_picture = VK_FORMAT_R8G8B8A8_SRGB;
constexpr VkImageUsageFlags k_drawn = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
constexpr VkImageUsageFlags k_read = k_drawn | VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_SAMPLED_BIT;

PictureF from_halves(VkExtent2D extent, int channels, int stored, const void* bytes) {
    PictureF made(static_cast<int>(extent.width), static_cast<int>(extent.height), channels);
    const auto* from = static_cast<const std::uint16_t*>(bytes);
    const std::size_t pixels = std::size_t{extent.width} * extent.height;
    for (std::size_t pixel = 0; pixel < pixels; ++pixel)
        for (int channel = 0; channel < channels; ++channel)
            made.values[pixel * channels + channel] = glm::unpackHalf1x16(from[pixel * stored + channel]);
    return made;
}

} // namespace

VkFormat depth_format(const engine::Device& device) {
    VkFormatProperties properties{};
    vkGetPhysicalDeviceFormatProperties(device.physical, VK_FORMAT_D32_SFLOAT, &properties);
    const bool has = (properties.optimalTilingFeatures & VK_FORMAT_FEATURE_DEPTH_STENCIL_ATTACHMENT_BIT) != 0;
    return has ? VK_FORMAT_D32_SFLOAT : VK_FORMAT_X8_D24_UNORM_PACK32;
}

Targets::Targets(engine::Device& device, VkExtent2D extent, VkSampleCountFlagBits samples) : extent_(extent), samples_(samples) {
    const bool one = samples == VK_SAMPLE_COUNT_1_BIT;
    const VkImageUsageFlags drawn = one ? k_read : k_drawn | VK_IMAGE_USAGE_TRANSIENT_ATTACHMENT_BIT;
    const VkFormat depth = depth_format(device);
    light_ = device.make_image(k_light, extent, samples, drawn, VK_IMAGE_ASPECT_COLOR_BIT);
    motion_ = device.make_image(k_motion, extent, samples, drawn, VK_IMAGE_ASPECT_COLOR_BIT);
    depth_ = device.make_image(depth, extent, samples,
                               VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSIENT_ATTACHMENT_BIT,
                               VK_IMAGE_ASPECT_DEPTH_BIT);
    if (!one) {
        light_one_ = device.make_image(k_light, extent, VK_SAMPLE_COUNT_1_BIT, k_read, VK_IMAGE_ASPECT_COLOR_BIT);
        motion_one_ = device.make_image(k_motion, extent, VK_SAMPLE_COUNT_1_BIT, k_read, VK_IMAGE_ASPECT_COLOR_BIT);
    }
    picture_ = device.make_image(k_picture, extent, VK_SAMPLE_COUNT_1_BIT, k_drawn | VK_IMAGE_USAGE_TRANSFER_SRC_BIT,
                                 VK_IMAGE_ASPECT_COLOR_BIT);
    const VkDeviceSize pixels = VkDeviceSize{extent.width} * extent.height;
    light_bytes_ = device.make_buffer(8 * pixels, VK_BUFFER_USAGE_TRANSFER_DST_BIT);
    motion_bytes_ = device.make_buffer(4 * pixels, VK_BUFFER_USAGE_TRANSFER_DST_BIT);
    picture_bytes_ = device.make_buffer(4 * pixels, VK_BUFFER_USAGE_TRANSFER_DST_BIT);

    using Role = Attachment::Role;
    constexpr VkImageLayout sampled = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, copied = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
    std::vector<Attachment> attachments{
        {.role = Role::colour,
         .format = k_light,
         .samples = samples,
         .view = light_.view,
         .kept = one}, // the sky covers it whole
        {.role = Role::colour, .format = k_motion, .samples = samples, .view = motion_.view, .kept = one},
        {.role = Role::depth,
         .format = depth,
         .samples = samples,
         .view = depth_.view,
         .cleared = true,
         .kept = false,
         .end = VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL}};
    if (one) {
        attachments[0].end = sampled;
        attachments[1].end = copied;
    } else {
        attachments.push_back({.role = Role::resolve, .format = k_light, .view = light_one_.view, .end = sampled});
        attachments.push_back({.role = Role::resolve, .format = k_motion, .view = motion_one_.view, .end = copied});
    }
    scene_.emplace(device, extent, attachments);
    const Attachment picture{.role = Role::colour, .format = k_picture, .view = picture_.view, .end = copied};
    toned_.emplace(device, extent, std::span(&picture, 1));
}

void Targets::copy(VkCommandBuffer commands) const {
    // Light was left for the toning to read.
    VkImageMemoryBarrier turn{};
    turn.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER;
    turn.srcAccessMask = VK_ACCESS_SHADER_READ_BIT;
    turn.dstAccessMask = VK_ACCESS_TRANSFER_READ_BIT;
    turn.oldLayout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
    turn.newLayout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
    turn.srcQueueFamilyIndex = turn.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    turn.image = resolved_light().image;
    turn.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT, VK_PIPELINE_STAGE_TRANSFER_BIT, 0, 0, nullptr, 0,
                         nullptr, 1, &turn);
    VkBufferImageCopy region{};
    region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    region.imageExtent = {extent_.width, extent_.height, 1};
    constexpr VkImageLayout from = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
    vkCmdCopyImageToBuffer(commands, resolved_light().image, from, light_bytes_.buffer, 1, &region);
    vkCmdCopyImageToBuffer(commands, resolved_motion().image, from, motion_bytes_.buffer, 1, &region);
    vkCmdCopyImageToBuffer(commands, picture_.image, from, picture_bytes_.buffer, 1, &region);
    VkMemoryBarrier barrier{};
    barrier.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER;
    barrier.srcAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT;
    barrier.dstAccessMask = VK_ACCESS_HOST_READ_BIT;
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_PIPELINE_STAGE_HOST_BIT, 0, 1, &barrier, 0, nullptr, 0,
                         nullptr);
}

Picture8 Targets::picture() const {
    Picture8 made(static_cast<int>(extent_.width), static_cast<int>(extent_.height));
    const auto* from = static_cast<const std::uint8_t*>(picture_bytes_.mapped);
    for (std::size_t pixel = 0; pixel < made.values.size() / 3; ++pixel)
        std::memcpy(&made.values[3 * pixel], from + 4 * pixel, 3);
    return made;
}

PictureF Targets::light_picture() const {
    return from_halves(extent_, 3, 4, light_bytes_.mapped);
}

PictureF Targets::motion_picture() const {
    return from_halves(extent_, 2, 2, motion_bytes_.mapped);
}

} // namespace windrow::vegetation::render
