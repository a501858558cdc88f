#include "fluid/vulkan/textures.h"

namespace windrow::vulkan {
namespace {

// Of a frame, in a set: three, or one.
std::uint32_t textures_of_frame(TextureSet textures) {
    return textures == TextureSet::axes ? 3 : 1;
}

} // namespace

VkSamplerCreateInfo sampler_info(const Boundaries& boundaries) {
    const auto mode = [&](int axis) {
        return boundaries.periodic(axis) ? VK_SAMPLER_ADDRESS_MODE_REPEAT : VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    };
    VkSamplerCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO;
    info.magFilter = info.minFilter = VK_FILTER_LINEAR;
    info.addressModeU = mode(0);
    info.addressModeV = mode(1);
    info.addressModeW = mode(2);
    return info;
}

SetBindings set_bindings(TextureSet textures, VkShaderStageFlags stages, std::uint32_t first) {
    SetBindings set;
    const auto add = [&](VkDescriptorType type) {
        set.bindings_[set.size_] = {.binding = first + set.size_,
                                    .descriptorType = type,
                                    .descriptorCount = 1,
                                    .stageFlags = stages,
                                    .pImmutableSamplers = nullptr};
        ++set.size_;
    };
    add(VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER);
    for (std::uint32_t n = 0; n < 2 * textures_of_frame(textures); ++n)
        add(VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER);
    add(VK_DESCRIPTOR_TYPE_STORAGE_BUFFER);
    return set;
}

SetWrites::SetWrites(VkDescriptorSet set, const SetContent& content, TextureSet textures, std::uint32_t first)
    : block_(content.block), tile_{content.tile, 0, VK_WHOLE_SIZE} {
    for (const VkDescriptorSetLayoutBinding& binding : set_bindings(textures, 0, first))
        writes_[size_++] = {.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                            .pNext = nullptr,
                            .dstSet = set,
                            .dstBinding = binding.binding,
                            .dstArrayElement = 0,
                            .descriptorCount = 1,
                            .descriptorType = binding.descriptorType,
                            .pImageInfo = nullptr,
                            .pBufferInfo = nullptr,
                            .pTexelBufferView = nullptr};
    writes_[0].pBufferInfo = &block_;
    writes_[size_ - 1].pBufferInfo = &tile_;
    const std::uint32_t each = textures_of_frame(textures);
    for (std::uint32_t n = 0; n < 2 * each; ++n) {
        const Textures& frame = n < each ? content.now : content.before;
        const Texture& texture = textures == TextureSet::axes ? frame.axes[n % each] : frame.vectors;
        images_[n] = {content.sampler, texture.view, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
        writes_[1 + n].pImageInfo = &images_[n];
    }
}

} // namespace windrow::vulkan
