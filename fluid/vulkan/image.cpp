#include "fluid/vulkan/image.h"

#include "fluid/message.h"
#include "fluid/vulkan/device.h"
#include "fluid/vulkan/functions.h"

#include <algorithm>
#include <string>

namespace windrow::vulkan {
namespace {

// A software driver accepts an image of any size, including 0, without an error.
Result<void> check_image(const Device& device, VkExtent3D extent, VkFormat format, const std::string& what) {
    const VkDeviceSize largest = std::max({extent.width, extent.height, extent.depth});
    if (std::min({extent.width, extent.height, extent.depth}) == 0)
        return Error{what + " has no texel: give at least 1 on each axis."};
    if (largest > device.limits().maxImageDimension3D)
        return Error{detail::message(what, " is larger than images of this device (", device.limits().maxImageDimension3D,
                                     " on an axis, maxImageDimension3D): use a smaller box.")};
    VkImageFormatProperties properties{};
    const VkResult result = device.functions().vkGetPhysicalDeviceImageFormatProperties(
        device.host().physical_device, format, VK_IMAGE_TYPE_3D, VK_IMAGE_TILING_OPTIMAL, k_image_usage, 0, &properties);
    if (result != VK_SUCCESS)
        return call_error("vkGetPhysicalDeviceImageFormatProperties", what, result);
    if (extent.width > properties.maxExtent.width || extent.height > properties.maxExtent.height ||
        extent.depth > properties.maxExtent.depth)
        return Error{detail::message(what, " is larger than images of its format can be (", properties.maxExtent.width, " x ",
                                     properties.maxExtent.height, " x ", properties.maxExtent.depth, "): use a smaller box.")};
    return {};
}

} // namespace

Result<Image3D> Image3D::create(Device& device, VkExtent3D extent, VkFormat format) {
    const std::string what = detail::message("a 3D image of ", extent.width, " x ", extent.height, " x ", extent.depth,
                                             " texels of VkFormat ", static_cast<int>(format));
    if (auto checked = check_image(device, extent, format, what); !checked)
        return Error{checked.error()};

    const Functions& functions = device.functions();
    const Host& host = device.host();
    Image3D image;
    VkImageCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO;
    info.imageType = VK_IMAGE_TYPE_3D;
    info.format = format;
    info.extent = extent;
    info.mipLevels = 1;
    info.arrayLayers = 1;
    info.samples = VK_SAMPLE_COUNT_1_BIT;
    info.tiling = VK_IMAGE_TILING_OPTIMAL;
    info.usage = k_image_usage;
    device.share_with_readers(info);
    info.initialLayout = VK_IMAGE_LAYOUT_UNDEFINED;
    if (const VkResult result = make(functions, host, functions.vkCreateImage, info, image.image_); result != VK_SUCCESS)
        return call_error("vkCreateImage", what, result);

    VkMemoryRequirements requirements{};
    functions.vkGetImageMemoryRequirements(host.device, image.handle(), &requirements);
    auto piece = device.memory().allocate(requirements, 0, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, false);
    if (!piece)
        return Error{what + ": " + piece.error()};
    if (device.memory().measuring())
        return image;
    image.piece_ = OwnedPiece(device.memory(), *piece);
    if (const VkResult result = functions.vkBindImageMemory(host.device, image.handle(), piece->memory, piece->offset);
        result != VK_SUCCESS)
        return call_error("vkBindImageMemory", what, result);

    VkImageViewCreateInfo view{};
    view.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO;
    view.image = image.handle();
    view.viewType = VK_IMAGE_VIEW_TYPE_3D;
    view.format = format;
    view.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    if (const VkResult result = make(functions, host, functions.vkCreateImageView, view, image.view_); result != VK_SUCCESS)
        return call_error("vkCreateImageView", what, result);
    return image;
}

} // namespace windrow::vulkan
