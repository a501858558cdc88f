#include "vegetation/vulkan/descriptors.h"

#include "vegetation/vulkan/calls.h"

#include <map>

namespace windrow::vegetation::engine {
namespace {

void write(const Device& device, VkDescriptorSet set, std::uint32_t binding, VkDescriptorType type,
           const VkDescriptorBufferInfo* buffer, const VkDescriptorImageInfo* image) {
    VkWriteDescriptorSet all{};
    all.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
    all.dstSet = set;
    all.dstBinding = binding;
    all.descriptorCount = 1;
    all.descriptorType = type;
    all.pBufferInfo = buffer;
    all.pImageInfo = image;
    vkUpdateDescriptorSets(device.handle(), 1, &all, 0, nullptr);
}

} // namespace

VkDescriptorSetLayout make_layout(Objects& objects, std::span<const Binding> bindings) {
    std::vector<VkDescriptorSetLayoutBinding> list;
    SharedKey key(SharedKind::set_layout);
    for (const Binding& binding : bindings) {
        list.push_back({static_cast<std::uint32_t>(list.size()), binding.type, 1, binding.stages, nullptr});
        key.add(binding.type).add(binding.stages);
    }
    VkDescriptorSetLayoutCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
    info.bindingCount = static_cast<std::uint32_t>(list.size());
    info.pBindings = list.data();
    return objects.shared(key, [&](Objects& owner) {
        return owner.make(vkCreateDescriptorSetLayout, vkDestroyDescriptorSetLayout, info, "vkCreateDescriptorSetLayout");
    });
}

void make_sets(Objects& objects, VkDescriptorSetLayout layout, std::span<const Binding> bindings,
               std::span<VkDescriptorSet> sets) {
    const auto count = static_cast<std::uint32_t>(sets.size());
    std::map<VkDescriptorType, std::uint32_t> of_type;
    for (const Binding& binding : bindings)
        of_type[binding.type] += count;
    std::vector<VkDescriptorPoolSize> sizes;
    for (const auto& [type, number] : of_type)
        sizes.push_back({type, number});
    VkDescriptorPoolCreateInfo pool_info{};
    pool_info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
    pool_info.maxSets = count;
    pool_info.poolSizeCount = static_cast<std::uint32_t>(sizes.size());
    pool_info.pPoolSizes = sizes.data();
    const VkDescriptorPool pool =
        objects.make(vkCreateDescriptorPool, vkDestroyDescriptorPool, pool_info, "vkCreateDescriptorPool");
    const std::vector<VkDescriptorSetLayout> layouts(count, layout);
    VkDescriptorSetAllocateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO;
    info.descriptorPool = pool;
    info.descriptorSetCount = count;
    info.pSetLayouts = layouts.data();
    must(vkAllocateDescriptorSets(objects.device().handle(), &info, sets.data()), "vkAllocateDescriptorSets");
}

void point(const Device& device, VkDescriptorSet set, std::uint32_t binding, VkDescriptorType type, VkBuffer buffer) {
    const VkDescriptorBufferInfo whole{buffer, 0, VK_WHOLE_SIZE};
    write(device, set, binding, type, &whole, nullptr);
}

void point(const Device& device, VkDescriptorSet set, std::uint32_t binding, VkImageView view, VkSampler sampler,
           VkImageLayout layout) {
    const VkDescriptorImageInfo image{sampler, view, layout};
    write(device, set, binding, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, nullptr, &image);
}

void point(const Device& device, VkDescriptorSet set, std::uint32_t binding, VkImageView view) {
    const VkDescriptorImageInfo image{VK_NULL_HANDLE, view, VK_IMAGE_LAYOUT_GENERAL};
    write(device, set, binding, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE, nullptr, &image);
}

} // namespace windrow::vegetation::engine
