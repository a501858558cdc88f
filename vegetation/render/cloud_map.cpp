#include "vegetation/render/cloud_map.h"

#include "shader_words/cloud_map_frag.h"
#include "vegetation/render/light_numerics.h"

#include <algorithm>

namespace windrow::vegetation::render {
namespace {

constexpr VkFormat k_cloud_format = VK_FORMAT_R16_SFLOAT; // every device draws to it and filters it

VkExtent2D extent_of(int texels) {
    const auto side = static_cast<std::uint32_t>(std::max(texels, 1));
    return {side, side};
}

} // namespace

CloudMap::CloudMap(engine::Objects& objects, int texels) : texels_(texels), map_(objects, k_cloud_format, extent_of(texels)) {}

void CloudMap::make(engine::Objects& objects, VkPipelineLayout layout) {
    map_.make(objects, layout, windrow::vulkan::shader_words::cloud_map_frag);
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

} // namespace windrow::vegetation::render
