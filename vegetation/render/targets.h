// Offscreen render targets: light and motion with multisampling and their resolves, depth, the light that a shutter sees, the
// toned picture, and read-back to the host.
#pragma once

#include "../vulkan/pipeline.h"
#include "../vulkan/render_pass.h"
#include "picture.h"

#include <optional>

namespace windrow::vegetation::render {

struct TargetSettings {
    VkExtent2D extent{};
    VkSampleCountFlagBits samples = VK_SAMPLE_COUNT_4_BIT; ///< 1 or 4, which every device has, or 2 where draws_with
    int light_bytes = 8;  ///< a sample: 8, or 4 where the device draws to B10G11R11; else 8 all the same
    bool blurred = false; ///< light is blurred (MotionBlur) before it is toned
};

class Targets {
  public:
    Targets(engine::Objects& objects, const TargetSettings& settings);

    [[nodiscard]] VkExtent2D extent() const { return extent_; }
    [[nodiscard]] VkSampleCountFlagBits samples() const { return samples_; }
    /// [bytes] A sample of light: 8, RGBA16F; 4, B10G11R11 of 6, 6 and 5 bits.
    [[nodiscard]] int light_bytes() const { return light_format_ == VK_FORMAT_R16G16B16A16_SFLOAT ? 8 : 4; }
    /// The pass that draws light (attachment 0, RGBA16F or B10G11R11) and motion (1, RG16F).
    [[nodiscard]] const engine::RenderPass& scene() const { return *scene_; }
    [[nodiscard]] engine::PassTarget scene_target() const { return {scene_->handle(), samples_, 2, true}; }
    /// With TargetSettings::blurred: what a blur reads, and its pass, which draws light from the scene's.
    [[nodiscard]] VkImageView drawn_light() const { return resolved_light().view; }
    [[nodiscard]] VkImageView motion() const { return resolved_motion().view; }
    [[nodiscard]] VkImageView depth() const { return depth_.view; } ///< of `samples()` samples
    [[nodiscard]] const engine::RenderPass& blurred() const { return *blurred_; }
    /// The pass that draws the picture (RGBA8, sRGB) from `light()`.
    [[nodiscard]] const engine::RenderPass& toned() const { return *toned_; }
    [[nodiscard]] engine::PassTarget toned_target() const { return {toned_->handle(), VK_SAMPLE_COUNT_1_BIT, 1, false}; }
    [[nodiscard]] VkImageView light() const { return shown_light().view; }
    /// The toned picture, in VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL after its pass; to be sampled by a window too.
    [[nodiscard]] const engine::Image& toned_image() const { return picture_; }

    /// After both passes: copies all to the host.
    void copy(VkCommandBuffer commands) const;
    /// After the copy is done.
    [[nodiscard]] Picture8 picture() const;
    [[nodiscard]] PictureF light_picture() const;  ///< three channels, linear, before exposure
    [[nodiscard]] PictureF motion_picture() const; ///< two channels: fractions of the picture's size, x right, y down

  private:
    [[nodiscard]] const engine::Image& shown_light() const { return blurred_ ? blurred_light_ : resolved_light(); }
    [[nodiscard]] const engine::Image& resolved_light() const { return samples_ == VK_SAMPLE_COUNT_1_BIT ? light_ : light_one_; }
    [[nodiscard]] const engine::Image& resolved_motion() const {
        return samples_ == VK_SAMPLE_COUNT_1_BIT ? motion_ : motion_one_;
    }

    const engine::Device& device_;
    VkExtent2D extent_{};
    VkSampleCountFlagBits samples_{};
    VkFormat light_format_ = VK_FORMAT_UNDEFINED;
    engine::Image light_{}, motion_{}, depth_{}, light_one_{}, motion_one_{}, blurred_light_{}, picture_{};
    engine::Buffer light_bytes_{}, motion_bytes_{}, picture_bytes_{};
    std::optional<engine::RenderPass> scene_{}, blurred_{}, toned_{};
};

/// Whether a device draws pictures of so many samples a pixel.
[[nodiscard]] bool draws_with(const engine::Device& device, VkSampleCountFlagBits samples);
/// A format that depth is drawn to with more than 16 bits: one of two that every device has.
[[nodiscard]] VkFormat depth_format(const engine::Device& device);

} // namespace windrow::vegetation::render
