// The wind itself, drawn into the scene: arrows on a lattice of places, or a level slice of coloured tiles. For those who want to
// see what the plants feel; both sample the wind as plants do.
#pragma once

#include "vegetation/render/drawable.h"
#include "vegetation/vulkan/frames.h"

#include <array>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace windrow::vegetation::render {

struct WindArrowSettings {
    enum class Form { arrows, slice };
    Form form = Form::arrows;
    float spacing = 1.0f;        ///< [m] of the lattice, 0.05 to 1000
    glm::ivec3 count{32, 3, 32}; ///< places along x, y, z, 1 to 512 each, 1e6 at most in all; a slice has one level
    float lowest = 1.0f;         ///< [m] above the ground, -1e4 to 1e4
    float scale = 8.0f;          ///< [m/s] at the top of the colour scale, above 0 to 1e3
    float seconds = 0.12f;       ///< [s] an arrow is as long as the air goes in this time, above 0 to 100
};
[[nodiscard]] windrow::Result<void> validate(const WindArrowSettings& settings);

class WindArrows final : public Drawable {
  public:
    /// Refuses what `validate` refuses.
    [[nodiscard]] static Result<std::unique_ptr<WindArrows>> create(engine::Device& device, const DrawTargets& targets,
                                                                    const WindArrowSettings& settings);

    /// The lattice's middle from now on, [m] from the anchor, of which x and z count; it moves by whole spacings.
    void place(glm::vec3 middle);
    void draw(const PassContext& context) override;

  private:
    /// WindArrows of vegetation/shaders/render/wind_lattice.glsl.
    struct Block {
        glm::vec4 corner{0.0f}; ///< xz [m] from the anchor, y lowest [m] above the ground, w [m] spacing
        glm::ivec4 count{0};
        glm::vec4 look{0.0f}; ///< x scale [m/s], y [s] of an arrow
    };

    WindArrows(engine::Device& device, const DrawTargets& targets, const WindArrowSettings& settings);

    engine::Objects objects_;
    WindArrowSettings settings_;
    VkPipelineLayout layout_ = VK_NULL_HANDLE;
    VkPipeline pipeline_ = VK_NULL_HANDLE;
    std::array<VkDescriptorSet, engine::k_frames_in_flight> sets_{};
    engine::FrameBuffers blocks_{};
    Block block_{};
};

} // namespace windrow::vegetation::render
