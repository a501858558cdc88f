// A scene before the camera: the device, the air, the ground's memory and all that is drawn, frame by frame.
//
//     auto scene_renderer = program::SceneRenderer::create(*scene, {});
//     if (auto ready = (*scene_renderer)->warm_up(); !ready) ...                            // gusts come in
//     while ((*scene_renderer)->frame() < scene->frame_count())
//         if (auto drawn = (*scene_renderer)->draw(); drawn) write_png((*scene_renderer)->images().picture(), ...);
//
// A window has a device, a clock and a camera of its own, and frames that overlap:
//
//     auto player = program::SceneRenderer::create(scene, {.device = &device, .size = size, .edited = true});
//     const engine::Frame frame = *(*player)->frames().begin();
//     (void)(*player)->record(frame, {.start = t, .end = t + dt, .camera = eye});           // then what is drawn on top
//     (void)(*player)->frames().submit(frame, {.wait = image_is_free, .done = image_is_drawn});
//     (void)(*player)->change({.size = wider, .show = program::Show::arrows});              // between frames
//
// A frame: what moves is put where it is at the frame's end, the wind and the ground's memory are recorded, then the renderer.
// The air runs the scene's fixed ticks whatever the frame rate (windrow::Ticks), so that a second at 30 frames and one at 144 end
// alike. Motors are placed once a frame, wakes swept along their way; one that begins or ends within a frame does so at the
// frame's nearer edge, and one that acts for less than half a frame may be missed.
#pragma once

#include "coupling/vulkan/ground_memory.h"
#include "scene/scene_levels.h"
#include "vegetation/program/air.h"
#include "vegetation/program/figures.h"
#include "vegetation/program/furred_body.h"
#include "vegetation/program/picture_scene.h"
#include "vegetation/program/standing_bodies.h"
#include "vegetation/render/grass_layer.h"
#include "vegetation/render/renderer.h"
#include "vegetation/render/wind_arrows.h"
#include "vegetation/render/wind_streaks.h"
#include "vegetation/trees/tree_stand.h"
#include "vegetation/vulkan/frames.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace windrow::vegetation::program {

/// What the picture shows in place of, or beside, its plants' own colours.
enum class Show { plants, streaks, arrows, slice, lean, levels, chunks };

struct SceneRendererSettings {
    std::optional<glm::ivec2> size{};          ///< [px] default: the scene's
    std::optional<double> frames_per_second{}; ///< default: the scene's
    std::optional<double> warm_up{};           ///< [s] of wind before the first picture; default: the scene's
    std::optional<float> shutter_deg{};        ///< of RenderSettings; default: the scene's
    int samples = 4;                           ///< a pixel: 1, 4, or 2 where the device can
    Show show = Show::plants;
    std::optional<Backend> backend{}; ///< what runs the air; default: by the device (AirSettings)
    bool wind = true;                 ///< false: nothing blows and no step is recorded, to tell what the wind costs
    bool pass_times = false;          ///< the wind times each of its passes
    bool counts = false;              ///< vertices and fragments of the colour pass are counted
    std::optional<int> max_blades{};  ///< of each layer, looked at once a frame; default: the layer's own
    bool staged = false;              ///< engine::DeviceSettings::staged
    PFN_vkGetInstanceProcAddr get_instance_proc_addr = nullptr; ///< engine::DeviceSettings::get_instance_proc_addr
    engine::Device* device = nullptr;                           ///< the host's, which outlives the renderer; null: one of its own
    bool draft = false;                                         ///< what a software device draws in time: small and hard shadows
    /// The host changes the scene between frames (`change`): each obstacle is a body of its own, and what can be asked of an air is
    /// read back.
    bool edited = false;
};

/// A frame of a host's own clock.
struct Moment {
    double start = 0.0, end = 0.0;          ///< [s] of the scene's time
    std::optional<render::Camera> camera{}; ///< default: the scene's at the end
    bool copied = false;                    ///< its pictures are for the host to read, once the frame is done
    bool stepped = false;                   ///< the host has stepped the air to the end itself (`Air::cpu`)
};

/// What can change between frames; each default leaves it.
struct Change {
    std::optional<glm::ivec2> size{}; ///< [px]
    std::optional<Show> show{};
    bool obstacles = false;     ///< some came or have another shape
    bool ground_memory = false; ///< the scene has one now
    bool look = false;          ///< the mask of the first layer of grass is another: the ground has its look where that grows
};

/// Device memory by what it is for, [bytes].
struct SceneRendererMemory {
    /// Pictures, shadow map, read-backs, uniform blocks, the ground's heights, trees: allocations of the engine.
    std::uint64_t targets = 0;
    std::uint64_t wind = 0, grass = 0, ground_memory = 0;
    std::uint64_t room = 0; ///< left in the blocks that all of them take from the driver
};

class SceneRenderer {
  public:
    /// Rejects what any part rejects. The scene outlives it.
    [[nodiscard]] static windrow::Result<std::unique_ptr<SceneRenderer>> create(const PictureScene& scene,
                                                                                const SceneRendererSettings& settings);

    /// The air before the first picture, Picture::warm_up seconds of it, with all that acts at time 0.
    windrow::Result<void> warm_up();
    /// The next frame, done when this returns: frame 0 is at time 0. `copied`: its pictures are for the host to read.
    windrow::Result<void> draw(bool copied = true);
    /// Lets a frame's time pass without a picture.
    windrow::Result<void> skip();
    /// Records a frame that the host has begun and will submit. Frames overlap: nothing is waited for.
    windrow::Result<void> record(const engine::Frame& frame, const Moment& moment);
    /// Between frames, once those in flight are done: other targets, views and obstacles. What has grown stays as it is.
    windrow::Result<void> change(const Change& change);
    [[nodiscard]] engine::Frames& frames() { return *frames_; }
    [[nodiscard]] Air& air() { return *air_; }
    /// Other air of as many cells, as from `Air::load`. Nothing is in flight.
    void take_air(Air air) { air_ = std::move(air); }
    /// What its own air was made with.
    [[nodiscard]] AirSettings air_settings() const;
    [[nodiscard]] windrow::scene::SceneAir& scene_air() { return scene_air_; }
    /// The winds around its own; null: none.
    [[nodiscard]] windrow::scene::SceneLevels* levels() { return levels_ ? &*levels_ : nullptr; }
    /// Others, for the air that is taken next. Nothing is in flight.
    void take_levels(windrow::scene::SceneLevels levels) { levels_ = std::move(levels); }
    /// Threads of the winds around; they begin with the first call.
    [[nodiscard]] ParallelFor level_threads();

    /// Frames so far.
    [[nodiscard]] std::int64_t frame() const { return frame_; }
    [[nodiscard]] double frames_per_second() const { return frames_per_second_; }
    [[nodiscard]] glm::ivec2 size() const { return size_; }
    [[nodiscard]] float shutter_deg() const { return settings_.shutter_deg.value_or(scene_.picture.camera.shutter_deg); }
    [[nodiscard]] const render::Targets& images() const { return renderer_->images(); }
    /// By the device's clock, of the frame drawn last, and with what the CPU took for the wind; empty where the device counts no
    /// time.
    [[nodiscard]] std::vector<render::StageTime> times() const;
    /// Of the frame drawn last; zeros where the device counts nothing, or without SceneRendererSettings::counts.
    [[nodiscard]] const render::VertexCounts& counts() const { return counts_; }
    [[nodiscard]] const Air& air() const { return *air_; }
    [[nodiscard]] const std::string& device() const { return device_->name(); }
    [[nodiscard]] const render::Renderer& renderer() const { return *renderer_; }
    /// [m] What positions in shaders count from.
    [[nodiscard]] glm::dvec3 anchor() const { return anchor_; }
    /// The most walkers of any frame so far that the ground's memory had no room for.
    [[nodiscard]] int walkers_left_out() const { return walkers_left_out_; }
    [[nodiscard]] SceneRendererMemory memory() const;
    [[nodiscard]] const std::vector<std::unique_ptr<render::GrassLayer>>& grass() const { return grass_; }
    /// The mask of a layer of the scene has changed there.
    windrow::Result<void> repaint(std::size_t layer, const grass::Touched& touched);

  private:
    SceneRenderer(const PictureScene& scene, const SceneRendererSettings& settings);
    windrow::Result<void> make();
    windrow::Result<void> make_renderer();
    windrow::Result<void> make_ground_memory();
    /// Hands the renderer all that is drawn, in a fixed order.
    void attach();
    /// Where all that moves is at a frame's end.
    windrow::Result<void> place(double start, double end);
    void collect(const engine::Frame& frame);
    windrow::Result<void> make_grass(const render::DrawTargets& targets);
    windrow::Result<void> make_trees(const render::DrawTargets& targets);
    void move_figures(double time, double seconds);
    /// The air's next `dt` [s].
    windrow::Result<void> record_air(const engine::Frame& frame, double dt);
    windrow::Result<void> make_views(const render::DrawTargets& targets);
    windrow::Result<void> make_streaks(const render::DrawTargets& targets);
    void move_streaks(double time, double seconds);
    /// What swings from frame to frame, in one that is not drawn.
    windrow::Result<void> swing(const engine::Frame& frame, double time, double seconds);
    void set_time_step(double seconds);
    /// What moves, the air and the ground from one time [s] to another.
    windrow::Result<void> blow(const engine::Frame& frame, double start, double end);
    windrow::Result<void> walk(const engine::Frame& frame, double start, double end);
    /// [s] Where frame n begins and ends.
    [[nodiscard]] double start_of(std::int64_t n) const { return static_cast<double>(n > 0 ? n - 1 : 0) / frames_per_second_; }
    [[nodiscard]] double end_of(std::int64_t n) const { return static_cast<double>(n) / frames_per_second_; }

    const PictureScene& scene_;
    SceneRendererSettings settings_;
    double frames_per_second_ = 30.0;
    glm::ivec2 size_{0};
    glm::dvec3 anchor_{0.0};
    std::unique_ptr<engine::Device> own_device_{};
    engine::Device* device_ = nullptr; ///< that, or the host's
    std::unique_ptr<ThreadPool> level_threads_{};
    std::optional<windrow::scene::SceneLevels> levels_{}; ///< around the air; none in scenes without
    std::optional<Air> air_{};
    windrow::scene::SceneAir scene_air_;
    std::optional<windrow::vulkan::GroundMemory> ground_{};
    std::unique_ptr<render::Renderer> renderer_{};
    std::vector<std::unique_ptr<render::GrassLayer>> grass_{};
    std::vector<std::unique_ptr<trees::TreeStand>> trees_{};
    std::optional<FurredBodies> furred_{};
    std::optional<Figures> figures_{};
    std::optional<StandingBodies> standing_{};
    std::unique_ptr<render::WindArrows> arrows_{};
    std::unique_ptr<render::WindStreaks> streaks_{};
    std::unique_ptr<engine::Frames> frames_{};
    render::GrassView view_{};
    std::int64_t frame_ = 0;
    int walkers_left_out_ = 0;
    render::VertexCounts counts_{};
};

} // namespace windrow::vegetation::program
