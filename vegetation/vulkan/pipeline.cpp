#include "vegetation/vulkan/pipeline.h"

#include <array>
#include <vector>
#include <vulkan/vulkan.h>

namespace windrow::vegetation::engine {
namespace {

VkShaderModule module_of(Objects& objects, std::span<const std::uint32_t> words) {
    VkShaderModuleCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
    info.codeSize = words.size_bytes();
    info.pCode = words.data();
    return objects.make(vkCreateShaderModule, vkDestroyShaderModule, info, "vkCreateShaderModule");
}

VkPipelineShaderStageCreateInfo stage_of(VkShaderStageFlagBits stage, VkShaderModule words) {
    VkPipelineShaderStageCreateInfo made{};
    made.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
    made.stage = stage;
    made.module = words;
    made.pName = "main";
    return made;
}

// Pipelines are made by the list.
template <class Create, class Info>
VkPipeline keep(Objects& objects, Create create, const Info& info, const char* call) {
    const VkDevice device = objects.device().handle();
    const VkAllocationCallbacks* const callbacks = objects.device().host().allocation_callbacks;
    VkPipeline made = VK_NULL_HANDLE;
    must(create(device, VK_NULL_HANDLE, 1, &info, callbacks, &made), call);
    objects.at_end([device, made, callbacks] { vkDestroyPipeline(device, made, callbacks); });
    return made;
}

} // namespace

VkPipelineLayout make_pipeline_layout(Objects& objects, std::span<const VkDescriptorSetLayout> sets, std::uint32_t push_bytes) {
    const VkPushConstantRange range{VK_SHADER_STAGE_ALL, 0, push_bytes};
    VkPipelineLayoutCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
    info.setLayoutCount = static_cast<std::uint32_t>(sets.size());
    info.pSetLayouts = sets.data();
    info.pushConstantRangeCount = 1;
    info.pPushConstantRanges = &range;
    return objects.make(vkCreatePipelineLayout, vkDestroyPipelineLayout, info, "vkCreatePipelineLayout");
}

VkPipeline make_pipeline(Objects& objects, const PipelineRecipe& recipe) {
    Objects shaders(objects.device()); // end with this function
    const VkShaderModule vertex = module_of(shaders, recipe.vertex);
    const VkShaderModule fragment = recipe.fragment.empty() ? VK_NULL_HANDLE : module_of(shaders, recipe.fragment);
    std::array stages{stage_of(VK_SHADER_STAGE_VERTEX_BIT, vertex), stage_of(VK_SHADER_STAGE_FRAGMENT_BIT, fragment)};
    std::vector<VkSpecializationMapEntry> entries;
    for (std::uint32_t n = 0; n < recipe.constants.size(); ++n)
        entries.push_back({n, n * 4u, 4});
    const VkSpecializationInfo constants{static_cast<std::uint32_t>(entries.size()), entries.data(),
                                         recipe.constants.size_bytes(), recipe.constants.data()};
    if (!entries.empty())
        stages[1].pSpecializationInfo = &constants;
    VkPipelineVertexInputStateCreateInfo input{};
    input.sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO;
    VkPipelineInputAssemblyStateCreateInfo assembly{};
    assembly.sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO;
    assembly.topology = recipe.topology;
    VkPipelineViewportStateCreateInfo viewport{};
    viewport.sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO;
    viewport.viewportCount = 1;
    viewport.scissorCount = 1;
    VkPipelineRasterizationStateCreateInfo raster{}; // a blade has two faces: none is culled
    raster.sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO;
    raster.lineWidth = 1.0f;
    raster.depthBiasEnable = recipe.bias;
    raster.depthBiasConstantFactor = 1.0f;
    raster.depthBiasSlopeFactor = 1.5f;
    VkPipelineMultisampleStateCreateInfo samples{};
    samples.sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO;
    samples.rasterizationSamples = recipe.target.samples;
    VkPipelineDepthStencilStateCreateInfo depth{};
    depth.sType = VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO;
    depth.depthTestEnable = recipe.target.depth;
    depth.depthWriteEnable = recipe.target.depth && recipe.writes_depth;
    depth.depthCompareOp = VK_COMPARE_OP_LESS_OR_EQUAL;
    VkPipelineColorBlendAttachmentState blend{};
    if (recipe.writes_colour)
        blend.colorWriteMask =
            VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT | VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT;
    const std::vector<VkPipelineColorBlendAttachmentState> each(recipe.target.colours, blend);
    VkPipelineColorBlendStateCreateInfo blends{};
    blends.sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO;
    blends.attachmentCount = recipe.target.colours;
    blends.pAttachments = each.data();
    const VkDynamicState dynamic_states[] = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
    VkPipelineDynamicStateCreateInfo dynamic{};
    dynamic.sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO;
    dynamic.dynamicStateCount = 2;
    dynamic.pDynamicStates = dynamic_states;
    VkGraphicsPipelineCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO;
    info.stageCount = fragment == VK_NULL_HANDLE ? 1 : 2;
    info.pStages = stages.data();
    info.pVertexInputState = &input;
    info.pInputAssemblyState = &assembly;
    info.pViewportState = &viewport;
    info.pRasterizationState = &raster;
    info.pMultisampleState = &samples;
    info.pDepthStencilState = &depth;
    info.pColorBlendState = &blends;
    info.pDynamicState = &dynamic;
    info.layout = recipe.layout;
    info.renderPass = recipe.target.render_pass;
    return keep(objects, vkCreateGraphicsPipelines, info, "vkCreateGraphicsPipelines");
}

VkPipeline make_compute_pipeline(Objects& objects, VkPipelineLayout layout, std::span<const std::uint32_t> words) {
    Objects shaders(objects.device());
    VkComputePipelineCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO;
    info.stage = stage_of(VK_SHADER_STAGE_COMPUTE_BIT, module_of(shaders, words));
    info.layout = layout;
    return keep(objects, vkCreateComputePipelines, info, "vkCreateComputePipelines");
}

} // namespace windrow::vegetation::engine
