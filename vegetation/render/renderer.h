// The small renderer: sun with shadows, sky, fog, ground and whatever drawables a host adds, offscreen.
//
//     auto renderer = render::Renderer::create(device, scene, {.anchor = field});
//     auto grass = render::GrassLayer::create(device, (*renderer)->draw_targets(), scene.ground, mask, {.look = scene.look});
//     (*renderer)->add(**grass);
//     const engine::Frame frame = *frames->begin();
//     (*renderer)->begin(frame);                                   // the clock
//     (void)wind->record(frame.commands, {.dt = dt, .slot = frame.slot});
//     (*renderer)->record(frame, camera, *wind);                   // all passes; motion since the last recorded frame
//     (*renderer)->copy(frame);                                    // where this frame is wanted on the host
//     frames->finish(frame);
//     (void)render::write_ppm((*renderer)->images().picture(), "frame.ppm");
//
// Passes: drawables prepare; what clouds leave of the sun, about the eye; the sky, a texel for
// several pixels; both shadows into one map; light (RGBA16F) and motion
// (RG16F) with depth, four samples resolved; the toned picture. With a shutter the light is blurred along the motion before it is
// toned.
#pragma once

#include "../vulkan/wind_set.h"
#include "cloud_map.h"
#include "frame_block.h"
#include "motion_blur.h"
#include "noise_map.h"
#include "stage_clock.h"
#include "targets.h"
#include "terrain.h"
#include "vertex_counter.h"

#include <array>
#include <memory>
#include <optional>
#include <span>

namespace windrow::vegetation::render {

/// Of a shutter that turns once a frame and is open over this angle.
inline constexpr Range k_shutter_range{0.0, 360.0, "deg", "open for no time: nothing is blurred, at no cost"};
inline constexpr const char* k_shutter_meaning =
    "Blurs what moves, as a film camera does that is open for this angle of a frame. 180 is a film's.";

/// Maps that take what changes slowly over the picture off its pixels. The defaults look as none of them (docs/vegetation_cost.md).
struct Quality {
    int sky_pixels = 4;
    int cloud_texels = 512;
    int cloud_noise_texels = 1024;
    int ground_texels = 1024;
    int light_bytes = 8;

    static constexpr auto settings() {
        return std::tuple{
            Setting("sky_pixels", &Quality::sky_pixels,
                    {.min = 0.0, .max = 16.0, .unit = "px", .zero = "no map: each pixel works it out"},
                    "Pixels along a texel of the map of the clear sky, fewer in pictures that are less than 1024 wide. Sun and "
                    "clouds are not in it."),
            Setting("cloud_texels", &Quality::cloud_texels,
                    {.min = 0.0, .max = 4096.0, .zero = "no map: each point works it out"},
                    "A side of the map of the clouds' shadow. 512: within 0.1 % of the light."),
            Setting("cloud_noise_texels", &Quality::cloud_noise_texels,
                    {.min = 0.0, .max = 4096.0, .zero = "no map: each pixel works it out"},
                    "A side of the map of the clouds about the eye, a 64th of their size each. What is beyond is worked out."),
            Setting("ground_texels", &Quality::ground_texels,
                    {.min = 0.0, .max = 4096.0, .zero = "no map: each pixel works it out"},
                    "A side of the map of the ground's colour about the eye, 0.25 m each. What is beyond is worked out."),
            Setting(
                "light_bytes", &Quality::light_bytes, {4.0, 8.0},
                "Of light a sample, 8 or 4. 4 are half of the memory that is written, and show bands in a clear sky; a device "
                "that cannot draw so takes 8."),
        };
    }
};

struct RenderSettings {
    int width = 1280;
    int height = 720;
    int samples = 4;
    int shadow_texels = 1024;
    bool draft = false;
    float near_shadow = 12.0f;
    float far_shadow = 70.0f;
    float shutter_deg = 0.0f;
    Quality quality{};
    glm::dvec3 anchor{0.0};
    bool counts = false;
    bool apart = false;

    static constexpr auto settings() {
        return std::tuple{
            Setting("width", &RenderSettings::width, {16.0, 8192.0, "px"}, "Of the picture."),
            Setting("height", &RenderSettings::height, {16.0, 8192.0, "px"}, "Of the picture."),
            Setting("samples", &RenderSettings::samples, {1.0, 4.0}, "A pixel: 1, 4, or 2 where the device can."),
            Setting("shadow_texels", &RenderSettings::shadow_texels, {64.0, 4096.0}, "A side of each shadow."),
            Setting(
                "draft", &RenderSettings::draft,
                "For a software device: a shadow is one sample in place of nine, and tiles of the ground are drawn from front "
                "to back, a draw each, so that what hills hide is not shaded."),
            Setting("near_shadow", &RenderSettings::near_shadow, {0.1, 1e5, "m"},
                    "Reach of the fine shadow, above the camera's near."),
            Setting("far_shadow", &RenderSettings::far_shadow, {0.1, 1e6, "m"},
                    "Reach of the coarse one, above near_shadow; beyond it all is lit."),
            Setting("", &RenderSettings::quality, "What is worked out once for several points of the picture."),
            Setting("shutter_deg", &RenderSettings::shutter_deg, k_shutter_range, k_shutter_meaning),
            Setting("anchor", &RenderSettings::anchor, k_place_range,
                    "Origin of shader positions: within some km of the camera."),
            Setting("counts", &RenderSettings::counts,
                    "Vertices and fragments of the colour pass are counted by drawable, where the device can."),
            Setting("apart", &RenderSettings::apart,
                    "Each drawable of the colour pass has a time of its own, by its name. It waits for the one before it."),
        };
    }
};
[[nodiscard]] windrow::Result<void> validate(const RenderSettings& settings);
void check_rules(windrow::detail::Reasons& reasons, const windrow::detail::FieldPath& path, const Quality& quality);
void check_rules(windrow::detail::Reasons& reasons, const windrow::detail::FieldPath& path, const RenderSettings& settings);

class Renderer {
  public:
    /// Rejects what `validate` rejects of scene and settings, and a device that lacks memory. The device outlives it.
    [[nodiscard]] static windrow::Result<std::unique_ptr<Renderer>> create(engine::Device& device, const Scene& scene,
                                                                           const RenderSettings& settings);

    /// Targets that drawables must match.
    [[nodiscard]] DrawTargets draw_targets() const;
    /// Drawn in each frame from now on, after the ground. It outlives the renderer's last recording.
    /// `name` is its row of figures, and outlives the renderer.
    void add(Drawable& drawable, const char* name = "drawable") { drawables_.push_back({&drawable, name}); }

    /// Begins the frame's clock, before the wind is recorded.
    void begin(const engine::Frame& frame);
    /// Records all passes, after the wind's, which is a vulkan::Wind or an engine::CpuWind. The camera is one that `validate`
    /// passes; another draws nothing and is rejected.
    windrow::Result<void> record(const engine::Frame& frame, const Camera& camera, const engine::SampledWind& wind);
    /// A frame without a picture: what these drawables keep from one frame to the next (trees that swing) goes on as in `record`.
    windrow::Result<void> keep_up(const engine::Frame& frame, const Camera& camera, const engine::SampledWind& wind,
                                  std::span<Drawable* const> drawables);
    /// Records the copy to the host, after `record`.
    void copy(const engine::Frame& frame);

    /// [s] Where the clouds are from now on. Default 0.
    void set_time(double seconds);
    /// Sets the debug view of the grass.
    void show(GrassView view) { block_.terrain_size.z = static_cast<int>(view); }
    /// The sun from now on.
    windrow::Result<void> set_sun(const Sun& sun);
    [[nodiscard]] const Targets& images() const { return images_; }
    [[nodiscard]] const StageClock& clock() const { return clock_; }
    [[nodiscard]] StageClock& clock() { return clock_; }
    /// Nothing without RenderSettings::counts.
    [[nodiscard]] const std::optional<VertexCounter>& counter() const { return counter_; }
    [[nodiscard]] const ViewBlock& frame_block() const { return block_; }

  private:
    struct NamedDrawable {
        Drawable* drawable = nullptr;
        const char* name = "";
    };
    Renderer(engine::Device& device, const Scene& scene, const RenderSettings& settings);
    void fill(const Camera& camera);
    /// The frame's blocks and descriptor sets, filled for this camera.
    [[nodiscard]] PassContext context_of(const engine::Frame& frame, const Camera& camera, const engine::SampledWind& wind);
    void draw_shadows(PassContext context);
    void draw_colour(const PassContext& context);
    void make_sets(const Scene& scene);

    engine::Device& device_;
    engine::Objects objects_;
    RenderSettings settings_;
    Clouds clouds_;
    windrow::Sampling sampling_;
    Targets images_;
    StageClock clock_;
    std::optional<VertexCounter> counter_{};
    engine::WindSet wind_;
    engine::Image shadow_map_{};
    CloudMap cloud_map_;
    DrawnMap sky_map_;
    NoiseMap cloud_noise_;
    std::optional<engine::RenderPass> shadow_pass_{};
    VkSampler compare_ = VK_NULL_HANDLE, fetch_ = VK_NULL_HANDLE;
    VkDescriptorSetLayout frame_layout_ = VK_NULL_HANDLE, light_layout_ = VK_NULL_HANDLE;
    VkPipelineLayout full_screen_ = VK_NULL_HANDLE;
    VkPipeline sky_ = VK_NULL_HANDLE, tone_ = VK_NULL_HANDLE;
    std::array<VkDescriptorSet, engine::k_frames_in_flight> sets_{};
    VkDescriptorSet light_set_ = VK_NULL_HANDLE, sky_set_ = VK_NULL_HANDLE;
    engine::FrameBuffers blocks_{};
    std::optional<MotionBlur> blur_{};
    std::optional<Terrain> terrain_{};
    std::vector<NamedDrawable> drawables_{};
    ViewBlock block_{};
    bool first_ = true;
};

} // namespace windrow::vegetation::render
