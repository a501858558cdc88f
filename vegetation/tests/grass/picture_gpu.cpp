// The Vulkan of picture.h; built with the tests that take tests/parity/gpu.h.
#include "shader_words/still_frag.h"
#include "shader_words/still_vert.h"
#include "vegetation/tests/grass/picture.h"

#include <gtest/gtest.h>
#include <span>
#include <vulkan/vulkan.h>

namespace windrow::vegetation::grass::test {
namespace {

constexpr VkFormat k_colour = VK_FORMAT_R8G8B8A8_UNORM;
constexpr VkFormat k_depth = VK_FORMAT_D16_UNORM; // of all devices

VkShaderModule module_of(VkDevice device, std::span<const std::uint32_t> words) {
    VkShaderModuleCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
    info.codeSize = words.size_bytes();
    info.pCode = words.data();
    VkShaderModule made = VK_NULL_HANDLE;
    EXPECT_EQ(vkCreateShaderModule(device, &info, nullptr, &made), VK_SUCCESS);
    return made;
}

VkAttachmentDescription attachment(VkFormat format, VkAttachmentStoreOp store, VkImageLayout end) {
    VkAttachmentDescription made{};
    made.format = format;
    made.samples = VK_SAMPLE_COUNT_1_BIT;
    made.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
    made.storeOp = store;
    made.stencilLoadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE;
    made.stencilStoreOp = VK_ATTACHMENT_STORE_OP_DONT_CARE;
    made.finalLayout = end;
    return made;
}

} // namespace

Picture::Recipe Picture::still(const GrassField& field) {
    return {{field.layout()}, windrow::vulkan::shader_words::still_vert, windrow::vulkan::shader_words::still_frag};
}

Picture::Picture(const windrow::vulkan::Host& host, const Recipe& recipe)
    : host_(host), grass_set_(static_cast<std::uint32_t>(recipe.sets.size()) - 1) {
    colour_ = make_attachment(k_colour, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT,
                              VK_IMAGE_ASPECT_COLOR_BIT);
    depth_ = make_attachment(k_depth, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT, VK_IMAGE_ASPECT_DEPTH_BIT);
    make_render_pass();
    const VkImageView views[] = {colour_.view, depth_.view};
    VkFramebufferCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO;
    info.renderPass = render_pass_;
    info.attachmentCount = 2;
    info.pAttachments = views;
    info.width = k_extent.width;
    info.height = k_extent.height;
    info.layers = 1;
    EXPECT_EQ(vkCreateFramebuffer(host_.device, &info, nullptr, &framebuffer_), VK_SUCCESS);
    make_pipeline(recipe);
}

Picture::~Picture() {
    vkDestroyPipeline(host_.device, pipeline_, nullptr);
    vkDestroyPipelineLayout(host_.device, layout_, nullptr);
    vkDestroyFramebuffer(host_.device, framebuffer_, nullptr);
    vkDestroyRenderPass(host_.device, render_pass_, nullptr);
    for (const Attachment& each : {colour_, depth_}) {
        vkDestroyImageView(host_.device, each.view, nullptr);
        vkDestroyImage(host_.device, each.image, nullptr);
        vkFreeMemory(host_.device, each.memory, nullptr);
    }
}

Picture::Attachment Picture::make_attachment(VkFormat format, VkImageUsageFlags usage, VkImageAspectFlags aspect) {
    Attachment made;
    VkImageCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO;
    info.imageType = VK_IMAGE_TYPE_2D;
    info.format = format;
    info.extent = {k_extent.width, k_extent.height, 1};
    info.mipLevels = 1;
    info.arrayLayers = 1;
    info.samples = VK_SAMPLE_COUNT_1_BIT;
    info.usage = usage;
    EXPECT_EQ(vkCreateImage(host_.device, &info, nullptr, &made.image), VK_SUCCESS);
    VkMemoryRequirements needs{};
    vkGetImageMemoryRequirements(host_.device, made.image, &needs);
    VkMemoryAllocateInfo wanted{};
    wanted.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
    wanted.allocationSize = needs.size;
    while ((needs.memoryTypeBits >> wanted.memoryTypeIndex & 1u) == 0)
        ++wanted.memoryTypeIndex;
    EXPECT_EQ(vkAllocateMemory(host_.device, &wanted, nullptr, &made.memory), VK_SUCCESS);
    EXPECT_EQ(vkBindImageMemory(host_.device, made.image, made.memory, 0), VK_SUCCESS);
    VkImageViewCreateInfo view{};
    view.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO;
    view.image = made.image;
    view.viewType = VK_IMAGE_VIEW_TYPE_2D;
    view.format = format;
    view.subresourceRange = {aspect, 0, 1, 0, 1};
    EXPECT_EQ(vkCreateImageView(host_.device, &view, nullptr, &made.view), VK_SUCCESS);
    return made;
}

void Picture::make_render_pass() {
    const VkAttachmentDescription attachments[] = {
        attachment(k_colour, VK_ATTACHMENT_STORE_OP_STORE, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL),
        attachment(k_depth, VK_ATTACHMENT_STORE_OP_DONT_CARE, VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL)};
    const VkAttachmentReference colour{0, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
    const VkAttachmentReference depth{1, VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL};
    VkSubpassDescription subpass{};
    subpass.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS;
    subpass.colorAttachmentCount = 1;
    subpass.pColorAttachments = &colour;
    subpass.pDepthStencilAttachment = &depth;
    constexpr VkPipelineStageFlags draws = VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT |
                                           VK_PIPELINE_STAGE_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_LATE_FRAGMENT_TESTS_BIT;
    constexpr VkAccessFlags writes = VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT | VK_ACCESS_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT;
    const VkSubpassDependency dependencies[] = {
        {VK_SUBPASS_EXTERNAL, 0, draws | VK_PIPELINE_STAGE_TRANSFER_BIT, draws, writes, writes, 0},
        {0, VK_SUBPASS_EXTERNAL, draws, VK_PIPELINE_STAGE_TRANSFER_BIT, writes, VK_ACCESS_TRANSFER_READ_BIT, 0}};
    VkRenderPassCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO;
    info.attachmentCount = 2;
    info.pAttachments = attachments;
    info.subpassCount = 1;
    info.pSubpasses = &subpass;
    info.dependencyCount = 2;
    info.pDependencies = dependencies;
    EXPECT_EQ(vkCreateRenderPass(host_.device, &info, nullptr, &render_pass_), VK_SUCCESS);
}

void Picture::make_pipeline(const Recipe& recipe) {
    const VkPushConstantRange range{VK_SHADER_STAGE_VERTEX_BIT, 0, sizeof(glm::mat4) + 8};
    VkPipelineLayoutCreateInfo layout_info{};
    layout_info.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
    layout_info.setLayoutCount = grass_set_ + 1;
    layout_info.pSetLayouts = recipe.sets.data();
    layout_info.pushConstantRangeCount = 1;
    layout_info.pPushConstantRanges = &range;
    EXPECT_EQ(vkCreatePipelineLayout(host_.device, &layout_info, nullptr, &layout_), VK_SUCCESS);
    const VkShaderModule vertex = module_of(host_.device, recipe.vertex), fragment = module_of(host_.device, recipe.fragment);
    VkPipelineShaderStageCreateInfo stages[2]{};
    for (VkPipelineShaderStageCreateInfo& stage : stages) {
        stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
        stage.pName = "main";
    }
    stages[0].stage = VK_SHADER_STAGE_VERTEX_BIT;
    stages[0].module = vertex;
    stages[1].stage = VK_SHADER_STAGE_FRAGMENT_BIT;
    stages[1].module = fragment;
    VkPipelineVertexInputStateCreateInfo input{};
    input.sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO;
    VkPipelineInputAssemblyStateCreateInfo assembly{};
    assembly.sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO;
    assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP;
    const VkViewport window{0.0f, 0.0f, static_cast<float>(k_extent.width), static_cast<float>(k_extent.height), 0.0f, 1.0f};
    const VkRect2D scissor{{0, 0}, k_extent};
    VkPipelineViewportStateCreateInfo viewport{};
    viewport.sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO;
    viewport.viewportCount = 1;
    viewport.pViewports = &window;
    viewport.scissorCount = 1;
    viewport.pScissors = &scissor;
    VkPipelineRasterizationStateCreateInfo raster{};
    raster.sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO;
    raster.lineWidth = 1.0f;
    VkPipelineMultisampleStateCreateInfo samples{};
    samples.sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO;
    samples.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
    VkPipelineDepthStencilStateCreateInfo depth{};
    depth.sType = VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO;
    depth.depthTestEnable = VK_TRUE;
    depth.depthWriteEnable = VK_TRUE;
    depth.depthCompareOp = VK_COMPARE_OP_LESS;
    VkPipelineColorBlendAttachmentState blend{};
    blend.colorWriteMask =
        VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT | VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT;
    VkPipelineColorBlendStateCreateInfo blends{};
    blends.sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO;
    blends.attachmentCount = 1;
    blends.pAttachments = &blend;
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
    info.layout = layout_;
    info.renderPass = render_pass_;
    EXPECT_EQ(vkCreateGraphicsPipelines(host_.device, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline_), VK_SUCCESS);
    vkDestroyShaderModule(host_.device, vertex, nullptr);
    vkDestroyShaderModule(host_.device, fragment, nullptr);
}

void Picture::record(VkCommandBuffer commands, const GrassField& field, const glm::mat4& view_projection, View view,
                     VkBuffer into, VkDescriptorSet wind) const {
    VkClearValue clear[2]{};
    clear[1].depthStencil.depth = 1.0f;
    VkRenderPassBeginInfo info{};
    info.sType = VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO;
    info.renderPass = render_pass_;
    info.framebuffer = framebuffer_;
    info.renderArea.extent = k_extent;
    info.clearValueCount = 2;
    info.pClearValues = clear;
    vkCmdBeginRenderPass(commands, &info, VK_SUBPASS_CONTENTS_INLINE);
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline_);
    vkCmdPushConstants(commands, layout_, VK_SHADER_STAGE_VERTEX_BIT, 0, sizeof view_projection, &view_projection);
    if (wind != VK_NULL_HANDLE)
        vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout_, 0, 1, &wind, 0, nullptr);
    field.draw(commands, {.layout = layout_, .set = grass_set_, .push_offset = sizeof view_projection, .view = view});
    vkCmdEndRenderPass(commands);
    VkBufferImageCopy region{};
    region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    region.imageExtent = {k_extent.width, k_extent.height, 1};
    vkCmdCopyImageToBuffer(commands, colour_.image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, into, 1, &region);
}

} // namespace windrow::vegetation::grass::test
