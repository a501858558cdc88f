#include "cli/device_report/wind_bindings.h"

#include <cstring>
#include <utility>

namespace windrow::cli {

using namespace vulkan;

std::vector<VkDescriptorType> WindBindings::kinds() {
    constexpr VkDescriptorType texture = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
    return {VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, texture, texture, texture, texture, texture, texture,
            VK_DESCRIPTOR_TYPE_STORAGE_BUFFER};
}

Result<WindBindings> WindBindings::create(Device& device, const Boundaries&) {
    WindBindings made;
    auto block = Buffer::create(device, sizeof(FrameBlock), MemoryUse::upload, VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
    if (!block)
        return Error{block.error()};
    made.block_ = *std::move(block);
    VkSamplerCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO;
    if (const VkResult result = make(device.functions(), device.host(), device.functions().vkCreateSampler, info, made.sampler_);
        result != VK_SUCCESS)
        return call_error("vkCreateSampler", "the wind's textures", result);
    return made;
}

std::vector<Binding> WindBindings::of(const vulkan::Wind& wind, glm::dvec3 anchor, const Sampling& sampling) {
    const FrameBlock content = wind.frame_block(anchor, sampling);
    std::memcpy(block_.mapped(), &content, sizeof content);
    (void)block_.flush(); // memory for uploads is coherent
    std::vector<Binding> bindings = {{.type = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, .buffer = block_.handle()}};
    for (const Textures& frame : {wind.textures(), wind.previous_textures()})
        for (const VkImageView view : frame.views)
            bindings.push_back({.type = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, .view = view, .sampler = sampler_.get()});
    bindings.push_back({.type = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, .buffer = wind.gust_buffer()});
    return bindings;
}

} // namespace windrow::cli
