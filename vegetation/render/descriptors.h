// Descriptor sets: a layout from a list of bindings, sets of it, what they point to, and buffers filled for them.
#pragma once

#include "vegetation/vulkan/device.h"

#include <cstring>
#include <span>
#include <vector>

namespace windrow::vegetation::render {

/// The stages that the renderer has.
inline constexpr VkShaderStageFlags k_stages =
    VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT | VK_SHADER_STAGE_COMPUTE_BIT;

struct Binding {
    VkDescriptorType type = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
    VkShaderStageFlags stages = k_stages;
};

/// Bindings 0, 1, 2 ... in their order.
[[nodiscard]] VkDescriptorSetLayout make_layout(engine::Device& device, std::span<const Binding> bindings);
/// `sets.size()` sets from a pool of their own.
void make_sets(engine::Device& device, VkDescriptorSetLayout layout, std::span<const Binding> bindings,
               std::span<VkDescriptorSet> sets);
/// A whole buffer.
void point(engine::Device& device, VkDescriptorSet set, std::uint32_t binding, VkDescriptorType type, VkBuffer buffer);
/// An image in VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL (or, of depth, DEPTH_STENCIL_READ_ONLY_OPTIMAL) and its sampler.
void point(engine::Device& device, VkDescriptorSet set, std::uint32_t binding, VkImageView view, VkSampler sampler,
           VkImageLayout layout);

/// A buffer that holds what `from` holds; at least one element.
template <class T>
[[nodiscard]] engine::Buffer filled(engine::Device& device, const std::vector<T>& from, VkBufferUsageFlags usage) {
    engine::Buffer made = device.make_buffer(sizeof(T) * from.size(), usage);
    std::memcpy(made.mapped, from.data(), sizeof(T) * from.size());
    return made;
}

} // namespace windrow::vegetation::render
