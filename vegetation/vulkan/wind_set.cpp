#include "vegetation/vulkan/wind_set.h"

#include <cstring>
#include <vulkan/vulkan.h>

namespace windrow::vegetation::engine {
namespace {

// Bindings in the order of the include: a uniform block, six textures, the gust tile.
constexpr std::uint32_t k_bindings = 8;

VkDescriptorType type_of(std::uint32_t binding) {
    return binding == 0                ? VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER
           : binding == k_bindings - 1 ? VK_DESCRIPTOR_TYPE_STORAGE_BUFFER
                                       : VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
}

} // namespace

WindSet::WindSet(Device& device) : device_(device.device) {
    VkSamplerCreateInfo sampler_info{}; // any will do: texels are fetched
    sampler_info.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO;
    must(vkCreateSampler(device_, &sampler_info, nullptr, &sampler_), "vkCreateSampler");
    device.at_end([vulkan = device_, made = sampler_] { vkDestroySampler(vulkan, made, nullptr); });

    VkDescriptorSetLayoutBinding bindings[k_bindings]{};
    for (std::uint32_t n = 0; n < k_bindings; ++n)
        bindings[n] = {n, type_of(n), 1, VK_SHADER_STAGE_ALL_GRAPHICS | VK_SHADER_STAGE_COMPUTE_BIT, nullptr};
    VkDescriptorSetLayoutCreateInfo layout_info{};
    layout_info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
    layout_info.bindingCount = k_bindings;
    layout_info.pBindings = bindings;
    must(vkCreateDescriptorSetLayout(device_, &layout_info, nullptr, &layout_), "vkCreateDescriptorSetLayout");
    device.at_end([vulkan = device_, made = layout_] { vkDestroyDescriptorSetLayout(vulkan, made, nullptr); });

    constexpr std::uint32_t sets = k_frames_in_flight;
    const VkDescriptorPoolSize sizes[] = {{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, sets},
                                          {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 6 * sets},
                                          {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, sets}};
    VkDescriptorPoolCreateInfo pool_info{};
    pool_info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
    pool_info.maxSets = sets;
    pool_info.poolSizeCount = 3;
    pool_info.pPoolSizes = sizes;
    VkDescriptorPool pool = VK_NULL_HANDLE;
    must(vkCreateDescriptorPool(device_, &pool_info, nullptr, &pool), "vkCreateDescriptorPool");
    device.at_end([vulkan = device_, pool] { vkDestroyDescriptorPool(vulkan, pool, nullptr); });
    const VkDescriptorSetLayout layouts[k_frames_in_flight] = {layout_, layout_};
    VkDescriptorSetAllocateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO;
    info.descriptorPool = pool;
    info.descriptorSetCount = sets;
    info.pSetLayouts = layouts;
    must(vkAllocateDescriptorSets(device_, &info, sets_), "vkAllocateDescriptorSets");

    for (Buffer& block : blocks_)
        block = device.make_buffer(sizeof(windrow::FrameBlock), VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT);
}

VkDescriptorSet WindSet::of(int slot, const windrow::vulkan::Wind& wind, glm::dvec3 anchor, const windrow::Sampling& sampling) {
    // The frame that used this slot before is done: its block and its set are free to be written.
    const windrow::FrameBlock block = wind.frame_block(anchor, sampling);
    std::memcpy(blocks_[slot].mapped, &block, sizeof(block));
    const VkDescriptorBufferInfo uniform{blocks_[slot].buffer, 0, sizeof(block)};
    const VkDescriptorBufferInfo tile{wind.gust_buffer(), 0, VK_WHOLE_SIZE};
    const windrow::vulkan::Textures now = wind.textures(), before = wind.previous_textures();
    VkDescriptorImageInfo images[k_bindings]{};
    VkWriteDescriptorSet writes[k_bindings]{};
    for (std::uint32_t n = 0; n < k_bindings; ++n) {
        writes[n].sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
        writes[n].dstSet = sets_[slot];
        writes[n].dstBinding = n;
        writes[n].descriptorCount = 1;
        writes[n].descriptorType = type_of(n);
        if (n >= 1 && n <= 6) {
            const VkImageView view = n <= 3 ? now.views[n - 1] : before.views[n - 4];
            images[n] = {sampler_, view, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
            writes[n].pImageInfo = &images[n];
        }
    }
    writes[0].pBufferInfo = &uniform;
    writes[k_bindings - 1].pBufferInfo = &tile;
    vkUpdateDescriptorSets(device_, k_bindings, writes, 0, nullptr);
    return sets_[slot];
}

} // namespace windrow::vegetation::engine
