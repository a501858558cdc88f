#include "vegetation/render/cloud_map.h"

#include "shader_words/cloud_map_frag.h"
#include "shader_words/full_screen_vert.h"
#include "vegetation/render/light_numerics.h"
#include "vegetation/vulkan/calls.h"
#include "vegetation/vulkan/pipeline.h"

#include <algorithm>

namespace windrow::vegetation::render {
namespace {

namespace words = windrow::vulkan::shader_words;

constexpr VkFormat k_cloud_format = VK_FORMAT_R16_SFLOAT; // every device draws to it and filters it

} // namespace

CloudMap::CloudMap(engine::Objects& objects, int texels) : texels_(texels) {
    const auto side = static_cast<std::uint32_t>(std::max(texels, 1));
    image_ = objects.image({.format = k_cloud_format,
                            .extent = {side, side},
                            .usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT});
    VkSamplerCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO;
    info.magFilter = info.minFilter = VK_FILTER_LINEAR;
    info.addressModeU = info.addressModeV = info.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    sampler_ = objects.sampler(info);
    const engine::Attachment map{.format = k_cloud_format, .view = image_.view, .end = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
    pass_.emplace(objects, VkExtent2D{side, side}, std::span(&map, 1));
}

void CloudMap::make(engine::Objects& objects, VkPipelineLayout layout) {
    pipeline_ = make_pipeline(objects, {.vertex = words::full_screen_vert,
                                        .fragment = words::cloud_map_frag,
                                        .layout = layout,
                                        .target = {pass_->handle(), VK_SAMPLE_COUNT_1_BIT, 1, false}});
}

glm::vec4 CloudMap::block(const CloudBlock& clouds, const SkyBlock& sky, glm::vec3 eye) const {
    if (texels_ == 0 || !(sky.sun.y > 0.0f))
        return {0.0f, 0.0f, 1.0f / k_cells, 1.0f};
    const numerics::WindrowClouds sheet{clouds.place, clouds.form};
    const glm::vec2 cell = numerics::windrow_cloud_cell(sheet, numerics::windrow_cloud_place(sheet, eye, glm::vec3(sky.sun)));
    const float texel = k_cells / static_cast<float>(texels_);
    const glm::vec2 corner = texel * glm::floor((cell - 0.5f * k_cells) / texel);
    return {corner, 1.0f / k_cells, 1.0f / static_cast<float>(texels_)};
}

void CloudMap::record(VkCommandBuffer commands) const {
    pass_->begin(commands);
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline_);
    vkCmdDraw(commands, 3, 1, 0, 0);
    vkCmdEndRenderPass(commands);
}

} // namespace windrow::vegetation::render
