// The wind in a box that follows a player, on the GPU, inside the host's renderer.
//
//     auto wind = windrow::vulkan::Wind::create(host, {.ambient = {3.0f, 0.0f, 0.0f}});    // host.h: your device
//     auto fan  = wind->motors().add(windrow::DirectionalMotor{.position = {4.0, 1.0, 0.0}});
//     wind->follow(player_position);
//     auto done = wind->record(command_buffer, {.dt = frame_seconds, .slot = frame_in_flight});     // before what samples it
//     if (!done)
//         log(done.error());                                                                        // and nothing was recorded
//     bind(wind->textures(), wind->previous_textures(), wind->frame_block(camera_position));
//                                                       // textures.h, for shaders/coupling/windrow_wind.glsl
//
// Config, ticks and step are those of windrow::Wind, and velocities are the same to rounding, with all defaults. Only sleep begins
// some frames later, when a read-back has shown that the air is still.
// It does not submit or wait: all work goes into the host's command buffer, to run on one queue in the order of
// recording. Each recording is submitted once (else see `forget`). Changes between two frames are recorded with the next.
#pragma once

#include "../api.h"
#include "../owned.h"
#include "../wind.h"
#include "host.h"
#include "pass_times.h"
#include "read_back.h"
#include "textures.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace windrow::vulkan {

struct Settings {
    Texel texel = Texel::half;
    /// Textures that each frame writes; others are not created. Default: one of four components, one fetch a sample.
    TextureSet textures = TextureSet::vectors;
    /// Frames that the host keeps in flight, 1 to 8: as many read-backs wait for their turn. Default 2.
    int frames_in_flight = 2;
    /// Room for gusts, or for detail (Gusts::tile), that begin later than the wind itself (16 bytes a cell and its halo).
    /// Default: only where the config has them.
    bool gusts = false;
    /// Times each pass on the device (pass_times). Default off: it costs two timestamps a dispatch, and holds a pass back until
    /// the one before it has ended. Rejected where the queue family has no timestamps (timestampValidBits is 0).
    bool timestamps = false;
    /// What comes back to the host with each frame, besides the report of 64 bytes (read_back.h). Default none: a game that only
    /// samples on the device reads nothing. Nothing comes back while the air sleeps, nor in a pause without changes, except for
    /// points that are given and a box that moved.
    ReadBack queries = ReadBack::none;
    /// [cells] Size of ReadBack::box, at most the wind's box. Default 8 x 8 x 8: a body and its surroundings.
    glm::ivec3 read_cells{8};
    /// Most points of a frame with ReadBack::points, 1 to k_max_read_points. They travel inside the command buffer, 64 bytes each.
    /// Default 64.
    int read_points = 64;
    /// Most obstacles in the box whose forces come back with each frame (Wind::force_on), 0 to Obstacles::k_capacity: 32 bytes each
    /// and a dispatch in a sub-step. Default 0: none.
    int forces = 0;
    /// Handle type that the textures' memory can be exported as (Wind::exported_images), for another API or process. Default 0:
    /// none. Each texture has memory of its own then. Rejected where the device does not export such images, was made without
    /// VK_KHR_external_memory_fd or _win32, or where Host::memory allocates.
    VkExternalMemoryHandleTypeFlagBits export_textures{};
    /// Makes the passes for obstacles on creation. Default: with the first obstacle in the box, in whose recording the driver
    /// then compiles them.
    bool obstacles = false;
};
inline constexpr int k_max_read_points = 4096;

/// A frame to record.
struct Frame {
    /// [s] Its duration, as of `windrow::Wind::advance`.
    double dt = 0.0;
    /// Slot of the frame in flight, 0 to frames_in_flight - 1. The host guarantees that the work recorded for this slot
    /// before is done: its read-back is taken now, once per submission. Slots may come in any order; results older than those
    /// taken already are dropped. Default -1: the one after the last, in turns, which is right for a host that waits for
    /// the frame before the last frames_in_flight. A recording that `forget` follows counts as none: its slot's turn is still to
    /// come.
    int slot = -1;
    /// [m] World point that ReadBack::box is centred on, to whole cells and within the wind's box. Default, and where it is not
    /// finite: the point that the box follows, or its middle.
    std::optional<glm::dvec3> around{};
    /// [m] World points whose wind ReadBack::points reads. Those beyond Settings::read_points are left out. Read during the call
    /// alone.
    std::span<const glm::dvec3> points{};
    /// Saves the wind as this recording leaves it: `Wind::saved` returns the bytes once the slot is done. Takes 80 bytes a cell of
    /// host-visible memory until then, and up to 112 of the host's, which this one recording allocates; a lack of either is what
    /// `saved` returns. Default false.
    bool save = false;
};

/// [bytes] Device memory of a wind before it is made: exactly what memory_bytes and reserved_bytes return after it. Makes buffers
/// and images without memory and no pipelines. Rejects what `Wind::create` rejects by config, settings and device.
struct RequiredBytes {
    std::uint64_t memory = 0, reserved = 0;
};
[[nodiscard]] WINDROW_API Result<RequiredBytes>
required_bytes(const Host& host, const Config& config, const Settings& settings = {}, const windrow::Wind* outer = nullptr);

/// A texture whose memory can be exported: for vkGetMemoryFdKHR or vkGetMemoryWin32HandleKHR, which the host calls.
struct ExportedImage {
    VkImage image = VK_NULL_HANDLE; ///< of Textures
    VkDeviceMemory memory = VK_NULL_HANDLE;
    VkDeviceSize offset = 0, size = 0; ///< [bytes] in the memory
    VkExternalMemoryHandleTypeFlagBits handle_type{};
    VkFormat format = VK_FORMAT_UNDEFINED;
    VkExtent3D extent{}; ///< [texels]; optimal tiling, usage k_image_usage
};

/// Motors, obstacles, what blows around the box and where it is: wind_control.h, whose changes are recorded with the next frame.
/// What was read back: wind_reader.h.
class WINDROW_API Wind : public WindControl, public WindReader {
  public:
    /// Makes all buffers, images and pipelines. Rejects what `windrow::validate` rejects, a device that lacks something, and a
    /// box that it cannot hold, each with the reason. The host's device outlives the wind.
    /// `outer`: the wind around the box, on the CPU, as windrow::Wind::create takes it; null: none. The host calls its `advance`
    /// before `record`, by the same frames. The host samples it for each tick, and uploads 16 bytes for each cell of the box and its
    /// halo: 450 KiB of the default window. No dispatch more.
    [[nodiscard]] static Result<Wind> create(const Host& host, const Config& config, const Settings& settings = {},
                                             std::shared_ptr<const windrow::Wind> outer = {});

    /// Records a frame outside of a render pass: the ticks that are due, the textures, the read-back. Compute and transfer
    /// commands alone. Advance::last is of the last tick that was read back, frames_in_flight frames ago; cells that were
    /// repaired or limited are reported once, with the next frame that has a tick. What is recorded must be submitted: the next
    /// frame goes on from it.
    /// The error says why nothing was recorded, and the wind is unchanged: no command buffer, a dt that is negative or not
    /// finite, a slot out of range, no host memory, or a read-back that vkInvalidateMappedMemoryRanges does not make visible.
    [[nodiscard]] Result<Advance> record(VkCommandBuffer commands, const Frame& frame);
    /// Records one step of frame.dt instead of ticks; see windrow::Wind::step. Its errors are those of `record`, and its
    /// Diagnostics as old. A dt of 0 is a pause: what was asked for since the last frame is recorded, and the textures show it;
    /// after `record` they stay at its moment between two ticks. In a step above 1 s viscosity acts no further than it may in
    /// shorter ones: where these need no direct solve of it, for as long as one explicit pass carries (viscosity * time =
    /// cell_size^2 / 12), and the rest stays as accumulated diffusion time for the next steps.
    [[nodiscard]] Result<Diagnostics> record_step(VkCommandBuffer commands, const Frame& frame);
    /// Takes the read-back of a slot before its turn comes: for a host that has waited for what it recorded there, as tools do.
    /// False where there is none to take.
    bool collect(int slot);
    /// After each recording that will never be submitted (its command buffer was reset, its device call failed), before the next one:
    /// the air is ambient, nothing of the device's memory is trusted, and the next recording writes all of it again. Motors,
    /// boundaries, place and wind stay as they were set. To go on from the last frame that was read, give its cells to
    /// `set_velocity`. What was submitted before runs to its end first, as always; its read-backs are not taken.
    void forget();

    // --- Snapshots ---------------------------------------------------------------------------------------------------------
    /// The bytes of windrow::Wind::save, of the last recording with Frame::save; once for each. They load here and on the CPU. A
    /// device does not hold the cells of the frame before the one saved: it is saved as that one. The error says why there are
    /// none (yet): no recording asked, it is in flight until its slot is recorded or collected again, or there was no memory.
    [[nodiscard]] Result<std::vector<std::byte>> saved();
    /// A wind that continues from a snapshot of this class, with the same bits, or of the CPU. Rejects what windrow::Wind::load
    /// rejects, and what `create` rejects of its config. The cells travel in the first recording, from host memory that is kept
    /// until its slot comes again. Air that is about to sleep may fall asleep up to frames_in_flight ticks later than there.
    /// `outer`: as windrow::Wind::load takes it. A wind that a device saved goes on there with the same bits.
    [[nodiscard]] static Result<Wind> load(const Host& host, std::span<const std::byte> bytes, const Settings& settings = {},
                                           std::shared_ptr<const windrow::Wind> outer = {});

    // --- For shaders: shaders/coupling/windrow_wind.glsl -------------------------------------------------------------------
    /// Of the frame last recorded, and of the one before; after the first recording. Before it they hold nothing, in no layout.
    [[nodiscard]] Textures textures() const;
    [[nodiscard]] Textures previous_textures() const;
    [[nodiscard]] WindowBlock window_block(glm::dvec3 anchor) const override;
    [[nodiscard]] FrameBlock frame_block(glm::dvec3 anchor, const Sampling& sampling = {}) const override;
    /// All textures of both sets, with Settings::export_textures; empty without it, and without host memory for the list. They
    /// keep their memory until the wind is destroyed.
    [[nodiscard]] std::vector<ExportedImage> exported_images() const;
    /// The storage buffer of the gust tile, for the include.
    [[nodiscard]] VkBuffer gust_buffer() const;
    [[nodiscard]] const AmbientWind& ambient_wind() const override;

    // --- For the host: what was read back ----------------------------------------------------------------------------------
    //
    // Views read the device's memory in place. They are good until the next recording, or a `collect` that takes one.

    /// The wind of the last frame whose read-back is in, to sample on the CPU: of all cells, or of ReadBack::box, which fades to
    /// the ambient wind over one cell beyond it. Nothing before the first, and with the other kinds of read-back. For many
    /// points, and for the wind that acts on plants, keep the view: it has both (fluid/view.h).
    [[nodiscard]] std::optional<WindView> queried() const;
    /// The same with ReadBack::halves.
    [[nodiscard]] std::optional<HalfView> queried_halves() const;
    /// The wind at the points of the last frame whose read-back is in, with ReadBack::points.
    [[nodiscard]] std::optional<PointWinds> queried_points() const;
    /// In the last tick whose read-back is in: frames_in_flight frames ago. A body that comes into the box, and all bodies of a
    /// loaded wind, begin without the pressure of the tick before. Nothing for a body beyond the first Settings::forces in the
    /// box, and while the air sleeps. Rejects a handle that names no obstacle, and a wind whose Settings::forces is 0.
    [[nodiscard]] Result<ObstacleForce> force_on(ObstacleId id) const override;
    /// Of the cells of the last frame whose read-back is in, with ReadBack::cells. Rejects a handle that names no deposit, and a wind
    /// whose cells do not come back, or have not yet.
    [[nodiscard]] Result<DragForce> force_on(DragId id) const override;
    /// Obstacles where they are now, which the host rasterises for this call: in the box of `queried`, where all of its cells are
    /// read back; else in that of `origin`.
    Result<void> write_obstacles(std::span<float> cells) const override;
    /// Rejected: a device hands out no pressure.
    Result<void> write_pressure(std::span<float> cells) override;
    /// [s] Time of the frames recorded since that one. With ticks each frame shows a moment up to a tick before its own.
    [[nodiscard]] double query_age() const;
    /// Of the last tick that was read back, with any kind of read-back, without counts of cells.
    [[nodiscard]] Diagnostics diagnostics() const override;
    /// The same with the cells that were repaired or limited, which are reported once, here or by a recording.
    [[nodiscard]] Diagnostics reported();
    /// As of `queried` or `queried_halves`, which it makes again each time. The ambient wind of this frame where there is neither:
    /// before the first, and where no cells are read back.
    [[nodiscard]] glm::vec3 velocity(glm::dvec3 position) const override;
    using WindReader::velocity;
    /// Changes wait for the next recording: what was read back is not of now.
    [[nodiscard]] bool waits() const;

    /// Dispatches and pipeline barriers of the last recording. Sub-steps that the device leaves out are counted: their dispatches
    /// have no work groups.
    [[nodiscard]] int dispatches() const;
    [[nodiscard]] int barriers() const;
    /// Times of the passes in the last recording that was read back, frames_in_flight frames ago; nothing before the first,
    /// without Settings::timestamps, and without memory for them.
    [[nodiscard]] std::optional<PassTimes> pass_times() const;
    [[nodiscard]] std::uint64_t memory_bytes() const override;
    /// [bytes] Device memory that was taken from the driver for it: `memory_bytes` and what alignment leaves free. Tables of other
    /// boundary kinds may take another MiB.
    [[nodiscard]] std::uint64_t reserved_bytes() const;

    Wind(Wind&&) noexcept;
    /// Ends the wind that was here: no recording of it is in flight.
    Wind& operator=(Wind&&) noexcept;
    /// No recording of it is in flight.
    ~Wind() override;

    struct State; // wind_state.h
    [[nodiscard]] State& state() { return *state_; }
    [[nodiscard]] const State& state() const { return *state_; }

  private:
    explicit Wind(std::unique_ptr<State> state);
    [[nodiscard]] static Result<Wind> make(const Host& host, const Config& config, const Settings& settings,
                                           std::shared_ptr<const windrow::Wind> outer, bool loads);
    [[nodiscard]] Result<WindView> read_view() const override;
    [[nodiscard]] Result<WindView> read_previous_view() const override;
    windrow::detail::Owned<State> state_;
};

/// As windrow::replay. `run` records with the function that it is given, submits, and waits: OwnDevice::run. On the same device
/// the air is the same to the bit, however many frames are in flight.
[[nodiscard]] WINDROW_API Result<void>
replay(const EventLog& log, Wind& wind, const std::function<Result<void>(const std::function<void(VkCommandBuffer)>&)>& run);

} // namespace windrow::vulkan
