#include "gpu/image.h"

#include "fluid/core/message.h"
#include "gpu/device.h"
#include "gpu/functions.h"

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

// Whether the device exports such images, and has the call that makes a handle.
Result<void> check_export(const Device& device, VkFormat format, VkExternalMemoryHandleTypeFlagBits handle_type,
                          const std::string& what) {
    const VkPhysicalDeviceExternalImageFormatInfo external{
        .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_EXTERNAL_IMAGE_FORMAT_INFO, .pNext = nullptr, .handleType = handle_type};
    const VkPhysicalDeviceImageFormatInfo2 info{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_IMAGE_FORMAT_INFO_2,
                                                .pNext = &external,
                                                .format = format,
                                                .type = VK_IMAGE_TYPE_3D,
                                                .tiling = VK_IMAGE_TILING_OPTIMAL,
                                                .usage = k_image_usage,
                                                .flags = 0};
    VkExternalImageFormatProperties exports{};
    exports.sType = VK_STRUCTURE_TYPE_EXTERNAL_IMAGE_FORMAT_PROPERTIES;
    VkImageFormatProperties2 properties{};
    properties.sType = VK_STRUCTURE_TYPE_IMAGE_FORMAT_PROPERTIES_2;
    properties.pNext = &exports;
    const VkResult result =
        device.functions().vkGetPhysicalDeviceImageFormatProperties2(device.host().physical_device, &info, &properties);
    if (result != VK_SUCCESS ||
        (exports.externalMemoryProperties.externalMemoryFeatures & VK_EXTERNAL_MEMORY_FEATURE_EXPORTABLE_BIT) == 0)
        return Error{detail::message(what, " cannot be exported as VkExternalMemoryHandleTypeFlagBits ",
                                     static_cast<int>(handle_type),
                                     " on this device: set Settings::export_textures to another type, or leave it out.")};
    constexpr VkExternalMemoryHandleTypeFlags windows =
        VK_EXTERNAL_MEMORY_HANDLE_TYPE_OPAQUE_WIN32_BIT | VK_EXTERNAL_MEMORY_HANDLE_TYPE_OPAQUE_WIN32_KMT_BIT;
    const bool on_windows = (static_cast<VkExternalMemoryHandleTypeFlags>(handle_type) & windows) != 0;
    const char* const call = on_windows ? "vkGetMemoryWin32HandleKHR" : "vkGetMemoryFdKHR";
    if (device.functions().vkGetDeviceProcAddr(device.host().device, call) == nullptr)
        return Error{detail::message("the device has no ", call, ", which exports textures: make it with ",
                                     on_windows ? "VK_KHR_external_memory_win32." : "VK_KHR_external_memory_fd.")};
    return {};
}

} // namespace

Result<Image3D> Image3D::create(Device& device, VkExtent3D extent, VkFormat format, VkExternalMemoryHandleTypeFlagBits exported) {
    const std::string what = detail::message("a 3D image of ", extent.width, " x ", extent.height, " x ", extent.depth,
                                             " texels of VkFormat ", static_cast<int>(format));
    if (auto checked = check_image(device, extent, format, what); !checked)
        return checked.failure();
    const bool exports = exported != VkExternalMemoryHandleTypeFlagBits{};
    if (exports)
        if (auto checked = check_export(device, format, exported, what); !checked)
            return checked.failure();

    const Functions& functions = device.functions();
    const Host& host = device.host();
    Image3D image;
    const VkExternalMemoryImageCreateInfo external{.sType = VK_STRUCTURE_TYPE_EXTERNAL_MEMORY_IMAGE_CREATE_INFO,
                                                   .pNext = nullptr,
                                                   .handleTypes = static_cast<VkExternalMemoryHandleTypeFlags>(exported)};
    VkImageCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO;
    info.pNext = exports ? &external : nullptr;
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
    image.memory_bytes_ = requirements.size;
    auto piece = exports ? device.memory().allocate_exported(requirements, image.handle(), exported)
                         : device.memory().allocate(requirements, 0, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, false);
    if (!piece)
        return piece.failure().after(what + ": ");
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
