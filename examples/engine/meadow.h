// The meadow's three draws: sky and soil, walker and fan, grass.
#pragma once

#include "vegetation/vulkan/device.h"

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <span>

namespace windrow::vegetation::engine {

/// What every shader is told: shaders/scene.glsl says more. 128 bytes.
struct Scene {
    glm::mat4 view_projection{1.0f};
    glm::vec4 eye{0.0f};
    glm::vec4 walker{0.0f};
    glm::vec4 fan{0.0f};
    glm::vec4 fan_axis{0.0f};
};
static_assert(sizeof(Scene) == 128);

class Meadow {
  public:
    /// Grass reads the wind from a set of this layout.
    Meadow(Device& device, VkRenderPass render_pass, VkDescriptorSetLayout wind);

    /// Within the render pass.
    void draw(VkCommandBuffer commands, const Scene& scene, VkDescriptorSet wind) const;

  private:
    struct Recipe {
        std::span<const std::uint32_t> vertex, fragment;
        VkPrimitiveTopology topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
        bool depth = true;
    };
    [[nodiscard]] VkPipeline make(Device& device, VkRenderPass render_pass, const Recipe& recipe) const;

    VkPipelineLayout layout_ = VK_NULL_HANDLE;
    VkPipeline sky_ = VK_NULL_HANDLE, figures_ = VK_NULL_HANDLE, grass_ = VK_NULL_HANDLE;
};

} // namespace windrow::vegetation::engine
