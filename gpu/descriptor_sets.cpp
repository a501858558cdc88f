#include "gpu/descriptor_sets.h"

#include "fluid/core/message.h"
#include "gpu/device.h"
#include "gpu/functions.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <string>

namespace windrow::vulkan {
namespace {

[[maybe_unused]] bool matches(const Sets::Content& content) {
    const auto same = [](const Binding& binding, const VkDescriptorSetLayoutBinding& other) {
        return binding.type == other.descriptorType && other.descriptorCount == 1;
    };
    return content.bindings.empty() || std::equal(content.bindings.begin(), content.bindings.end(),
                                                  content.layout->bindings().begin(), content.layout->bindings().end(), same);
}

VkImageLayout image_layout_of(const Binding& binding) {
    if (binding.type == VK_DESCRIPTOR_TYPE_STORAGE_IMAGE)
        return VK_IMAGE_LAYOUT_GENERAL;
    return binding.view == VK_NULL_HANDLE ? VK_IMAGE_LAYOUT_UNDEFINED : VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
}

void write_set(const Functions& functions, VkDevice device, VkDescriptorSet set, const std::vector<Binding>& bindings) {
    std::vector<VkDescriptorBufferInfo> buffers(bindings.size());
    std::vector<VkDescriptorImageInfo> images(bindings.size());
    std::vector<VkWriteDescriptorSet> writes;
    for (std::size_t n = 0; n < bindings.size(); ++n) {
        const Binding& binding = bindings[n];
        buffers[n] = {binding.buffer, 0, binding.bytes};
        images[n] = {binding.sampler, binding.view, image_layout_of(binding)};
        writes.push_back({.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                          .pNext = nullptr,
                          .dstSet = set,
                          .dstBinding = static_cast<std::uint32_t>(n),
                          .dstArrayElement = 0,
                          .descriptorCount = 1,
                          .descriptorType = binding.type,
                          .pImageInfo = &images[n],
                          .pBufferInfo = &buffers[n],
                          .pTexelBufferView = nullptr});
    }
    functions.vkUpdateDescriptorSets(device, static_cast<std::uint32_t>(writes.size()), writes.data(), 0, nullptr);
}

} // namespace

Result<Sets> Sets::create(Device& device, std::span<const Content> contents) {
    Sets sets;
    if (contents.empty())
        return sets;
    std::map<VkDescriptorType, std::uint32_t> counts;
    std::vector<VkDescriptorSetLayout> layouts;
    for (const Content& content : contents) {
        assert(matches(content));
        layouts.push_back(content.layout->set_layout());
        for (const VkDescriptorSetLayoutBinding& binding : content.layout->bindings())
            counts[binding.descriptorType] += binding.descriptorCount;
    }
    std::vector<VkDescriptorPoolSize> sizes;
    for (const auto& [type, count] : counts)
        sizes.push_back({type, count});

    const Functions& functions = device.functions();
    const Host& host = device.host();
    const std::string what = detail::message(contents.size(), " descriptor sets");
    VkDescriptorPoolCreateInfo pool_info{};
    pool_info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
    pool_info.maxSets = static_cast<std::uint32_t>(contents.size());
    pool_info.poolSizeCount = static_cast<std::uint32_t>(sizes.size());
    pool_info.pPoolSizes = sizes.data();
    if (const VkResult result = make(functions, host, functions.vkCreateDescriptorPool, pool_info, sets.pool_);
        result != VK_SUCCESS)
        return call_error("vkCreateDescriptorPool", what, result);

    sets.sets_.resize(contents.size());
    VkDescriptorSetAllocateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO;
    info.descriptorPool = sets.pool_.get();
    info.descriptorSetCount = static_cast<std::uint32_t>(layouts.size());
    info.pSetLayouts = layouts.data();
    if (const VkResult result = functions.vkAllocateDescriptorSets(host.device, &info, sets.sets_.data()); result != VK_SUCCESS)
        return call_error("vkAllocateDescriptorSets", what, result);
    for (std::size_t n = 0; n < contents.size(); ++n)
        write_set(functions, host.device, sets.sets_[n], contents[n].bindings);
    return sets;
}

} // namespace windrow::vulkan
