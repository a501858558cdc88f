// Blades at given places, each bent once a frame by the wind: the plain way to draw grass. vegetation/grass has the way for
// millions.
#pragma once

#include "drawable.h"
#include "scene.h"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

namespace windrow::vegetation::render {

/// One blade, as shaders have it (std430).
struct BladePlace {
    glm::vec3 root{0.0f};      ///< [m] from the anchor
    float size = 1.0f;         ///< factor on length and width
    glm::uvec2 key{0u};        ///< its own, windrow::place_key of where it grows
    float dryness = 0.0f;      ///< of its place, 0 to 1
    float width_factor = 1.0f; ///< on its width alone
};
static_assert(sizeof(BladePlace) == 32);

class BladeGrid final : public Drawable {
  public:
    /// At least one place. Rejects what windrow::Blades::create rejects.
    [[nodiscard]] static Result<std::unique_ptr<BladeGrid>> create(engine::Device& device, const DrawTargets& targets,
                                                                   const windrow::BladeSettings& plants, const PlantLook& look,
                                                                   std::span<const BladePlace> places);

    /// The bends of this frame and of the last one, once a blade.
    Result<void> prepare(const PassContext& context) override;
    void draw(const PassContext& context) override;
    [[nodiscard]] std::uint32_t count() const { return count_; }
    /// [rad] x and z of the bend in the last frame that is done, then of the frame before it; one a blade. Waits for the device.
    [[nodiscard]] Result<std::vector<glm::vec4>> bends() const;

  private:
    BladeGrid(engine::Device& device, const DrawTargets& targets, const windrow::Blades& plants, const PlantLook& look,
              std::span<const BladePlace> places);

    engine::Objects objects_;
    std::uint32_t count_ = 0;
    VkPipelineLayout layout_ = VK_NULL_HANDLE;
    VkPipeline bend_ = VK_NULL_HANDLE, colour_ = VK_NULL_HANDLE, shadow_ = VK_NULL_HANDLE;
    VkDescriptorSet set_ = VK_NULL_HANDLE;
    engine::Buffer bends_{};
};

/// Places of blades for a nearly fixed eye: a fan of directions, denser near the eye as distance^-exponent, blades
/// wider afar so that as much is covered. The same arguments give the same places.
struct BladeFan {
    glm::dvec3 eye{0.0};
    glm::dvec3 target{0.0};
    float half_angle = 0.75f;
    float near = 0.7f;
    float far = 45.0f;
    float exponent = 1.5f;
    int count = 20000;
    float wide_from = 3.0f;

    static constexpr auto settings() {
        return std::tuple{
            Setting("eye", &BladeFan::eye, k_place_range, "Position of the eye."),
            Setting("target", &BladeFan::target, k_place_range, "Point that it looks at; not straight above or below."),
            Setting("half_angle", &BladeFan::half_angle, {1e-3, 3.2, "rad"}, "To either side."),
            Setting("near", &BladeFan::near, {1e-3, 1e5, "m"}, "To the first blade."),
            Setting("far", &BladeFan::far, {1e-3, 1e6, "m"},
                    "To the last, beyond near; over the last third they shrink to a quarter, so that no edge shows."),
            Setting("exponent", &BladeFan::exponent, {0.0, 1.99}, "0 is even on the ground, 2 would be even on the picture."),
            Setting("count", &BladeFan::count, {1.0, 1e7}, "Number of blades."),
            Setting("wide_from", &BladeFan::wide_from, {1e-3, 1e6, "m"},
                    "From which on blades are drawn wider, in proportion to distance."),
        };
    }
};
[[nodiscard]] windrow::Result<std::vector<BladePlace>> scatter(const BladeFan& fan, const Ground& ground, glm::dvec3 anchor);

} // namespace windrow::vegetation::render
