// The descriptor set that shaders/coupling/windrow_wind.glsl wants: what an engine adds to its own sets to have the wind.
#pragma once

#include "vegetation/vulkan/frames.h"
#include "fluid/vulkan/wind.h"

#include <glm/vec3.hpp>

namespace windrow::vegetation::engine {

class WindSet {
  public:
    explicit WindSet(Device& device);

    [[nodiscard]] VkDescriptorSetLayout layout() const { return layout_; }
    /// The set of a frame in flight, told where the wind lies now. Positions in shaders are relative to `anchor` [m].
    [[nodiscard]] VkDescriptorSet of(int slot, const windrow::vulkan::Wind& wind, glm::dvec3 anchor,
                                     const windrow::Sampling& sampling);

  private:
    VkDevice device_ = VK_NULL_HANDLE;
    VkDescriptorSetLayout layout_ = VK_NULL_HANDLE;
    VkSampler sampler_ = VK_NULL_HANDLE;
    VkDescriptorSet sets_[k_frames_in_flight]{};
    Buffer blocks_[k_frames_in_flight]{};
};

} // namespace windrow::vegetation::engine
