// Descriptor set of shaders/coupling/windrow_wind.glsl, which an engine adds to its own sets.
#pragma once

#include "../../fluid/vulkan/wind.h"
#include "cpu_wind.h"
#include "descriptors.h"

#include <glm/vec3.hpp>

namespace windrow::vegetation::engine {

/// A wind that shaders sample, on the device or on the CPU: what functions take that record a frame. The wind outlives it.
class SampledWind {
  public:
    SampledWind(const vulkan::Wind& wind) : device_(&wind) {}
    SampledWind(const CpuWind& wind) : cpu_(&wind) {}

    /// Of the frame last recorded, and of the one before.
    [[nodiscard]] vulkan::Textures textures() const { return cpu_ ? cpu_->textures() : device_->textures(); }
    [[nodiscard]] vulkan::Textures previous_textures() const {
        return cpu_ ? cpu_->previous_textures() : device_->previous_textures();
    }
    [[nodiscard]] FrameBlock frame_block(glm::dvec3 anchor, const Sampling& sampling) const {
        return cpu_ ? cpu_->frame_block(anchor, sampling) : device_->frame_block(anchor, sampling);
    }
    [[nodiscard]] VkBuffer gust_buffer() const { return cpu_ ? cpu_->gust_buffer() : device_->gust_buffer(); }
    [[nodiscard]] const Boundaries& boundaries() const { return (cpu_ ? cpu_->config() : device_->config()).boundaries; }

  private:
    const vulkan::Wind* device_ = nullptr; ///< this or the next
    const CpuWind* cpu_ = nullptr;
};

class WindSet {
  public:
    explicit WindSet(Objects& objects);

    [[nodiscard]] VkDescriptorSetLayout layout() const { return layout_; }
    /// The set of a frame in flight, filled for the current position of the wind. Positions in shaders are relative to `anchor`
    /// [m]. Throws Failure where the wind writes three textures alone (Settings::textures).
    [[nodiscard]] VkDescriptorSet of(int slot, const SampledWind& wind, glm::dvec3 anchor, const Sampling& sampling);

  private:
    VkSampler sampler(const Boundaries& boundaries);

    Objects& objects_;
    VkDescriptorSetLayout layout_ = VK_NULL_HANDLE;
    std::array<VkSampler, 8> samplers_{}; ///< by the axes that are periodic; made when first needed
    std::array<VkDescriptorSet, k_frames_in_flight> sets_{};
    FrameBuffers blocks_{};
};

} // namespace windrow::vegetation::engine
