// State of pipelines, filled in once for all that draw or compute here. Nothing calls Vulkan, so that a host with Vulkan's loader and
// one without share it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>
#include <vulkan/vulkan_core.h>

namespace windrow::vulkan {

/// Of SPIR-V, which the info points to.
[[nodiscard]] inline VkShaderModuleCreateInfo module_of(std::span<const std::uint32_t> code) {
    VkShaderModuleCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
    info.codeSize = code.size_bytes();
    info.pCode = code.data();
    return info;
}

/// Its function `main`.
[[nodiscard]] inline VkPipelineShaderStageCreateInfo stage_of(VkShaderStageFlagBits stage, VkShaderModule shader) {
    VkPipelineShaderStageCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
    info.stage = stage;
    info.module = shader;
    info.pName = "main";
    return info;
}

struct GraphicsSettings {
    std::span<const VkPipelineShaderStageCreateInfo> stages{};
    VkPipelineLayout layout = VK_NULL_HANDLE;
    VkRenderPass render_pass = VK_NULL_HANDLE;
    VkPrimitiveTopology topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
    VkSampleCountFlagBits samples = VK_SAMPLE_COUNT_1_BIT;
    std::uint32_t colours = 1; ///< colour attachments
    bool tests_depth = true;
    bool writes_depth = true;
    bool writes_colour = true;
    bool rasterises = true; ///< else vertices alone
    bool blends = false;    ///< colours over what is there, by their alpha
    bool bias = false;      ///< a shadow's: depth is moved away from the light by the slope
};

/// Everything that vkCreateGraphicsPipelines takes: no vertex buffers, triangles without face culling, viewport and scissor dynamic,
/// depth LESS_OR_EQUAL, no blending unless asked.
class GraphicsState {
  public:
    /// The stages are the caller's and outlive this.
    explicit GraphicsState(const GraphicsSettings& settings) {
        input_.sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO;
        assembly_.sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO;
        assembly_.topology = settings.topology;
        viewport_.sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO;
        viewport_.viewportCount = viewport_.scissorCount = 1;
        raster_.sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO; // a blade has two faces: none is culled
        raster_.rasterizerDiscardEnable = settings.rasterises ? VK_FALSE : VK_TRUE;
        raster_.lineWidth = 1.0f;
        raster_.depthBiasEnable = settings.bias ? VK_TRUE : VK_FALSE;
        raster_.depthBiasConstantFactor = 1.0f;
        raster_.depthBiasSlopeFactor = 1.5f;
        samples_.sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO;
        samples_.rasterizationSamples = settings.samples;
        depth_.sType = VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO;
        depth_.depthTestEnable = settings.tests_depth ? VK_TRUE : VK_FALSE;
        depth_.depthWriteEnable = settings.tests_depth && settings.writes_depth ? VK_TRUE : VK_FALSE;
        depth_.depthCompareOp = VK_COMPARE_OP_LESS_OR_EQUAL;
        VkPipelineColorBlendAttachmentState each{};
        if (settings.writes_colour)
            each.colorWriteMask =
                VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT | VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT;
        if (settings.blends) {
            each.blendEnable = VK_TRUE;
            each.srcColorBlendFactor = VK_BLEND_FACTOR_SRC_ALPHA;
            each.dstColorBlendFactor = VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA;
            each.srcAlphaBlendFactor = VK_BLEND_FACTOR_ONE;
            each.dstAlphaBlendFactor = VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA;
        }
        attachments_.assign(settings.colours, each);
        blends_.sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO;
        blends_.attachmentCount = settings.colours;
        blends_.pAttachments = attachments_.data();
        dynamic_.sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO;
        dynamic_.dynamicStateCount = 2;
        dynamic_.pDynamicStates = dynamic_states_;
        info_.sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO;
        info_.stageCount = static_cast<std::uint32_t>(settings.stages.size());
        info_.pStages = settings.stages.data();
        info_.pVertexInputState = &input_;
        info_.pInputAssemblyState = &assembly_;
        info_.pViewportState = &viewport_;
        info_.pRasterizationState = &raster_;
        info_.pMultisampleState = &samples_;
        info_.pDepthStencilState = &depth_;
        info_.pColorBlendState = &blends_;
        info_.pDynamicState = &dynamic_;
        info_.layout = settings.layout;
        info_.renderPass = settings.render_pass;
    }
    GraphicsState(const GraphicsState&) = delete;
    GraphicsState& operator=(const GraphicsState&) = delete;
    /// It points into this object.
    [[nodiscard]] const VkGraphicsPipelineCreateInfo& info() const { return info_; }

  private:
    static constexpr VkDynamicState dynamic_states_[] = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};

    VkPipelineVertexInputStateCreateInfo input_{};
    VkPipelineInputAssemblyStateCreateInfo assembly_{};
    VkPipelineViewportStateCreateInfo viewport_{};
    VkPipelineRasterizationStateCreateInfo raster_{};
    VkPipelineMultisampleStateCreateInfo samples_{};
    VkPipelineDepthStencilStateCreateInfo depth_{};
    std::vector<VkPipelineColorBlendAttachmentState> attachments_;
    VkPipelineColorBlendStateCreateInfo blends_{};
    VkPipelineDynamicStateCreateInfo dynamic_{};
    VkGraphicsPipelineCreateInfo info_{};
};

} // namespace windrow::vulkan
