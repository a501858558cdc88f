// A picture of a field's blades, drawn as a host would: colour and depth of one sample.
#pragma once

#include "vegetation/grass/grass_field.h"

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
    Picture(const windrow::vulkan::Host& host, const Recipe& recipe);
    /// vegetation/tests/grass/shaders/still.vert: an even wind of 1.5 m/s along x.
    [[nodiscard]] static Recipe still(const GrassField& field);
    Picture(const Picture&) = delete;
    Picture& operator=(const Picture&) = delete;
    ~Picture();

    /// Records the drawing of a view over black, and the copy of the picture into a buffer of 4 bytes a pixel.
    void record(VkCommandBuffer commands, const GrassField& field, const glm::mat4& view_projection, View view, VkBuffer into,
                VkDescriptorSet wind = VK_NULL_HANDLE) const;
    static constexpr std::size_t k_pixels = std::size_t{k_extent.width} * k_extent.height;

  private:
    struct Attachment {
        VkImage image = VK_NULL_HANDLE;
        VkDeviceMemory memory = VK_NULL_HANDLE;
        VkImageView view = VK_NULL_HANDLE;
    };
    Attachment make_attachment(VkFormat format, VkImageUsageFlags usage, VkImageAspectFlags aspect);
    void make_render_pass();
    void make_pipeline(const Recipe& recipe);

    windrow::vulkan::Host host_;
    std::uint32_t grass_set_ = 0;
    Attachment colour_, depth_;
    VkRenderPass render_pass_ = VK_NULL_HANDLE;
    VkFramebuffer framebuffer_ = VK_NULL_HANDLE;
    VkPipelineLayout layout_ = VK_NULL_HANDLE;
    VkPipeline pipeline_ = VK_NULL_HANDLE;
};

} // namespace windrow::vegetation::grass::test
