#include "cli/device_report/wind_bindings.h"

#include <cstring>
#include <utility>

namespace windrow::cli {

using namespace vulkan;

std::vector<VkDescriptorType> WindBindings::kinds() {
    std::vector<VkDescriptorType> kinds;
    for (const VkDescriptorSetLayoutBinding& binding : set_bindings(TextureSet::vectors, VK_SHADER_STAGE_ALL))
        kinds.push_back(binding.descriptorType);
    return kinds;
}

Result<WindBindings> WindBindings::create(Device& device, const Boundaries& boundaries) {
    WindBindings made;
    auto block = Buffer::create(device, sizeof(FrameBlock), MemoryUse::upload, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
    if (!block)
        return Error{block.error()};
    made.block_ = *std::move(block);
    const VkSamplerCreateInfo info = sampler_info(boundaries);
    if (const VkResult result = make(device.functions(), device.host(), device.functions().vkCreateSampler, info, made.sampler_);
        result != VK_SUCCESS)
        return call_error("vkCreateSampler", "the wind's textures", result);
    return made;
}

std::vector<Binding> WindBindings::of(const vulkan::Wind& wind, glm::dvec3 anchor, const Sampling& sampling) {
    const FrameBlock content = wind.frame_block(anchor, sampling);
    std::memcpy(block_.mapped(), &content, sizeof content);
    (void)block_.flush(); // memory for uploads is coherent
    const auto texture = [&](const Textures& frame) {
        return Binding{.type = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, .view = frame.vectors.view, .sampler = sampler_.get()};
    };
    return {{.type = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, .buffer = block_.handle()},
            texture(wind.textures()),
            texture(wind.previous_textures()),
            {.type = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, .buffer = wind.gust_buffer()}};
}

} // namespace windrow::cli
