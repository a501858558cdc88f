#include "vegetation/render/targets.h"

#include "vegetation/vulkan/calls.h"

#include <array>
#include <cstring>
#include <glm/gtc/packing.hpp>

namespace windrow::vegetation::render {
namespace {

constexpr VkFormat k_light = VK_FORMAT_R16G16B16A16_SFLOAT, k_compact_light = VK_FORMAT_B10G11R11_UFLOAT_PACK32;
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

VkFormat light_format(const engine::Device& device, int bytes) {
    constexpr VkFormatFeatureFlags drawn =
        VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BIT | VK_FORMAT_FEATURE_SAMPLED_IMAGE_FILTER_LINEAR_BIT;
    VkFormatProperties properties{};
    vkGetPhysicalDeviceFormatProperties(device.host().physical_device, k_compact_light, &properties);
    return bytes == 4 && (properties.optimalTilingFeatures & drawn) == drawn ? k_compact_light : k_light;
}

} // namespace

bool draws_with(const engine::Device& device, VkSampleCountFlagBits samples) {
    const VkPhysicalDeviceLimits& limits = device.limits();
    return (limits.framebufferColorSampleCounts & limits.framebufferDepthSampleCounts & limits.sampledImageDepthSampleCounts &
            samples) != 0;
}

VkFormat depth_format(const engine::Device& device) {
    VkFormatProperties properties{};
    vkGetPhysicalDeviceFormatProperties(device.host().physical_device, VK_FORMAT_D32_SFLOAT, &properties);
    const bool has = (properties.optimalTilingFeatures & VK_FORMAT_FEATURE_DEPTH_STENCIL_ATTACHMENT_BIT) != 0;
    return has ? VK_FORMAT_D32_SFLOAT : VK_FORMAT_X8_D24_UNORM_PACK32;
}

Targets::Targets(engine::Objects& objects, const TargetSettings& settings)
    : device_(objects.device()), extent_(settings.extent), samples_(settings.samples),
      light_format_(light_format(device_, settings.light_bytes)) {
    const VkExtent2D extent = extent_;
    const VkSampleCountFlagBits samples = samples_;
    const bool one = samples == VK_SAMPLE_COUNT_1_BIT;
    const VkImageUsageFlags drawn = one ? k_read : k_drawn | VK_IMAGE_USAGE_TRANSIENT_ATTACHMENT_BIT;
    const VkFormat depth = depth_format(device_);
    const VkImageUsageFlags depth_more = settings.blurred ? VK_IMAGE_USAGE_SAMPLED_BIT : VK_IMAGE_USAGE_TRANSIENT_ATTACHMENT_BIT;
    light_ = objects.image({.format = light_format_, .extent = extent, .samples = samples, .usage = drawn});
    motion_ = objects.image({.format = k_motion, .extent = extent, .samples = samples, .usage = drawn});
    depth_ = objects.image({.format = depth,
                            .extent = extent,
                            .samples = samples,
                            .usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | depth_more,
                            .aspect = VK_IMAGE_ASPECT_DEPTH_BIT});
    if (!one) {
        light_one_ =
            objects.image({.format = light_format_, .extent = extent, .samples = VK_SAMPLE_COUNT_1_BIT, .usage = k_read});
        motion_one_ = objects.image({.format = k_motion, .extent = extent, .samples = VK_SAMPLE_COUNT_1_BIT, .usage = k_read});
    }
    picture_ = objects.image({.format = k_picture, .extent = extent, .samples = VK_SAMPLE_COUNT_1_BIT, .usage = k_read});
    const VkDeviceSize pixels = VkDeviceSize{extent.width} * extent.height;
    light_bytes_ = objects.buffer(engine::Use::readback, 8 * pixels, VK_BUFFER_USAGE_TRANSFER_DST_BIT);
    motion_bytes_ = objects.buffer(engine::Use::readback, 4 * pixels, VK_BUFFER_USAGE_TRANSFER_DST_BIT);
    picture_bytes_ = objects.buffer(engine::Use::readback, 4 * pixels, VK_BUFFER_USAGE_TRANSFER_DST_BIT);

    using Role = engine::Attachment::Role;
    constexpr VkImageLayout sampled = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL, copied = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
    std::vector<engine::Attachment> attachments{
        {.role = Role::colour,
         .format = light_format_,
         .samples = samples,
         .view = light_.view,
         .kept = one}, // the sky covers it whole
        {.role = Role::colour, .format = k_motion, .samples = samples, .view = motion_.view, .kept = one},
        {.role = Role::depth,
         .format = depth,
         .samples = samples,
         .view = depth_.view,
         .cleared = true,
         .kept = settings.blurred,
         .end = settings.blurred ? VK_IMAGE_LAYOUT_DEPTH_STENCIL_READ_ONLY_OPTIMAL
                                 : VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL}};
    const VkImageLayout motion_end = settings.blurred ? sampled : copied;
    if (one) {
        attachments[0].end = sampled;
        attachments[1].end = motion_end;
    } else {
        attachments.push_back({.role = Role::resolve, .format = light_format_, .view = light_one_.view, .end = sampled});
        attachments.push_back({.role = Role::resolve, .format = k_motion, .view = motion_one_.view, .end = motion_end});
    }
    scene_.emplace(objects, extent, attachments);
    if (settings.blurred) {
        blurred_light_ = objects.image({.format = light_format_, .extent = extent, .usage = k_read});
        const engine::Attachment light{.format = light_format_, .view = blurred_light_.view, .end = sampled};
        blurred_.emplace(objects, extent, std::span(&light, 1));
    }
    const engine::Attachment picture{.role = Role::colour, .format = k_picture, .view = picture_.view, .end = copied};
    toned_.emplace(objects, extent, std::span(&picture, 1));
}

void Targets::copy(VkCommandBuffer commands) const {
    // Light was left for the toning to read, motion for the blur if there is one.
    VkImageMemoryBarrier turn{};
    turn.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER;
    turn.srcAccessMask = VK_ACCESS_SHADER_READ_BIT;
    turn.dstAccessMask = VK_ACCESS_TRANSFER_READ_BIT;
    turn.oldLayout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
    turn.newLayout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL;
    turn.srcQueueFamilyIndex = turn.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    turn.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    std::array turns{turn, turn};
    turns[0].image = shown_light().image;
    turns[1].image = resolved_motion().image;
    vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT, VK_PIPELINE_STAGE_TRANSFER_BIT, 0, 0, nullptr, 0,
                         nullptr, blurred_ ? 2 : 1, turns.data());
    engine::copy_to_host(commands, extent_,
                         std::array{engine::ImageCopy{shown_light().image, light_bytes_.buffer},
                                    engine::ImageCopy{resolved_motion().image, motion_bytes_.buffer},
                                    engine::ImageCopy{picture_.image, picture_bytes_.buffer}});
}

Picture8 Targets::picture() const {
    Picture8 made(static_cast<int>(extent_.width), static_cast<int>(extent_.height));
    const auto* from = static_cast<const std::uint8_t*>(device_.read_back(picture_bytes_));
    for (std::size_t pixel = 0; pixel < made.values.size() / 3; ++pixel)
        std::memcpy(&made.values[3 * pixel], from + 4 * pixel, 3);
    return made;
}

PictureF Targets::light_picture() const {
    const void* const bytes = device_.read_back(light_bytes_);
    if (light_format_ == k_light)
        return from_halves(extent_, 3, 4, bytes);
    PictureF made(static_cast<int>(extent_.width), static_cast<int>(extent_.height), 3);
    const auto* packed = static_cast<const std::uint32_t*>(bytes);
    for (std::size_t pixel = 0; pixel < made.values.size() / 3; ++pixel) {
        const glm::vec3 light = glm::unpackF2x11_1x10(packed[pixel]);
        std::memcpy(&made.values[3 * pixel], &light, sizeof light);
    }
    return made;
}

PictureF Targets::motion_picture() const {
    return from_halves(extent_, 2, 2, device_.read_back(motion_bytes_));
}

} // namespace windrow::vegetation::render
