#include "vegetation/vulkan/wind_set.h"

namespace windrow::vegetation::engine {
namespace {

// In the order of the include: a uniform block, three textures now, the three before, the gust tile.
constexpr VkShaderStageFlags k_all = VK_SHADER_STAGE_ALL_GRAPHICS | VK_SHADER_STAGE_COMPUTE_BIT;
constexpr Binding k_block{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, k_all};
constexpr Binding k_texture{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, k_all};
constexpr Binding k_tile{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, k_all};
constexpr std::array k_bindings{k_block, k_texture, k_texture, k_texture, k_texture, k_texture, k_texture, k_tile};

} // namespace

WindSet::WindSet(Objects& objects)
    : device_(objects.device()), layout_(make_layout(objects, k_bindings)), sampler_(objects.sampler(Sampler::texels)),
      blocks_(objects.frame_buffers(sizeof(FrameBlock), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT)) {
    make_sets(objects, layout_, k_bindings, sets_);
}

VkDescriptorSet WindSet::of(int slot, const vulkan::Wind& wind, glm::dvec3 anchor, const Sampling& sampling) {
    // The frame that used this slot before is done: its block and its set are free to be written.
    const Buffer& block = blocks_[static_cast<std::size_t>(slot)];
    const VkDescriptorSet set = sets_[static_cast<std::size_t>(slot)];
    const FrameBlock content = wind.frame_block(anchor, sampling);
    std::memcpy(block.mapped, &content, sizeof content);
    point(device_, set, 0, k_block.type, block.buffer);
    std::uint32_t binding = 1;
    const vulkan::Textures now = wind.textures(), before = wind.previous_textures();
    for (const vulkan::Textures& textures : {now, before})
        for (std::size_t n = 0; n < 3; ++n)
            point(device_, set, binding++, textures.views[n], sampler_, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
    point(device_, set, binding, k_tile.type, wind.gust_buffer());
    return set;
}

} // namespace windrow::vegetation::engine
