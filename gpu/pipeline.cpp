#include "gpu/pipeline.h"

#include "fluid/core/message.h"
#include "gpu/device.h"
#include "gpu/functions.h"
#include "gpu/pipeline_state.h"

#include <algorithm>
#include <cassert>
#include <initializer_list>
#include <map>
#include <string>
#include <utility>

namespace windrow::vulkan {
namespace {

void check_count(std::span<const VkDescriptorSetLayoutBinding> bindings, std::initializer_list<VkDescriptorType> types,
                 std::uint32_t most, const char* limit, detail::Reasons& reasons, const std::string& what) {
    std::uint32_t count = 0;
    for (const VkDescriptorSetLayoutBinding& binding : bindings)
        count += std::find(types.begin(), types.end(), binding.descriptorType) != types.end() ? binding.descriptorCount : 0;
    if (count > most)
        reasons.add(what, " binds ", count, " where the device takes ", most, " (", limit, "): use another device or the CPU.");
}

Result<void> check_layout(const Device& device, std::span<const VkDescriptorSetLayoutBinding> bindings, std::uint32_t push_bytes,
                          const std::string& what) {
    const VkPhysicalDeviceLimits& limits = device.limits();
    detail::Reasons reasons;
    if (push_bytes > limits.maxPushConstantsSize)
        reasons.add(what, " pushes ", push_bytes, " bytes of constants where the device takes ", limits.maxPushConstantsSize,
                    " (maxPushConstantsSize): use another device or the CPU.");
    check_count(bindings, {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER_DYNAMIC},
                limits.maxPerStageDescriptorStorageBuffers, "maxPerStageDescriptorStorageBuffers", reasons, what);
    check_count(bindings, {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER_DYNAMIC}, limits.maxDescriptorSetStorageBuffersDynamic,
                "maxDescriptorSetStorageBuffersDynamic", reasons, what);
    check_count(bindings, {VK_DESCRIPTOR_TYPE_STORAGE_IMAGE}, limits.maxPerStageDescriptorStorageImages,
                "maxPerStageDescriptorStorageImages", reasons, what);
    if (!reasons.empty())
        return Error{reasons.take()};
    return {};
}

std::string what_of(const Pipeline::Description& description) {
    return detail::message("the pass ", description.name);
}

} // namespace

Result<PipelineLayout> PipelineLayout::create(Device& device, std::span<const VkDescriptorSetLayoutBinding> bindings,
                                              const VkPushConstantRange& push, const std::string& what) {
    assert(push.size % 4 == 0);
    if (auto checked = check_layout(device, bindings, push.size, what); !checked)
        return checked.failure();
    const Functions& functions = device.functions();
    const Host& host = device.host();
    PipelineLayout made;
    made.bindings_.assign(bindings.begin(), bindings.end());
    VkDescriptorSetLayoutCreateInfo set_info{};
    set_info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
    set_info.bindingCount = static_cast<std::uint32_t>(bindings.size());
    set_info.pBindings = bindings.data();
    if (const VkResult result = make(functions, host, functions.vkCreateDescriptorSetLayout, set_info, made.set_layout_);
        result != VK_SUCCESS)
        return call_error("vkCreateDescriptorSetLayout", what, result);
    VkPipelineLayoutCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
    info.setLayoutCount = 1;
    info.pSetLayouts = &made.set_layout_.get();
    info.pushConstantRangeCount = push.size == 0 ? 0 : 1;
    info.pPushConstantRanges = &push;
    if (const VkResult result = make(functions, host, functions.vkCreatePipelineLayout, info, made.layout_); result != VK_SUCCESS)
        return call_error("vkCreatePipelineLayout", what, result);
    return made;
}

std::vector<VkDescriptorSetLayoutBinding> bindings_of(std::span<const VkDescriptorType> kinds, VkShaderStageFlags stages) {
    std::vector<VkDescriptorSetLayoutBinding> bindings;
    for (const VkDescriptorType type : kinds)
        bindings.push_back({.binding = static_cast<std::uint32_t>(bindings.size()),
                            .descriptorType = type,
                            .descriptorCount = 1,
                            .stageFlags = stages,
                            .pImmutableSamplers = nullptr});
    return bindings;
}

Result<Pipeline> Pipeline::create(Device& device, const Description& description) {
    auto layout = PipelineLayout::create(device, bindings_of(description.bindings, VK_SHADER_STAGE_COMPUTE_BIT),
                                         {VK_SHADER_STAGE_COMPUTE_BIT, 0, description.push_bytes}, what_of(description));
    if (!layout)
        return layout.failure();
    return create(device, *std::move(layout), description);
}

Result<Pipeline> Pipeline::create(Device& device, PipelineLayout layout, const Description& description) {
    assert(!description.code.empty());
    const std::string what = what_of(description);
    const Functions& functions = device.functions();
    const Host& host = device.host();
    Pipeline pipeline;
    static_cast<PipelineLayout&>(pipeline) = std::move(layout);

    const VkShaderModuleCreateInfo module_info = module_of(description.code);
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
    info.stage = stage_of(VK_SHADER_STAGE_COMPUTE_BIT, shader.get());
    info.stage.pSpecializationInfo = entries.empty() ? nullptr : &constants;
    info.layout = pipeline.layout();
    info.flags = host.pipelines.flags;
    VkPipeline made = VK_NULL_HANDLE;
    if (const VkResult result =
            functions.vkCreateComputePipelines(host.device, host.pipeline_cache, 1, &info, host.allocation_callbacks, &made);
        result != VK_SUCCESS)
        return call_error("vkCreateComputePipelines", what, result);
    pipeline.pipeline_ = {functions, host, made};
    device.name(VK_OBJECT_TYPE_PIPELINE, made, description.name);
    if (host.pipelines.created)
        host.pipelines.created(description.name, made);
    return pipeline;
}

void Pipeline::bind(const Functions& functions, VkCommandBuffer commands, VkDescriptorSet set,
                    std::span<const std::uint32_t> offsets) const {
    functions.vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, handle());
    functions.vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout(), 0, 1, &set,
                                      static_cast<std::uint32_t>(offsets.size()), offsets.data());
}

// Based on: Khronos, SPIR-V Specification 1.6, sections 2.3 (layout of a module), 3.20 (decorations), 3.49 (instructions).
// `readonly` of GLSL becomes NonWritable and `writeonly` NonReadable, on the variable or on each member of its block.
std::vector<Access> access_of(std::span<const std::uint32_t> spirv, std::size_t bindings) {
    constexpr std::uint32_t k_op_pointer = 32, k_op_variable = 59, k_op_decorate = 71, k_op_member_decorate = 72;
    constexpr std::uint32_t k_non_writable = 24, k_non_readable = 25, k_binding = 33;
    constexpr std::size_t k_header_words = 5;
    std::map<std::uint32_t, Access> named;                  // access of a variable or a block
    std::map<std::uint32_t, std::uint32_t> at, pointee, of; // variable: binding; pointer: block; variable: pointer
    const auto note = [&](std::uint32_t id, std::uint32_t decoration) {
        if (decoration == k_non_writable)
            named[id].writes = false;
        if (decoration == k_non_readable)
            named[id].reads = false;
    };
    for (std::size_t word = k_header_words; word < spirv.size();) {
        const std::uint32_t length = spirv[word] >> 16, operation = spirv[word] & 0xffffu;
        if (length == 0 || word + length > spirv.size())
            break; // no module: no more data
        const auto operand = [&](std::size_t n) { return spirv[word + n]; };
        if (operation == k_op_decorate && length >= 3) {
            note(operand(1), operand(2));
            if (operand(2) == k_binding && length >= 4)
                at[operand(1)] = operand(3);
        } else if (operation == k_op_member_decorate && length >= 4) {
            note(operand(1), operand(3));
        } else if (operation == k_op_pointer && length >= 4) {
            pointee[operand(1)] = operand(3);
        } else if (operation == k_op_variable && length >= 4) {
            of[operand(2)] = operand(1);
        }
        word += length;
    }
    std::vector<Access> access(bindings, {.reads = false, .writes = false});
    for (const auto& [variable, binding] : at) {
        if (binding >= bindings)
            continue;
        const Access own = named[variable], block = named[pointee[of[variable]]];
        access[binding] = {.reads = own.reads && block.reads, .writes = own.writes && block.writes};
    }
    return access;
}

} // namespace windrow::vulkan
