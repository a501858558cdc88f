#include "vegetation/vulkan/wind_set.h"

#include "vegetation/vulkan/calls.h"

namespace windrow::vegetation::engine {
namespace {

std::vector<Binding> bindings() {
    std::vector<Binding> all;
    for (const VkDescriptorSetLayoutBinding& binding :
         vulkan::set_bindings(vulkan::TextureSet::vectors, VK_SHADER_STAGE_ALL_GRAPHICS | VK_SHADER_STAGE_COMPUTE_BIT))
        all.push_back({binding.descriptorType, binding.stageFlags});
    return all;
}

} // namespace

WindSet::WindSet(Objects& objects)
    : objects_(objects), layout_(make_layout(objects, bindings())),
      blocks_(objects.frame_buffers(sizeof(FrameBlock), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT)) {
    make_sets(objects, layout_, bindings(), sets_);
}

VkSampler WindSet::sampler(const Boundaries& boundaries) {
    std::size_t periodic = 0;
    for (int axis = 0; axis < 3; ++axis)
        periodic |= boundaries.periodic(axis) ? std::size_t{1} << axis : 0;
    VkSampler& sampler = samplers_[periodic];
    if (sampler == VK_NULL_HANDLE)
        sampler = objects_.sampler(vulkan::sampler_info(boundaries));
    return sampler;
}

VkDescriptorSet WindSet::of(int slot, const SampledWind& wind, glm::dvec3 anchor, const Sampling& sampling) {
    const vulkan::Textures now = wind.textures;
    if (now.vectors.view == VK_NULL_HANDLE)
        throw Failure("the wind has no texture of four components: create it with Settings::textures vectors or both.");
    // The frame that used this slot before is done: its block and its set are free to be written.
    const Buffer& block = blocks_[static_cast<std::size_t>(slot)];
    const VkDescriptorSet set = sets_[static_cast<std::size_t>(slot)];
    const FrameBlock content = wind.reader->frame_block(anchor, sampling);
    std::memcpy(block.mapped, &content, sizeof content);
    const vulkan::SetWrites writes(set, {.now = now,
                                         .before = wind.previous_textures,
                                         .sampler = sampler(wind.boundaries),
                                         .block = {block.buffer, 0, sizeof content},
                                         .tile = wind.gust_buffer});
    vkUpdateDescriptorSets(objects_.device().handle(), writes.size(), writes.data(), 0, nullptr);
    return set;
}

} // namespace windrow::vegetation::engine
