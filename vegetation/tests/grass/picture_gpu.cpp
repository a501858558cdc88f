// The Vulkan of picture.h; built with the tests that take tests/parity/gpu.h.
#include "shader_words/still_frag.h"
#include "shader_words/still_vert.h"
#include "vegetation/tests/grass/picture.h"

#include <cstring>
#include <vulkan/vulkan.h>

namespace windrow::vegetation::grass::test {
Picture::Recipe Picture::still(const GrassField& field) {
    return {{field.layout()}, windrow::vulkan::shader_words::still_vert, windrow::vulkan::shader_words::still_frag};
}

Picture::Picture(engine::Device& device, const Recipe& recipe)
    : objects_(device), grass_set_(static_cast<std::uint32_t>(recipe.sets.size()) - 1),
      canvas_(objects_, k_extent, VK_FORMAT_R8G8B8A8_UNORM, VK_SAMPLE_COUNT_1_BIT) {
    layout_ = make_pipeline_layout(objects_, recipe.sets, sizeof(glm::mat4) + 8);
    pipeline_ = make_pipeline(objects_, {.vertex = recipe.vertex,
                                         .fragment = recipe.fragment,
                                         .layout = layout_,
                                         .target = canvas_.target(),
                                         .topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_STRIP});
}

void Picture::record(VkCommandBuffer commands, const GrassField& field, const glm::mat4& view_projection, View view,
                     VkDescriptorSet wind) const {
    canvas_.begin(commands);
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline_);
    vkCmdPushConstants(commands, layout_, VK_SHADER_STAGE_ALL, 0, sizeof view_projection, &view_projection);
    if (wind != VK_NULL_HANDLE)
        vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout_, 0, 1, &wind, 0, nullptr);
    field.draw(commands, {.layout = layout_, .set = grass_set_, .push_offset = sizeof view_projection, .view = view});
    canvas_.end(commands);
}

std::vector<std::uint32_t> Picture::pixels() const {
    std::vector<std::uint32_t> made(k_pixels);
    std::memcpy(made.data(), canvas_.pixels().data(), 4 * k_pixels);
    return made;
}

} // namespace windrow::vegetation::grass::test
