// Blur of what moves while a shutter is open: passes between the picture's light and its tones, along the motion vectors.
//
//     streak     motion and depth of each pixel -> half a streak [px] and distance      width x height
//     longest    of a tile's row, of a tile, of a tile and its eight neighbours          a texel a tile
//     gather     light and all of these -> light as the shutter sees it                  width x height
//
// vegetation/shaders/numerics/motion_blur.glsl has the weights and whose work they are based on. Where nothing moves the light
// comes out with the same bits.
#pragma once

#include "targets.h"

#include <array>

namespace windrow::vegetation::render {

class MotionBlur {
  public:
    /// `images` have TargetSettings::blurred and outlive it, as `frame`, set 0 of all passes. `shutter_deg` is above 0, at most 360.
    MotionBlur(engine::Objects& objects, const Targets& images, VkDescriptorSetLayout frame, float shutter_deg);

    /// [px] The longest half of a streak, and a tile's width: an 18th of the picture's height, 8 at least.
    [[nodiscard]] int most() const { return most_; }
    /// After the scene's pass: the light of `images` is blurred.
    void record(VkCommandBuffer commands, VkDescriptorSet frame) const;

  private:
    /// BlurPush of vegetation/shaders/render/blur_passes.glsl.
    struct Push {
        glm::ivec2 stride{1}, count{1};
        float open = 0.0f, most = 0.0f;
    };
    /// A pass over a map of its own, or over the blurred light.
    struct Step {
        const engine::RenderPass* pass = nullptr;
        VkPipeline pipeline = VK_NULL_HANDLE;
        VkDescriptorSet inputs = VK_NULL_HANDLE;
        Push push{};
    };

    int most_;
    VkPipelineLayout layout_ = VK_NULL_HANDLE;
    std::array<engine::Image, 4> maps_{}; ///< streak, then the three of longest
    std::array<std::optional<engine::RenderPass>, 4> passes_{};
    std::array<VkDescriptorSet, 5> inputs_{};
    std::array<Step, 5> steps_{};
};

} // namespace windrow::vegetation::render
