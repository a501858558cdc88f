// Map of a noise that does not change, about a place that moves: filled once, then by strips. It repeats: texel t of the noise is texel
// t mod size of the map (shaders/render/noise_map.glsl).
#pragma once

#include "../vulkan/objects.h"

#include <glm/vec2.hpp>
#include <vector>

namespace windrow::vegetation::render {

/// Texels from `first` to before `end`.
struct TexelRectangle {
    glm::ivec2 first{0}, end{0};

    [[nodiscard]] bool empty() const { return end.x <= first.x || end.y <= first.y; }
    bool operator==(const TexelRectangle&) const = default;
};

/// What is in `wanted` and not in `filled`, in at most four rectangles that do not overlap.
void append_unfilled(const TexelRectangle& wanted, const TexelRectangle& filled, std::vector<TexelRectangle>& to);

struct NoiseMapRecipe {
    int texels = 0;                                                     ///< a side; 0: a texel that nothing reads
    float texel = 1.0f;                                                 ///< its size, in the unit of the noise's places
    TexelRectangle bounds{glm::ivec2(-(1 << 28)), glm::ivec2(1 << 28)}; ///< nothing is asked for beyond
    VkFormat format = VK_FORMAT_UNDEFINED;
    std::span<const std::uint32_t> fill{}; ///< compute shader: the image at set 0, binding 0; pushed first texel and their number
};

class NoiseMap {
  public:
    NoiseMap(engine::Objects& objects, const NoiseMapRecipe& recipe);

    /// Outside of a render pass, before the passes that read it. `middle` in the unit of the noise's places.
    void record(VkCommandBuffer commands, glm::vec2 middle);
    /// In VK_IMAGE_LAYOUT_GENERAL.
    [[nodiscard]] VkImageView view() const { return image_.view; }
    /// Linear; the map repeats.
    [[nodiscard]] VkSampler sampler() const { return sampler_; }

  private:
    NoiseMapRecipe recipe_;
    TexelRectangle filled_{};
    bool fresh_ = true;
    engine::Image image_{};
    VkSampler sampler_ = VK_NULL_HANDLE;
    VkPipelineLayout layout_ = VK_NULL_HANDLE;
    VkPipeline pipeline_ = VK_NULL_HANDLE;
    VkDescriptorSet set_ = VK_NULL_HANDLE;
    std::vector<TexelRectangle> rest_{};
};

} // namespace windrow::vegetation::render
