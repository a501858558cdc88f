#include "cli/device_report/compile_only.h"

#include <cstdint>
#include <cstdlib>
#include <string_view>

namespace windrow::cli {
namespace {

// Calls of Vulkan have no room for an object of ours.
PFN_vkGetInstanceProcAddr g_of_instance = nullptr;
PFN_vkGetDeviceProcAddr g_of_device = nullptr;

template <class Handle>
Handle no_object() {
    return reinterpret_cast<Handle>(std::uintptr_t{1});
}

void VKAPI_CALL memory_properties(VkPhysicalDevice, VkPhysicalDeviceMemoryProperties* properties) {
    *properties = {};
    properties->memoryHeapCount = properties->memoryTypeCount = 1;
    properties->memoryHeaps[0] = {.size = VkDeviceSize{1} << 40, .flags = VK_MEMORY_HEAP_DEVICE_LOCAL_BIT};
    properties->memoryTypes[0] = {.propertyFlags = VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT | VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT |
                                                   VK_MEMORY_PROPERTY_HOST_COHERENT_BIT | VK_MEMORY_PROPERTY_HOST_CACHED_BIT,
                                  .heapIndex = 0};
}

// Pages that nobody writes cost nothing.
VkResult VKAPI_CALL allocate(VkDevice, const VkMemoryAllocateInfo* info, const VkAllocationCallbacks*, VkDeviceMemory* memory) {
    void* const block = std::malloc(info->allocationSize);
    *memory = reinterpret_cast<VkDeviceMemory>(block);
    return block == nullptr ? VK_ERROR_OUT_OF_HOST_MEMORY : VK_SUCCESS;
}
void VKAPI_CALL release(VkDevice, VkDeviceMemory memory, const VkAllocationCallbacks*) {
    std::free(reinterpret_cast<void*>(memory));
}
VkResult VKAPI_CALL map(VkDevice, VkDeviceMemory memory, VkDeviceSize, VkDeviceSize, VkMemoryMapFlags, void** address) {
    *address = reinterpret_cast<void*>(memory);
    return VK_SUCCESS;
}
VkResult VKAPI_CALL make_visible(VkDevice, std::uint32_t, const VkMappedMemoryRange*) {
    return VK_SUCCESS;
}
void VKAPI_CALL buffer_requirements(VkDevice device, VkBuffer buffer, VkMemoryRequirements* requirements) {
    reinterpret_cast<PFN_vkGetBufferMemoryRequirements>(g_of_device(device, "vkGetBufferMemoryRequirements"))(device, buffer,
                                                                                                              requirements);
    requirements->memoryTypeBits = 1;
}
VkResult VKAPI_CALL create_image(VkDevice, const VkImageCreateInfo*, const VkAllocationCallbacks*, VkImage* image) {
    *image = no_object<VkImage>();
    return VK_SUCCESS;
}
void VKAPI_CALL destroy_image(VkDevice, VkImage, const VkAllocationCallbacks*) {}
void VKAPI_CALL image_requirements(VkDevice, VkImage, VkMemoryRequirements* requirements) {
    *requirements = {.size = 4096, .alignment = 4096, .memoryTypeBits = 1};
}
VkResult VKAPI_CALL bind_buffer(VkDevice, VkBuffer, VkDeviceMemory, VkDeviceSize) {
    return VK_SUCCESS;
}
VkResult VKAPI_CALL bind_image(VkDevice, VkImage, VkDeviceMemory, VkDeviceSize) {
    return VK_SUCCESS;
}
VkResult VKAPI_CALL create_view(VkDevice, const VkImageViewCreateInfo*, const VkAllocationCallbacks*, VkImageView* view) {
    *view = no_object<VkImageView>();
    return VK_SUCCESS;
}
void VKAPI_CALL destroy_view(VkDevice, VkImageView, const VkAllocationCallbacks*) {}
VkResult VKAPI_CALL create_pool(VkDevice, const VkDescriptorPoolCreateInfo*, const VkAllocationCallbacks*,
                                VkDescriptorPool* pool) {
    *pool = no_object<VkDescriptorPool>();
    return VK_SUCCESS;
}
void VKAPI_CALL destroy_pool(VkDevice, VkDescriptorPool, const VkAllocationCallbacks*) {}
VkResult VKAPI_CALL allocate_sets(VkDevice, const VkDescriptorSetAllocateInfo* info, VkDescriptorSet* sets) {
    for (std::uint32_t n = 0; n < info->descriptorSetCount; ++n)
        sets[n] = no_object<VkDescriptorSet>();
    return VK_SUCCESS;
}
void VKAPI_CALL update_sets(VkDevice, std::uint32_t, const VkWriteDescriptorSet*, std::uint32_t, const VkCopyDescriptorSet*) {}

PFN_vkVoidFunction VKAPI_CALL of_device(VkDevice device, const char* name) {
    struct Replaced {
        std::string_view name;
        PFN_vkVoidFunction call;
    };
    const auto replaced = [](std::string_view what, auto call) {
        return Replaced{what, reinterpret_cast<PFN_vkVoidFunction>(call)};
    };
    static const Replaced all[] = {replaced("vkAllocateMemory", &allocate),
                                   replaced("vkFreeMemory", &release),
                                   replaced("vkMapMemory", &map),
                                   replaced("vkFlushMappedMemoryRanges", &make_visible),
                                   replaced("vkInvalidateMappedMemoryRanges", &make_visible),
                                   replaced("vkGetBufferMemoryRequirements", &buffer_requirements),
                                   replaced("vkGetImageMemoryRequirements", &image_requirements),
                                   replaced("vkBindBufferMemory", &bind_buffer),
                                   replaced("vkBindImageMemory", &bind_image),
                                   replaced("vkCreateImage", &create_image),
                                   replaced("vkDestroyImage", &destroy_image),
                                   replaced("vkCreateImageView", &create_view),
                                   replaced("vkDestroyImageView", &destroy_view),
                                   replaced("vkCreateDescriptorPool", &create_pool),
                                   replaced("vkDestroyDescriptorPool", &destroy_pool),
                                   replaced("vkAllocateDescriptorSets", &allocate_sets),
                                   replaced("vkUpdateDescriptorSets", &update_sets)};
    for (const Replaced& one : all)
        if (one.name == name)
            return one.call;
    return g_of_device(device, name);
}

PFN_vkVoidFunction VKAPI_CALL of_instance(VkInstance instance, const char* name) {
    if (std::string_view(name) == "vkGetDeviceProcAddr")
        return reinterpret_cast<PFN_vkVoidFunction>(&of_device);
    if (std::string_view(name) == "vkGetPhysicalDeviceMemoryProperties")
        return reinterpret_cast<PFN_vkVoidFunction>(&memory_properties);
    return g_of_instance(instance, name);
}

} // namespace

vulkan::Host compile_only(const vulkan::Host& host) {
    g_of_instance = host.get_instance_proc_addr;
    g_of_device = reinterpret_cast<PFN_vkGetDeviceProcAddr>(host.get_instance_proc_addr(host.instance, "vkGetDeviceProcAddr"));
    vulkan::Host made = host;
    made.get_instance_proc_addr = &of_instance;
    return made;
}

} // namespace windrow::cli
