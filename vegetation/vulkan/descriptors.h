// Descriptor sets: a layout from a list of bindings, sets of it, and what they point to.
#pragma once

#include "objects.h"

namespace windrow::vegetation::engine {

/// The stages that the renderer has.
inline constexpr VkShaderStageFlags k_stages =
    VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT | VK_SHADER_STAGE_COMPUTE_BIT;

struct Binding {
    VkDescriptorType type = VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
    VkShaderStageFlags stages = k_stages;
};

/// Bindings 0, 1, 2 ... in their order.
[[nodiscard]] VkDescriptorSetLayout make_layout(Objects& objects, std::span<const Binding> bindings);
/// `sets.size()` sets from a pool of their own.
void make_sets(Objects& objects, VkDescriptorSetLayout layout, std::span<const Binding> bindings,
               std::span<VkDescriptorSet> sets);
/// A whole buffer.
void point(const Device& device, VkDescriptorSet set, std::uint32_t binding, VkDescriptorType type, VkBuffer buffer);
/// An image in VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL (or, of depth, DEPTH_STENCIL_READ_ONLY_OPTIMAL) and its sampler.
void point(const Device& device, VkDescriptorSet set, std::uint32_t binding, VkImageView view, VkSampler sampler,
           VkImageLayout layout);

/// An image that shaders store to, in VK_IMAGE_LAYOUT_GENERAL.
void point(const Device& device, VkDescriptorSet set, std::uint32_t binding, VkImageView view);

} // namespace windrow::vegetation::engine
