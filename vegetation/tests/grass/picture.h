// A picture of a field's blades, drawn as a host would: colour and depth of one sample.
#pragma once

#include "vegetation/grass/grass_field.h"
#include "vegetation/vulkan/canvas.h"

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <span>
#include <vector>

namespace windrow::vegetation::grass::test {

class Picture {
  public:
    static constexpr VkExtent2D k_extent{480, 270};

    /// What the pipeline is made of; the field's own set is the last.
    struct Recipe {
        std::vector<VkDescriptorSetLayout> sets;
        std::span<const std::uint32_t> vertex, fragment;
    };
    Picture(engine::Device& device, const Recipe& recipe);
    /// vegetation/tests/grass/shaders/still.vert: an even wind of 1.5 m/s along x.
    [[nodiscard]] static Recipe still(const GrassField& field);

    /// Records the drawing of a view over black.
    void record(VkCommandBuffer commands, const GrassField& field, const glm::mat4& view_projection, View view,
                VkDescriptorSet wind = VK_NULL_HANDLE) const;
    /// Of the last drawing that is done.
    [[nodiscard]] std::vector<std::uint32_t> pixels() const;
    static constexpr std::size_t k_pixels = std::size_t{k_extent.width} * k_extent.height;

  private:
    engine::Objects objects_;
    std::uint32_t grass_set_ = 0;
    engine::Canvas canvas_;
    VkPipelineLayout layout_ = VK_NULL_HANDLE;
    VkPipeline pipeline_ = VK_NULL_HANDLE;
};

} // namespace windrow::vegetation::grass::test
