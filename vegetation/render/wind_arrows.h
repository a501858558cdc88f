// The wind itself, drawn into the scene: arrows on a lattice of places, or a horizontal slice of coloured tiles. Both
// sample the wind as plants do.
#pragma once

#include "../vulkan/frames.h"
#include "drawable.h"

#include <array>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace windrow::vegetation::render {

struct WindArrowSettings {
    enum class Form { arrows, slice };
    Form form = Form::arrows;
    float spacing = 1.0f;
    glm::ivec3 count{32, 3, 32};
    float lowest = 1.0f;
    float scale = 8.0f;
    float seconds = 0.12f;

    static constexpr auto settings() {
        return std::tuple{
            Setting("form", &WindArrowSettings::form, "Arrows, or a level slice of tiles.", k_not_stored),
            Setting("spacing", &WindArrowSettings::spacing, {0.05, 1e3, "m"}, "Of the lattice."),
            Setting("count", &WindArrowSettings::count, {1.0, 512.0},
                    "Places along x, y, z, 1e6 at most in all; a slice has one level."),
            Setting("lowest", &WindArrowSettings::lowest, {-1e4, 1e4, "m"}, "Above the ground."),
            Setting("scale", &WindArrowSettings::scale, {1e-3, 1e3, "m/s"}, "At the top of the colour scale."),
            Setting("seconds", &WindArrowSettings::seconds, {1e-4, 100.0, "s"},
                    "An arrow is as long as the air goes in this time."),
        };
    }
};
[[nodiscard]] windrow::Result<void> validate(const WindArrowSettings& settings);
void check_rules(windrow::detail::Reasons& reasons, const windrow::detail::FieldPath& path, const WindArrowSettings& settings);

class WindArrows final : public Drawable {
  public:
    /// Rejects what `validate` rejects.
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

template <>
inline constexpr std::array<const char*, 2> windrow::k_words<windrow::vegetation::render::WindArrowSettings::Form>{"arrows",
                                                                                                                   "slice"};
