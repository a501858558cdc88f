// Descriptor set of shaders/coupling/windrow_wind.glsl, which an engine adds to its own sets.
#pragma once

#include "../../fluid/vulkan/wind.h"
#include "cpu_wind.h"
#include "descriptors.h"

#include <glm/vec3.hpp>

namespace windrow::vegetation::engine {

/// A wind that shaders sample, on the device or on the CPU, in the frame last recorded: what functions take that record what
/// samples it. The wind outlives it.
struct SampledWind {
    SampledWind(const vulkan::Wind& wind)
        : reader(&wind), boundaries(wind.config().boundaries), textures(wind.textures()),
          previous_textures(wind.previous_textures()), gust_buffer(wind.gust_buffer()) {}
    SampledWind(const CpuWind& wind)
        : reader(&wind.air()), boundaries(wind.air().config().boundaries), textures(wind.textures()),
          previous_textures(wind.previous_textures()), gust_buffer(wind.gust_buffer()) {}

    const WindReader* reader;
    Boundaries boundaries;
    vulkan::Textures textures, previous_textures; ///< of that frame, and of the one before
    VkBuffer gust_buffer;
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
