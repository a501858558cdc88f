#include "vegetation/grass/device_objects.h"

#include <string>
#include <vulkan/vulkan.h>

namespace windrow::vegetation::grass {
namespace {

windrow::Error failed(const char* call, VkResult result) {
    return {std::string(call) + " failed: " + windrow::vulkan::name_of(result) + "."};
}

} // namespace

DeviceObjects::~DeviceObjects() {
    for (auto last = destroy_.rbegin(); last != destroy_.rend(); ++last)
        (*last)();
}

windrow::Result<VkBuffer> DeviceObjects::buffer(const char* name, VkDeviceSize bytes, VkBufferUsageFlags usage) {
    VkPhysicalDeviceProperties properties{};
    vkGetPhysicalDeviceProperties(host_.physical_device, &properties);
    if (bytes > properties.limits.maxStorageBufferRange)
        return windrow::Error{std::string("The grass's ") + name + " need " + std::to_string(bytes) +
                              " bytes in one buffer, of which this device's shaders reach " +
                              std::to_string(properties.limits.maxStorageBufferRange) +
                              ": lower grass.most_chunks, or give fewer corners."};
    const VkBufferCreateInfo info{.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO,
                                  .pNext = nullptr,
                                  .flags = 0,
                                  .size = bytes,
                                  .usage = usage,
                                  .sharingMode = VK_SHARING_MODE_EXCLUSIVE,
                                  .queueFamilyIndexCount = 0,
                                  .pQueueFamilyIndices = nullptr};
    VkBuffer made = VK_NULL_HANDLE;
    if (const VkResult result = vkCreateBuffer(host_.device, &info, nullptr, &made); result != VK_SUCCESS)
        return failed("vkCreateBuffer", result);
    at_end([device = host_.device, made] { vkDestroyBuffer(device, made, nullptr); });

    VkMemoryRequirements needs{};
    vkGetBufferMemoryRequirements(host_.device, made, &needs);
    VkPhysicalDeviceMemoryProperties has{};
    vkGetPhysicalDeviceMemoryProperties(host_.physical_device, &has);
    // The device's own where it fits, else any: every device has one of either kind for a buffer.
    std::uint32_t chosen = has.memoryTypeCount;
    for (std::uint32_t type = has.memoryTypeCount; type-- > 0;) {
        const bool own = (has.memoryTypes[type].propertyFlags & VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT) != 0;
        if ((needs.memoryTypeBits >> type & 1u) != 0 && (own || chosen == has.memoryTypeCount))
            chosen = type;
    }
    const VkMemoryAllocateInfo wanted{.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO,
                                      .pNext = nullptr,
                                      .allocationSize = needs.size,
                                      .memoryTypeIndex = chosen};
    VkDeviceMemory memory = VK_NULL_HANDLE;
    if (const VkResult result = vkAllocateMemory(host_.device, &wanted, nullptr, &memory); result != VK_SUCCESS)
        return windrow::Error{std::string("No ") + std::to_string(needs.size) + " bytes of device memory for the grass's " +
                              name + " (" + windrow::vulkan::name_of(result) + "): lower grass.most_chunks."};
    at_end([device = host_.device, memory] { vkFreeMemory(device, memory, nullptr); });
    // Freed before the buffer is destroyed: allowed, since nothing uses it any more.
    bytes_ += needs.size;
    if (const VkResult result = vkBindBufferMemory(host_.device, made, memory, 0); result != VK_SUCCESS)
        return failed("vkBindBufferMemory", result);
    return made;
}

windrow::Result<VkDescriptorSetLayout> DeviceObjects::layout(std::span<const VkDescriptorType> kinds, VkShaderStageFlags stages) {
    std::vector<VkDescriptorSetLayoutBinding> bindings;
    for (const VkDescriptorType kind : kinds)
        bindings.push_back({static_cast<std::uint32_t>(bindings.size()), kind, 1, stages, nullptr});
    const VkDescriptorSetLayoutCreateInfo info{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO,
                                               .pNext = nullptr,
                                               .flags = 0,
                                               .bindingCount = static_cast<std::uint32_t>(bindings.size()),
                                               .pBindings = bindings.data()};
    VkDescriptorSetLayout made = VK_NULL_HANDLE;
    if (const VkResult result = vkCreateDescriptorSetLayout(host_.device, &info, nullptr, &made); result != VK_SUCCESS)
        return failed("vkCreateDescriptorSetLayout", result);
    at_end([device = host_.device, made] { vkDestroyDescriptorSetLayout(device, made, nullptr); });
    return made;
}

windrow::Result<VkDescriptorSet> DeviceObjects::set(VkDescriptorSetLayout layout, std::span<const Bound> buffers) {
    const auto count = static_cast<std::uint32_t>(buffers.size());
    const VkDescriptorPoolSize sizes[] = {{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, count}, {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, count}};
    const VkDescriptorPoolCreateInfo pool_info{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO,
                                               .pNext = nullptr,
                                               .flags = 0,
                                               .maxSets = 1,
                                               .poolSizeCount = 2,
                                               .pPoolSizes = sizes};
    VkDescriptorPool pool = VK_NULL_HANDLE;
    if (const VkResult result = vkCreateDescriptorPool(host_.device, &pool_info, nullptr, &pool); result != VK_SUCCESS)
        return failed("vkCreateDescriptorPool", result);
    at_end([device = host_.device, pool] { vkDestroyDescriptorPool(device, pool, nullptr); });
    const VkDescriptorSetAllocateInfo info{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO,
                                           .pNext = nullptr,
                                           .descriptorPool = pool,
                                           .descriptorSetCount = 1,
                                           .pSetLayouts = &layout};
    VkDescriptorSet made = VK_NULL_HANDLE;
    if (const VkResult result = vkAllocateDescriptorSets(host_.device, &info, &made); result != VK_SUCCESS)
        return failed("vkAllocateDescriptorSets", result);
    for (std::uint32_t n = 0; n < count; ++n) {
        const VkDescriptorBufferInfo whole{buffers[n].buffer, 0, VK_WHOLE_SIZE};
        const VkWriteDescriptorSet write{.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                                         .pNext = nullptr,
                                         .dstSet = made,
                                         .dstBinding = n,
                                         .dstArrayElement = 0,
                                         .descriptorCount = 1,
                                         .descriptorType = buffers[n].kind,
                                         .pImageInfo = nullptr,
                                         .pBufferInfo = &whole,
                                         .pTexelBufferView = nullptr};
        vkUpdateDescriptorSets(host_.device, 1, &write, 0, nullptr);
    }
    return made;
}

windrow::Result<VkPipelineLayout> DeviceObjects::pipeline_layout(std::span<const VkDescriptorSetLayout> sets,
                                                                 std::uint32_t push_bytes) {
    const VkPushConstantRange range{VK_SHADER_STAGE_COMPUTE_BIT, 0, push_bytes};
    const VkPipelineLayoutCreateInfo info{.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
                                          .pNext = nullptr,
                                          .flags = 0,
                                          .setLayoutCount = static_cast<std::uint32_t>(sets.size()),
                                          .pSetLayouts = sets.data(),
                                          .pushConstantRangeCount = 1,
                                          .pPushConstantRanges = &range};
    VkPipelineLayout made = VK_NULL_HANDLE;
    if (const VkResult result = vkCreatePipelineLayout(host_.device, &info, nullptr, &made); result != VK_SUCCESS)
        return failed("vkCreatePipelineLayout", result);
    at_end([device = host_.device, made] { vkDestroyPipelineLayout(device, made, nullptr); });
    return made;
}

windrow::Result<VkPipeline> DeviceObjects::compute(VkPipelineLayout layout, std::span<const std::uint32_t> words) {
    const VkShaderModuleCreateInfo code{.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO,
                                        .pNext = nullptr,
                                        .flags = 0,
                                        .codeSize = words.size_bytes(),
                                        .pCode = words.data()};
    VkShaderModule module = VK_NULL_HANDLE;
    if (const VkResult result = vkCreateShaderModule(host_.device, &code, nullptr, &module); result != VK_SUCCESS)
        return failed("vkCreateShaderModule", result);
    VkComputePipelineCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO;
    info.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
    info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
    info.stage.module = module;
    info.stage.pName = "main";
    info.layout = layout;
    VkPipeline made = VK_NULL_HANDLE;
    const VkResult result = vkCreateComputePipelines(host_.device, VK_NULL_HANDLE, 1, &info, nullptr, &made);
    vkDestroyShaderModule(host_.device, module, nullptr);
    if (result != VK_SUCCESS)
        return failed("vkCreateComputePipelines", result);
    at_end([device = host_.device, made] { vkDestroyPipeline(device, made, nullptr); });
    return made;
}

} // namespace windrow::vegetation::grass
