// The textures of a wind on the device, and the descriptor set that shows them to shaders/coupling/windrow_wind.glsl.
//
//     const auto bindings = set_bindings(TextureSet::vectors, VK_SHADER_STAGE_VERTEX_BIT);    // for the layout of the set
//     vkCreateSampler(device, &sampler, ...);                                                 // sampler_info(boundaries)
//     const SetWrites writes(set, {.now = wind.textures(), .before = wind.previous_textures(), .sampler = sampler,
//                                  .block = {buffer, offset, sizeof(FrameBlock)}, .tile = wind.gust_buffer()});
//     vkUpdateDescriptorSets(device, writes.size(), writes.data(), 0, nullptr);               // once a frame
//
// Nothing here calls Vulkan or allocates: a host whose solver is on the CPU gives textures of its own.
#pragma once

#include "../api.h"
#include "../boundaries.h"
#include "../textures.h"

#include <array>
#include <cstdint>
#include <vulkan/vulkan_core.h>

namespace windrow::vulkan {

/// Format of the textures.
enum class Texel : std::uint8_t {
    half,  ///< RGBA16F and R16F: 11 bits, enough for plants. The default.
    single ///< RGBA32F and R32F, which not every device filters: there a shader defines WINDROW_EXACT
};

/// Textures of a frame.
enum class TextureSet : std::uint8_t {
    vectors, ///< one of four components: velocity and 0. One fetch a sample; 8 bytes a cell in half. The default.
    axes,    ///< three of one component. Three fetches a sample; 6 bytes a cell in half. WINDROW_THREE_TEXTURES in a shader
    both     ///< all four, for shaders of both kinds
};
/// Where a set has four components in one, and where three components apart.
[[nodiscard]] constexpr bool has_vectors(TextureSet set) {
    return set != TextureSet::axes;
}
[[nodiscard]] constexpr bool has_axes(TextureSet set) {
    return set != TextureSet::vectors;
}

struct Texture {
    VkImage image = VK_NULL_HANDLE;
    VkImageView view = VK_NULL_HANDLE;
};

/// The textures of a frame, in VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL for every shader stage that comes after the recording in
/// submission order. What Settings::textures leaves out is null.
struct Textures {
    Texture vectors{};             ///< as WindView::write_vectors has them
    std::array<Texture, 3> axes{}; ///< x, y, z
};

/// Sampler of the textures: linear, repeating along periodic axes, clamped to the edge along others. A new kind of boundary may need
/// another one; WINDROW_EXACT takes any.
[[nodiscard]] WINDROW_API VkSamplerCreateInfo sampler_info(const Boundaries& boundaries);

/// Most bindings of a set: those of three textures.
inline constexpr std::uint32_t k_max_bindings = 8;

/// The bindings of windrow_wind.glsl, for VkDescriptorSetLayoutCreateInfo.
class SetBindings {
  public:
    [[nodiscard]] std::uint32_t size() const { return size_; }
    [[nodiscard]] const VkDescriptorSetLayoutBinding* data() const { return bindings_.data(); }
    [[nodiscard]] const VkDescriptorSetLayoutBinding* begin() const { return data(); }
    [[nodiscard]] const VkDescriptorSetLayoutBinding* end() const { return data() + size_; }

  private:
    friend SetBindings set_bindings(TextureSet textures, VkShaderStageFlags stages, std::uint32_t first);
    std::array<VkDescriptorSetLayoutBinding, k_max_bindings> bindings_{};
    std::uint32_t size_ = 0;
};
/// `textures` is what the shader samples: axes with WINDROW_THREE_TEXTURES, else vectors (`both` counts as that). `first` is its
/// WINDROW_BINDING.
[[nodiscard]] WINDROW_API SetBindings set_bindings(TextureSet textures, VkShaderStageFlags stages, std::uint32_t first = 0);

/// Contents of a set.
struct SetContent {
    Textures now, before;           ///< Wind::textures, Wind::previous_textures
    VkSampler sampler;              ///< as sampler_info; null where the layout has immutable samplers
    VkDescriptorBufferInfo block;   ///< FrameBlock; its offset a multiple of minUniformBufferOffsetAlignment
    VkBuffer tile = VK_NULL_HANDLE; ///< Wind::gust_buffer, or any storage buffer of 16 bytes where there are no gusts
};

/// The writes of a set, for vkUpdateDescriptorSets or for push descriptors. They point into this object.
class WINDROW_API SetWrites {
  public:
    /// `textures` and `first` as of set_bindings.
    SetWrites(VkDescriptorSet set, const SetContent& content, TextureSet textures = TextureSet::vectors, std::uint32_t first = 0);
    SetWrites(const SetWrites&) = delete;
    SetWrites& operator=(const SetWrites&) = delete;
    [[nodiscard]] std::uint32_t size() const { return size_; }
    [[nodiscard]] const VkWriteDescriptorSet* data() const { return writes_.data(); }

  private:
    std::array<VkWriteDescriptorSet, k_max_bindings> writes_{};
    std::array<VkDescriptorImageInfo, k_max_bindings> images_{};
    VkDescriptorBufferInfo block_, tile_;
    std::uint32_t size_ = 0;
};

} // namespace windrow::vulkan
