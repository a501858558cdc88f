#include "fluid/vulkan/pipeline.h"

#include "fluid/message.h"
#include "fluid/vulkan/device.h"
#include "fluid/vulkan/functions.h"

#include <algorithm>
#include <cassert>
#include <string>

namespace windrow::vulkan {
namespace {

void check_count(std::span<const VkDescriptorType> bindings, VkDescriptorType type, std::uint32_t most, const char* limit,
                 detail::Reasons& reasons, const std::string& what) {
    const auto count = static_cast<std::uint32_t>(std::count(bindings.begin(), bindings.end(), type));
    if (count > most)
        reasons.add(what, " binds ", count, " where the device takes ", most, " (", limit, "): use another device or the CPU.");
}

Result<void> check_pipeline(const Device& device, const Pipeline::Description& description, const std::string& what) {
    const VkPhysicalDeviceLimits& limits = device.limits();
    detail::Reasons reasons;
    if (description.push_bytes > limits.maxPushConstantsSize)
        reasons.add(what, " pushes ", description.push_bytes, " bytes of constants where the device takes ",
                    limits.maxPushConstantsSize, " (maxPushConstantsSize): use another device or the CPU.");
    check_count(description.bindings, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, limits.maxPerStageDescriptorStorageBuffers,
                "maxPerStageDescriptorStorageBuffers", reasons, what);
    check_count(description.bindings, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE, limits.maxPerStageDescriptorStorageImages,
                "maxPerStageDescriptorStorageImages", reasons, what);
    if (!reasons.empty())
        return Error{reasons.take()};
    return {};
}

} // namespace

Result<Pipeline> Pipeline::create(Device& device, const Description& description) {
    assert(!description.code.empty() && description.push_bytes % 4 == 0);
    const std::string what = detail::message("the pass ", description.name);
    if (auto checked = check_pipeline(device, description, what); !checked)
        return Error{checked.error()};

    const Functions& functions = device.functions();
    const Host& host = device.host();
    Pipeline pipeline;
    pipeline.bindings_.assign(description.bindings.begin(), description.bindings.end());

    std::vector<VkDescriptorSetLayoutBinding> bindings;
    for (const VkDescriptorType type : description.bindings)
        bindings.push_back({.binding = static_cast<std::uint32_t>(bindings.size()),
                            .descriptorType = type,
                            .descriptorCount = 1,
                            .stageFlags = VK_SHADER_STAGE_COMPUTE_BIT,
                            .pImmutableSamplers = nullptr});
    VkDescriptorSetLayoutCreateInfo set_info{};
    set_info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
    set_info.bindingCount = static_cast<std::uint32_t>(bindings.size());
    set_info.pBindings = bindings.data();
    if (const VkResult result = make(functions, host, functions.vkCreateDescriptorSetLayout, set_info, pipeline.set_layout_);
        result != VK_SUCCESS)
        return call_error("vkCreateDescriptorSetLayout", what, result);

    const VkPushConstantRange push{VK_SHADER_STAGE_COMPUTE_BIT, 0, description.push_bytes};
    VkPipelineLayoutCreateInfo layout_info{};
    layout_info.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
    layout_info.setLayoutCount = 1;
    layout_info.pSetLayouts = &pipeline.set_layout_.get();
    layout_info.pushConstantRangeCount = description.push_bytes == 0 ? 0 : 1;
    layout_info.pPushConstantRanges = &push;
    if (const VkResult result = make(functions, host, functions.vkCreatePipelineLayout, layout_info, pipeline.layout_);
        result != VK_SUCCESS)
        return call_error("vkCreatePipelineLayout", what, result);

    VkShaderModuleCreateInfo module_info{};
    module_info.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
    module_info.codeSize = description.code.size_bytes();
    module_info.pCode = description.code.data();
    Handle<VkShaderModule, &Functions::vkDestroyShaderModule> shader;
    if (const VkResult result = make(functions, host, functions.vkCreateShaderModule, module_info, shader); result != VK_SUCCESS)
        return call_error("vkCreateShaderModule", what, result);

    std::vector<VkSpecializationMapEntry> entries;
    for (std::uint32_t n = 0; n < description.constants.size(); ++n)
        entries.push_back({.constantID = n, .offset = 4 * n, .size = 4});
    const VkSpecializationInfo constants{.mapEntryCount = static_cast<std::uint32_t>(entries.size()),
                                         .pMapEntries = entries.data(),
                                         .dataSize = description.constants.size_bytes(),
                                         .pData = description.constants.data()};
    VkComputePipelineCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO;
    info.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
    info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
    info.stage.module = shader.get();
    info.stage.pName = "main";
    info.stage.pSpecializationInfo = entries.empty() ? nullptr : &constants;
    info.layout = pipeline.layout();
    VkPipeline made = VK_NULL_HANDLE;
    if (const VkResult result =
            functions.vkCreateComputePipelines(host.device, VK_NULL_HANDLE, 1, &info, host.allocation_callbacks, &made);
        result != VK_SUCCESS)
        return call_error("vkCreateComputePipelines", what, result);
    pipeline.pipeline_ = {functions, host, made};
    return pipeline;
}

} // namespace windrow::vulkan
