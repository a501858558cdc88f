#include "fluid/vulkan/host.h"

#include "fluid/core/message.h"

namespace windrow::vulkan {
namespace {

struct Queries {
    PFN_vkGetPhysicalDeviceProperties properties = nullptr;
    PFN_vkGetPhysicalDeviceFeatures features = nullptr;
    PFN_vkGetPhysicalDeviceImageFormatProperties image_format = nullptr;
};

template <class Function>
void load(Function& function, const char* name, VkInstance instance, PFN_vkGetInstanceProcAddr get_instance_proc_addr,
          detail::Reasons& reasons) {
    function = reinterpret_cast<Function>(get_instance_proc_addr(instance, name));
    if (function == nullptr)
        reasons.add("the loader lacks ", name, ": update it.");
}

void check_limit(const char* name, std::uint32_t has, std::uint32_t needs, detail::Reasons& reasons) {
    if (has < needs)
        reasons.add(name, " is ", has, " and ", needs, " are needed: use another device.");
}

void check_format(const Queries& queries, VkPhysicalDevice physical_device, VkFormat format, const char* name,
                  detail::Reasons& reasons) {
    VkImageFormatProperties properties{};
    const VkResult result =
        queries.image_format(physical_device, format, VK_IMAGE_TYPE_3D, VK_IMAGE_TILING_OPTIMAL, k_image_usage, 0, &properties);
    if (result != VK_SUCCESS)
        reasons.add(name, " has no 3D images that can be stored to, sampled and copied (", name_of(result),
                    "): use another device.");
}

} // namespace

Requirements requirements() {
    Requirements wanted;
    wanted.features.shaderStorageImageExtendedFormats = VK_TRUE;
    return wanted;
}

Result<void> check(VkInstance instance, VkPhysicalDevice physical_device, PFN_vkGetInstanceProcAddr get_instance_proc_addr) {
    detail::Reasons reasons;
    if (instance == VK_NULL_HANDLE)
        reasons.add("instance is null: give the VkInstance.");
    if (physical_device == VK_NULL_HANDLE)
        reasons.add("physical_device is null: give the VkPhysicalDevice.");
    if (get_instance_proc_addr == nullptr)
        reasons.add("get_instance_proc_addr is null: give the vkGetInstanceProcAddr of your loader.");
    if (!reasons.empty())
        return Error{reasons.take()};

    Queries queries;
    load(queries.properties, "vkGetPhysicalDeviceProperties", instance, get_instance_proc_addr, reasons);
    load(queries.features, "vkGetPhysicalDeviceFeatures", instance, get_instance_proc_addr, reasons);
    load(queries.image_format, "vkGetPhysicalDeviceImageFormatProperties", instance, get_instance_proc_addr, reasons);
    if (!reasons.empty())
        return Error{reasons.take()};

    const Requirements wanted = requirements();
    VkPhysicalDeviceProperties properties{};
    queries.properties(physical_device, &properties);
    if (properties.apiVersion < wanted.api_version)
        reasons.add("the device supports Vulkan ", VK_API_VERSION_MAJOR(properties.apiVersion), ".",
                    VK_API_VERSION_MINOR(properties.apiVersion), " and 1.2 is needed: update the driver.");
    const VkPhysicalDeviceLimits& limits = properties.limits;
    check_limit("maxComputeSharedMemorySize", limits.maxComputeSharedMemorySize, wanted.shared_bytes, reasons);
    check_limit("maxComputeWorkGroupInvocations", limits.maxComputeWorkGroupInvocations, wanted.invocations, reasons);
    check_limit("maxPerStageDescriptorStorageBuffers", limits.maxPerStageDescriptorStorageBuffers, wanted.storage_buffers,
                reasons);
    check_limit("maxPerStageDescriptorStorageImages", limits.maxPerStageDescriptorStorageImages, wanted.storage_images, reasons);

    VkPhysicalDeviceFeatures features{};
    queries.features(physical_device, &features);
    if (!features.shaderStorageImageExtendedFormats)
        reasons.add("the feature shaderStorageImageExtendedFormats is missing: use another device.");
    check_format(queries, physical_device, VK_FORMAT_R16_SFLOAT, "VK_FORMAT_R16_SFLOAT", reasons);
    check_format(queries, physical_device, VK_FORMAT_R32_SFLOAT, "VK_FORMAT_R32_SFLOAT", reasons);
    if (!reasons.empty())
        return Error{reasons.take()};
    return {};
}

} // namespace windrow::vulkan
