// What a step on a device is compared with: a seven-point stencil and a copy, over four floats a cell.
#pragma once

#include "gpu/device.h"

#include <glm/vec3.hpp>

namespace windrow::cli {

/// Two fields of cells, from one to the other and back in turns. Move-only.
class PlainPasses {
  public:
    [[nodiscard]] static Result<PlainPasses> create(vulkan::Device& device, glm::ivec3 cells);
    /// Both fields to numbers; before the first pass.
    void fill(VkCommandBuffer commands) const;
    /// Each with the barrier behind it that the next one needs.
    void stencil(VkCommandBuffer commands);
    void copy(VkCommandBuffer commands);

  private:
    void barrier(VkCommandBuffer commands) const;

    const vulkan::Functions* functions_ = nullptr;
    glm::ivec3 cells_{0};
    std::array<std::uint32_t, 3> groups_{};
    vulkan::Buffer fields_[2];
    vulkan::Pipeline pipeline_;
    vulkan::Sets sets_;
    int from_ = 0;
};

} // namespace windrow::cli
