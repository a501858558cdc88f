#include "vegetation/vulkan/device.h"

#include "fluid/vulkan/host.h"

#include <cstdio>
#include <cstdlib>
#include <optional>
#include <vulkan/vulkan.h>

namespace windrow::vegetation::engine {
namespace {

std::vector<VkPhysicalDevice> physical_devices(VkInstance instance) {
    std::uint32_t count = 0;
    must(vkEnumeratePhysicalDevices(instance, &count, nullptr), "vkEnumeratePhysicalDevices");
    std::vector<VkPhysicalDevice> found(count);
    must(vkEnumeratePhysicalDevices(instance, &count, found.data()), "vkEnumeratePhysicalDevices");
    return found;
}

VkPhysicalDeviceProperties properties_of(VkPhysicalDevice physical) {
    VkPhysicalDeviceProperties properties{};
    vkGetPhysicalDeviceProperties(physical, &properties);
    return properties;
}

// A family of queues that draw and compute.
std::optional<std::uint32_t> family_of(VkPhysicalDevice physical) {
    std::uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, families.data());
    constexpr VkQueueFlags both = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
    for (std::uint32_t family = 0; family < count; ++family)
        if ((families[family].queueFlags & both) == both)
            return family;
    return std::nullopt;
}

int rank(VkPhysicalDeviceType type) {
    return type == VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU ? 2 : type == VK_PHYSICAL_DEVICE_TYPE_CPU ? 0 : 1;
}

} // namespace

void give_up(const std::string& sentence, int code) {
    std::fprintf(stderr, "%s\n", sentence.c_str());
    std::exit(code);
}

void must(VkResult result, const char* call) {
    if (result != VK_SUCCESS)
        give_up(std::string(call) + " failed: " + windrow::vulkan::name_of(result), 1);
}

Device::Device(std::uint32_t api_version, const VkPhysicalDeviceFeatures& features, const Judge& judge) {
    VkApplicationInfo application{};
    application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
    application.pApplicationName = "windrow example";
    application.apiVersion = api_version;
    VkInstanceCreateInfo instance_info{};
    instance_info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
    instance_info.pApplicationInfo = &application;
    const VkResult made = vkCreateInstance(&instance_info, nullptr, &instance);
    if (made == VK_ERROR_INCOMPATIBLE_DRIVER)
        give_up("No Vulkan driver is installed: install your GPU's, or a software one (Debian: mesa-vulkan-drivers).", 3);
    must(made, "vkCreateInstance");

    std::string objections;
    int best = -1;
    for (const VkPhysicalDevice candidate : physical_devices(instance)) {
        const VkPhysicalDeviceProperties properties = properties_of(candidate);
        const auto has = family_of(candidate);
        const std::string objection = has ? judge(instance, candidate) : "none of its queues draws and computes.";
        if (!objection.empty()) {
            objections += std::string("\n") + properties.deviceName + ": " + objection;
        } else if (rank(properties.deviceType) > best) {
            best = rank(properties.deviceType);
            physical = candidate;
            family = *has;
            name = properties.deviceName;
        }
    }
    if (physical == VK_NULL_HANDLE)
        give_up("No Vulkan device will do." + objections, 3);

    const float priority = 1.0f;
    VkDeviceQueueCreateInfo queue_info{};
    queue_info.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
    queue_info.queueFamilyIndex = family;
    queue_info.queueCount = 1;
    queue_info.pQueuePriorities = &priority;
    VkDeviceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queue_info;
    VkPhysicalDeviceFeatures has{}, wanted = features;
    vkGetPhysicalDeviceFeatures(physical, &has);
    wanted.pipelineStatisticsQuery = has.pipelineStatisticsQuery;
    counts_vertices = has.pipelineStatisticsQuery == VK_TRUE;
    info.pEnabledFeatures = &wanted;
    must(vkCreateDevice(physical, &info, nullptr, &device), "vkCreateDevice");
    vkGetDeviceQueue(device, family, 0, &queue);
}

Device::~Device() {
    if (device != VK_NULL_HANDLE) {
        vkDeviceWaitIdle(device);
        for (auto last = destroy_.rbegin(); last != destroy_.rend(); ++last)
            (*last)();
        vkDestroyDevice(device, nullptr);
    }
    if (instance != VK_NULL_HANDLE)
        vkDestroyInstance(instance, nullptr);
}

VkDeviceMemory Device::allocate(const VkMemoryRequirements& needs, VkMemoryPropertyFlags wanted) {
    VkPhysicalDeviceMemoryProperties has{};
    vkGetPhysicalDeviceMemoryProperties(physical, &has);
    VkMemoryAllocateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
    info.allocationSize = needs.size;
    info.memoryTypeIndex = has.memoryTypeCount;
    for (std::uint32_t type = has.memoryTypeCount; type-- > 0;)
        if ((needs.memoryTypeBits >> type & 1u) != 0 && (has.memoryTypes[type].propertyFlags & wanted) == wanted)
            info.memoryTypeIndex = type;
    if (info.memoryTypeIndex == has.memoryTypeCount)
        give_up("The device has no memory of the kind that is needed.", 3);
    VkDeviceMemory memory = VK_NULL_HANDLE;
    must(vkAllocateMemory(device, &info, nullptr, &memory), "vkAllocateMemory");
    at_end([this, memory] { vkFreeMemory(device, memory, nullptr); });
    memory_bytes_ += needs.size;
    return memory;
}

Buffer Device::make_buffer(VkDeviceSize bytes, VkBufferUsageFlags usage) {
    Buffer made;
    VkBufferCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
    info.size = bytes;
    info.usage = usage;
    must(vkCreateBuffer(device, &info, nullptr, &made.buffer), "vkCreateBuffer");
    at_end([this, buffer = made.buffer] { vkDestroyBuffer(device, buffer, nullptr); });
    VkMemoryRequirements needs{};
    vkGetBufferMemoryRequirements(device, made.buffer, &needs);
    const VkDeviceMemory memory = allocate(needs, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT);
    must(vkBindBufferMemory(device, made.buffer, memory, 0), "vkBindBufferMemory");
    must(vkMapMemory(device, memory, 0, VK_WHOLE_SIZE, 0, &made.mapped), "vkMapMemory");
    return made;
}

Image Device::make_image(VkFormat format, VkExtent2D extent, VkSampleCountFlagBits samples, VkImageUsageFlags usage,
                         VkImageAspectFlags aspect) {
    Image made;
    VkImageCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO;
    info.imageType = VK_IMAGE_TYPE_2D;
    info.format = format;
    info.extent = {extent.width, extent.height, 1};
    info.mipLevels = 1;
    info.arrayLayers = 1;
    info.samples = samples;
    info.tiling = VK_IMAGE_TILING_OPTIMAL;
    info.usage = usage;
    must(vkCreateImage(device, &info, nullptr, &made.image), "vkCreateImage");
    at_end([this, image = made.image] { vkDestroyImage(device, image, nullptr); });
    VkMemoryRequirements needs{};
    vkGetImageMemoryRequirements(device, made.image, &needs);
    must(vkBindImageMemory(device, made.image, allocate(needs, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT), 0), "vkBindImageMemory");
    VkImageViewCreateInfo view_info{};
    view_info.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO;
    view_info.image = made.image;
    view_info.viewType = VK_IMAGE_VIEW_TYPE_2D;
    view_info.format = format;
    view_info.subresourceRange = {aspect, 0, 1, 0, 1};
    must(vkCreateImageView(device, &view_info, nullptr, &made.view), "vkCreateImageView");
    at_end([this, view = made.view] { vkDestroyImageView(device, view, nullptr); });
    return made;
}

} // namespace windrow::vegetation::engine
