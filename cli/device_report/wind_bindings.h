// The wind's bindings of shaders/coupling/windrow_wind.glsl, for a host that waits for each frame.
#pragma once

#include "fluid/vulkan/device.h"
#include "fluid/vulkan/wind.h"

#include <vector>

namespace windrow::cli {

class WindBindings {
  public:
    /// Kinds of the bindings, in order.
    [[nodiscard]] static std::vector<VkDescriptorType> kinds();
    /// For winds with these boundaries.
    [[nodiscard]] static Result<WindBindings> create(vulkan::Device& device, const Boundaries& boundaries);
    /// Of the frame last recorded; nothing that uses them is in flight.
    [[nodiscard]] std::vector<vulkan::Binding> of(const vulkan::Wind& wind, glm::dvec3 anchor, const Sampling& sampling = {});

  private:
    vulkan::Buffer block_;
    vulkan::Handle<VkSampler, &vulkan::Functions::vkDestroySampler> sampler_;
};

} // namespace windrow::cli
