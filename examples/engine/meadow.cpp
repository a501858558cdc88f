#include "examples/engine/meadow.h"

#include "examples/engine/target.h"
#include "shader_words/figure_frag.h"
#include "shader_words/figure_vert.h"
#include "shader_words/grass_frag.h"
#include "shader_words/grass_vert.h"
#include "shader_words/sky_frag.h"
#include "shader_words/sky_vert.h"

#include <vulkan/vulkan.h>

namespace windrow::vegetation::engine {
namespace {

constexpr VkShaderStageFlags k_stages = VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT;

// As the shaders count them.
constexpr std::uint32_t k_blade_vertices = 7;
constexpr std::uint32_t k_capsule_vertices = 6 * 8 * 12;
constexpr std::uint32_t k_capsules = 7 + 1 + 5 + 24;

VkShaderModule module_of(VkDevice device, std::span<const std::uint32_t> words) {
    VkShaderModuleCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
    info.codeSize = words.size_bytes();
    info.pCode = words.data();
    VkShaderModule made = VK_NULL_HANDLE;
    must(vkCreateShaderModule(device, &info, nullptr, &made), "vkCreateShaderModule");
    return made;
}

} // namespace

Meadow::Meadow(Device& device, VkRenderPass render_pass, VkDescriptorSetLayout wind) {
    const VkPushConstantRange range{k_stages, 0, sizeof(Scene)};
    VkPipelineLayoutCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
    info.setLayoutCount = 1;
    info.pSetLayouts = &wind;
    info.pushConstantRangeCount = 1;
    info.pPushConstantRanges = &range;
    must(vkCreatePipelineLayout(device.device, &info, nullptr, &layout_), "vkCreatePipelineLayout");
    device.at_end([vulkan = device.device, made = layout_] { vkDestroyPipelineLayout(vulkan, made, nullptr); });
    namespace words = windrow::vulkan::shader_words;
    sky_ = make(device, render_pass, {.vertex = words::sky_vert, .fragment = words::sky_frag, .depth = false});
    figures_ = make(device, render_pass, {.vertex = words::figure_vert, .fragment = words::figure_frag});
    grass_ = make(device, render_pass,
                  {.vertex = words::grass_vert, .fragment = words::grass_frag, .topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP});
}

VkPipeline Meadow::make(Device& device, VkRenderPass render_pass, const Recipe& recipe) const {
    const VkShaderModule vertex = module_of(device.device, recipe.vertex), fragment = module_of(device.device, recipe.fragment);
    VkPipelineShaderStageCreateInfo stages[2]{};
    for (VkPipelineShaderStageCreateInfo& stage : stages) {
        stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
        stage.pName = "main";
    }
    stages[0].stage = VK_SHADER_STAGE_VERTEX_BIT;
    stages[0].module = vertex;
    stages[1].stage = VK_SHADER_STAGE_FRAGMENT_BIT;
    stages[1].module = fragment;
    VkPipelineVertexInputStateCreateInfo input{}; // no buffers: vertices make themselves from their numbers
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
    VkPipelineMultisampleStateCreateInfo samples{};
    samples.sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO;
    samples.rasterizationSamples = k_samples;
    VkPipelineDepthStencilStateCreateInfo depth{};
    depth.sType = VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO;
    depth.depthTestEnable = recipe.depth;
    depth.depthWriteEnable = recipe.depth;
    depth.depthCompareOp = VK_COMPARE_OP_LESS;
    VkPipelineColorBlendAttachmentState blend{};
    blend.colorWriteMask =
        VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT | VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT;
    VkPipelineColorBlendStateCreateInfo blends{};
    blends.sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO;
    blends.attachmentCount = 1;
    blends.pAttachments = &blend;
    const VkDynamicState dynamic_states[] = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
    VkPipelineDynamicStateCreateInfo dynamic{};
    dynamic.sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO;
    dynamic.dynamicStateCount = 2;
    dynamic.pDynamicStates = dynamic_states;
    VkGraphicsPipelineCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO;
    info.stageCount = 2;
    info.pStages = stages;
    info.pVertexInputState = &input;
    info.pInputAssemblyState = &assembly;
    info.pViewportState = &viewport;
    info.pRasterizationState = &raster;
    info.pMultisampleState = &samples;
    info.pDepthStencilState = &depth;
    info.pColorBlendState = &blends;
    info.pDynamicState = &dynamic;
    info.layout = layout_;
    info.renderPass = render_pass;
    VkPipeline made = VK_NULL_HANDLE;
    must(vkCreateGraphicsPipelines(device.device, VK_NULL_HANDLE, 1, &info, nullptr, &made), "vkCreateGraphicsPipelines");
    device.at_end([vulkan = device.device, made] { vkDestroyPipeline(vulkan, made, nullptr); });
    vkDestroyShaderModule(device.device, vertex, nullptr);
    vkDestroyShaderModule(device.device, fragment, nullptr);
    return made;
}

void Meadow::draw(VkCommandBuffer commands, const Scene& scene, VkDescriptorSet wind) const {
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout_, 0, 1, &wind, 0, nullptr);
    vkCmdPushConstants(commands, layout_, k_stages, 0, sizeof(scene), &scene);
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, sky_);
    vkCmdDraw(commands, 3, 1, 0, 0);
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, figures_);
    vkCmdDraw(commands, k_capsule_vertices, k_capsules, 0, 0);
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, grass_);
    vkCmdDraw(commands, k_blade_vertices, static_cast<std::uint32_t>(scene.eye.w), 0, 0);
}

} // namespace windrow::vegetation::engine
