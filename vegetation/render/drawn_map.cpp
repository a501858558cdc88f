#include "vegetation/render/drawn_map.h"

#include "shader_words/full_screen_vert.h"
#include "vegetation/vulkan/calls.h"
#include "vegetation/vulkan/pipeline.h"

namespace windrow::vegetation::render {
namespace {

engine::RenderPass map_pass(engine::Objects& objects, VkFormat format, VkExtent2D extent, VkImageView view) {
    const engine::Attachment map{.format = format, .view = view, .end = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
    return engine::RenderPass(objects, extent, std::span(&map, 1));
}

} // namespace

DrawnMap::DrawnMap(engine::Objects& objects, VkFormat format, VkExtent2D extent)
    : image_(objects.image(
          {.format = format, .extent = extent, .usage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT})),
      sampler_(objects.sampler(engine::Sampler::filter)), pass_(map_pass(objects, format, extent, image_.view)) {}

void DrawnMap::make(engine::Objects& objects, VkPipelineLayout layout, std::span<const std::uint32_t> fragment) {
    pipeline_ = make_pipeline(objects, {.vertex = windrow::vulkan::shader_words::full_screen_vert,
                                        .fragment = fragment,
                                        .layout = layout,
                                        .target = {pass_.handle(), VK_SAMPLE_COUNT_1_BIT, 1, false}});
}

void DrawnMap::record(VkCommandBuffer commands) const {
    pass_.begin(commands);
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline_);
    vkCmdDraw(commands, 3, 1, 0, 0);
    vkCmdEndRenderPass(commands);
}

} // namespace windrow::vegetation::render
