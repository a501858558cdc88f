// A field of grass as a drawable of the renderer: vegetation/grass with its light, wind and shadows.
//
//     auto grass = render::GrassLayer::create(device, renderer->draw_targets(), scene.ground, mask, {.field = ..., .look = ...});
//     renderer->add(**grass);                                  // before the first frame
//     (*grass)->set_ground(&ground_memory);                    // where walkers leave trails
//
// A frame: the field culls its chunks into lists (grass_field.h); one pass swings each visible blade in the wind, another
// looks at the ground under it; the draws of the picture and of the shadow only read that.
#pragma once

#include "../../coupling/spring.h"
#include "../../coupling/vulkan/ground_memory.h"
#include "../grass/grass_field.h"
#include "../vulkan/frames.h"
#include "drawable.h"
#include "scene.h"

#include <array>
#include <memory>

namespace windrow::vegetation::render {

struct GrassLayerSettings {
    grass::GrassSettings field{};
    PlantLook look{};
    int max_blades = 262144;
    int shadows = 1;
    bool springs = true;
    windrow::SpringClass spring{3.5, 0.5};

    static constexpr auto settings() {
        return std::tuple{
            Setting("", &GrassLayerSettings::field, "The field."),
            Setting("look", &GrassLayerSettings::look,
                    "Colours are linear albedo. What comes back and what shines through, together, are at most 0.6."),
            Setting("max_blades", &GrassLayerSettings::max_blades, {1024.0, 4194304.0},
                    "Visible blades that are looked at once a frame, those of shadows counted apart, 112 bytes each; more take "
                    "the bend of others."),
            Setting(
                "shadows", &GrassLayerSettings::shadows, {0.0, 2.0},
                "Number of shadow maps, of two, that it is drawn into. 1 is the near one: a blade is far finer than a texel of "
                "the other."),
            Setting("springs", &GrassLayerSettings::springs,
                    "Blades swing. Off: each is as the wind holds it, at once. A state of 20 bytes a visible blade, kept twice, "
                    "and 8 bytes a place that has memory."),
            Setting(
                "spring", &GrassLayerSettings::spring,
                "Its class of springs; in a scene that of the layer's class. Grass is springs::grass with the drag of its own "
                "motion: rho C_d w U / (2 m omega) is 0.3 for a blade of 4 mm and 0.8 g a metre in 2 m/s."),
        };
    }
};
[[nodiscard]] windrow::Result<void> validate(const GrassLayerSettings& settings);

/// A visible blade, as shaders have it: FieldBlade of vegetation/shaders/render/field_blade.glsl (std430).
struct FieldBlade {
    glm::vec4 root{0.0f};   ///< xyz [m] from the anchor; w how dry its place is, 0 to 1
    glm::vec4 bend{0.0f};   ///< [rad] x and z now, x and z a frame ago
    glm::vec4 size{0.0f};   ///< [m] length of its class and half its width now; the same a frame ago
    glm::uvec4 traits{0u};  ///< xy its hash; z bits of its morph (float), w of the morph a frame ago
    glm::vec4 looks{0.0f};  ///< chances, 0 to 1: xy its clump's, z its own; w size over its class's
    glm::vec4 fog{0.0f};    ///< rgb light of the air before it, w fraction of its own light that comes through
    glm::vec4 canopy{0.0f}; ///< [rad] xy lean of the grass as a whole, x and z; z how much of it is seen, 0 to 1; w 0
};
static_assert(sizeof(FieldBlade) == 112);

class GrassLayer final : public Drawable {
  public:
    /// Rejects what `validate` and GrassField::create reject. The mask has the heights' extent. The device outlives it.
    [[nodiscard]] static windrow::Result<std::unique_ptr<GrassLayer>> create(engine::Device& device, const DrawTargets& targets,
                                                                             const Ground& ground,
                                                                             const grass::PlacementMask& mask,
                                                                             const GrassLayerSettings& settings);

    /// The memory that its blades lean by from the next frame on, beside the wind: record its step before the renderer's
    /// recording, with GroundStep::wind_lean at 0 since the layer has the wind itself. Null: none, which costs nothing.
    void set_ground(const windrow::vulkan::GroundMemory* ground) { ground_ = ground; }

    /// [s] Time from the last prepared frame to the next. Default 1/60.
    void set_time_step(double seconds) { time_step_ = seconds; }

    Result<void> prepare(const PassContext& context) override;
    void draw(const PassContext& context) override;

    /// To repaint its mask, and to count what it draws.
    [[nodiscard]] grass::GrassField& field() { return field_; }
    /// Of the frame prepared last.
    [[nodiscard]] const grass::GrassReport& report() const { return report_; }
    /// FieldBlade of each visible blade. May be copied from.
    [[nodiscard]] VkBuffer visible_blades() const { return blades_; }
    /// [bytes] Device memory of field and layer.
    [[nodiscard]] std::uint64_t memory_bytes() const { return field_.memory_bytes() + objects_.memory_bytes(); }

  private:
    GrassLayer(engine::Device& device, grass::GrassField field, const GrassLayerSettings& settings);
    void make(const DrawTargets& targets);
    /// A pass over the visible blades.
    struct BladePass {
        VkPipelineLayout layout = VK_NULL_HANDLE;
        VkPipeline pipeline = VK_NULL_HANDLE;
        std::array<VkDescriptorSet, engine::k_frames_in_flight> sets{};
    };
    void point_at_ground(const PassContext& context);
    void begin_swing(const PassContext& context);

    engine::Device& device_;
    GrassLayerSettings settings_;
    grass::GrassField field_;
    engine::Objects objects_;
    grass::GrassReport report_{};
    const windrow::vulkan::GroundMemory* ground_ = nullptr;
    engine::FrameBuffers ground_blocks_{};
    VkSampler sampler_ = VK_NULL_HANDLE;
    VkBuffer blades_ = VK_NULL_HANDLE;
    VkBuffer listed_ = VK_NULL_HANDLE; // of springs alone
    engine::FrameBuffers swing_blocks_{};
    double time_step_ = 1.0 / 60.0;
    std::uint32_t frame_ = 0;
    BladePass plain_{}, on_ground_{};
    VkPipelineLayout layout_ = VK_NULL_HANDLE;
    VkPipeline colour_ = VK_NULL_HANDLE, shadow_ = VK_NULL_HANDLE;
};

} // namespace windrow::vegetation::render
