// The air on the device: the step of fluid/cpu/step.cpp as compute passes, recorded into the host's command buffer.
//
//   place      cells that the box exposes                            only when it moves: cells stay where they are stored
//   sources    motors, guard, reduction: u, f, S                     once a tick, unless one without motors follows another
//   plan       n sub-steps, from the largest speed                   once a tick, where several are recorded or viscosity acts
//   pad        R = ambient + g (u - ambient) - s q + (dt/2) f, V     each sub-step, in six dispatches; eight where planes are
//   advect     w = R(xd) + (dt/2) f                                  split, up to 24 with implicit viscosity
//   solve      L phi = div w: modes of x and z, columns of y, back
//   gradient   u' = w - grad phi, q'; guard, reduction
//   show       textures of this frame, figures of the tick to the host  once a frame
//   report     these figures, in a frame without ticks
//   read_...   what the host asked for                               once a frame
//
// The host records as many sub-steps as its bound of the speed asks for (speed_bound.h); the device chooses how many of them run,
// and carries time over to the next tick where they are too few. Where one is recorded, no pass makes the plan: `pad` derives it.
//
// Parameters of a tick are in host memory that the passes read (host_blocks.h), large tables in a block of it that is written once:
// the host writes no memory that frames in flight use. So a tick has no copies, except where motors, obstacles, deposits or the
// gust tile have changed and do not fit there.
#pragma once

#include "fluid/api.h"
#include "fluid/core/cell_storage.h"
#include "fluid/core/outer_air.h"
#include "fluid/core/snapshot.h"
#include "fluid/solids/loads.h"
#include "fluid/solids/reading.h"
#include "fluid/solids/surface_layer.h"
#include "fluid/vulkan/blocks.h"
#include "fluid/vulkan/pass_clock.h"
#include "fluid/vulkan/passes.h"
#include "fluid/vulkan/read_back.h"
#include "fluid/vulkan/solid_tables.h"
#include "fluid/wind.h"
#include "fluid/window.h"

#include <memory>
#include <span>

namespace windrow::vulkan {

// Stages that the wind's commands run in.
inline constexpr VkPipelineStageFlags k_compute = VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT,
                                      k_transfer = VK_PIPELINE_STAGE_TRANSFER_BIT,
                                      k_indirect = VK_PIPELINE_STAGE_DRAW_INDIRECT_BIT;

/// Report of the device for a tick.
struct AirReport {
    float largest_component = 0.0f; ///< [m/s] after the tick
    float cfl = 0.0f;
    int substeps = 0;
    bool substeps_capped = false;
    float carried_time = 0.0f;      ///< [s]
    int repaired_cells = 0;         ///< of all ticks of the recording
    int limited_cells = 0;          ///< as these
    float apart = 0.0f;             ///< [m/s] largest difference from ambient, in a component
    float pressure_residual = 0.0f; ///< around obstacles, as Diagnostics::pressure_solves
    int pressure_solves = 0;
    unsigned still = 0;                    ///< a bit a tick, the lowest of this one, then of those before: MeasuredSpeed::still
    std::array<float, 4> largest_before{}; ///< [m/s] `largest_component` of the ticks before, the newest first
    double squares = 0.0;                  ///< sum of |u|^2
    double divergence_squares = 0.0;
};

/// What the host reads with each frame, besides the report.
struct Reads {
    ReadBack kind = ReadBack::none;
    glm::ivec3 cells{0}; ///< of the box that is read; all of them but with ReadBack::box
    int points = 0;      ///< room for them
    int forces = 0;      ///< room for bodies
    int slots = 1;       ///< that the host and the device hold together
};

/// The reading of one frame.
struct ReadRequest {
    int slot = 0;
    glm::ivec3 low{0}; ///< first cell that is read
    std::span<const WindrowPoint> points{};
};

class SavedAir;
struct RestoredAir;

class Air {
  public:
    /// Rejects what the device cannot hold or run. The fields hold nothing yet: `fill` first.
    struct Settings {
        Texel texel = Texel::half;
        TextureSet textures = TextureSet::vectors;
        bool gusts = true; ///< there is room for a tile of gusts
        Reads reads{};
        VkExternalMemoryHandleTypeFlagBits exported{}; ///< textures; 0: not
        bool obstacles = false;                        ///< the passes are made for them from the start
        const windrow::Wind* outer = nullptr;          ///< around the box, which outlives it; null: none
    };
    [[nodiscard]] static Result<std::unique_ptr<Air>> create(const Host& host, const Config& config, const Settings& settings);
    /// With calls given, as a test does that has one fail.
    [[nodiscard]] static Result<std::unique_ptr<Air>> create(std::unique_ptr<Device> device, const Config& config,
                                                             const Settings& settings);

    /// Device memory that `create` and the read-backs take. Rejects what they reject by size.
    [[nodiscard]] static Result<Memory::Measured> measure(std::unique_ptr<Device> device, const Config& config,
                                                          const Settings& settings);

    // --- Recording. Each begins and ends with the barriers that the others need; `end` records what is left of them. ---------
    void apply(VkCommandBuffer commands, const CellChange& change);
    /// What a tick is recorded with.
    struct Recorded {
        int substeps = 0;   ///< at most as many run; 0: Config::max_substeps
        bool limits = true; ///< speeds beyond these are cut; else their time is carried over
    };
    /// The ambient wind is the caller's to advance.
    void step(VkCommandBuffer commands, const CellStep& step, const Recorded& recorded);
    /// Writes the air of the tick before, where that waits for the next tick's first pass.
    void keep(VkCommandBuffer commands);
    /// Writes the textures of set `frame` (0 or 1) from the last tick's air and the kept one, `factor` of the way; ends with a
    /// barrier to all shaders that sample them. Before it, they may be in any layout; after it, SHADER_READ_ONLY_OPTIMAL.
    /// `slot`: the one that a `read_back` follows to; it takes the report with the textures.
    void show(VkCommandBuffer commands, float factor, int frame, bool reports, std::optional<int> slot = std::nullopt);
    /// Writes the report and what is read of the last `show` into a slot, which the host reads once these commands are done.
    void read_back(VkCommandBuffer commands, const ReadRequest& request);

    // --- Save and load (air_state.cpp) -------------------------------------------------------------------------------------
    /// Copies what the next tick needs for the host, and what the last `show` did.
    void save(VkCommandBuffer commands, SavedAir& saved);
    /// Writes all of it, before any other command of the air; set 0 of the textures is of the frame shown last, set 1 of the one
    /// before. Needs `make_room_to_restore`.
    void restore(VkCommandBuffer commands, RestoredAir&& air, const AmbientWind& ambient);

    /// The world's origin has moved; nothing is recorded.
    void shift_origin(const OriginShift& shift) {
        shift.move(window_);
        reading_origin_ += shift.cells;
        drag_origin_ += shift.cells;
        if (config_.roughness && config_.roughness->map)
            shift.move(config_.roughness->map->position);
        if (outer_)
            outer_->shift_origin(shift.cells);
    }
    void make_room_to_restore();
    /// As cpu::Cells::set_drag.
    void set_drag(const DragCells& drag, const Window& window) {
        drag_ = drag;
        drag_origin_ = window.origin_cells;
        drag_stale_ = reading_stale_ = true;
    }
    /// What is around the box between ticks; null: the ambient wind.
    [[nodiscard]] const OuterAir* outer() const { return outer_.get(); }
    /// It is this, as OuterAir::restore takes it.
    void restore_outer(std::span<const float> values, CellIndex origin);
    [[nodiscard]] bool fresh() const { return fresh_; }
    /// Faces of obstacles whose history `save` copies.
    [[nodiscard]] DeviceSurface surface() const;

    // --- Reading -------------------------------------------------------------------------------------------------------
    /// Bytes of a slot: the report, then what is read.
    [[nodiscard]] WINDROW_INTERNAL static VkDeviceSize slot_bytes(const Reads& reads);
    /// Where forces begin there, in words behind the report.
    [[nodiscard]] static int forces_at(const Reads& reads);
    [[nodiscard]] const Reads& reads() const { return settings_.reads; }
    [[nodiscard]] const Buffer& slot(int slot) const { return fields_.slots[static_cast<std::size_t>(slot)]; }
    [[nodiscard]] AirReport report(int slot) const;
    /// The bytes after the report, without forces.
    [[nodiscard]] std::span<const std::byte> read(int slot) const;
    /// What acted on a body in the last tick of a slot's recording: the sums of that tick.
    [[nodiscard]] PressurePush push_on(int slot, int body) const;
    /// Bodies of the last tick that was recorded, in the order of the device, and its duration; none where none meets a cell.
    [[nodiscard]] std::span<const detail::PlacedObstacle> bodies() const;
    [[nodiscard]] double step_duration() const { return step_duration_; }
    /// How the last `show` showed cells; null: as they are. The part of its box that they are.
    [[nodiscard]] const std::shared_ptr<const SurfaceReading>& reading() const { return reading_; }
    [[nodiscard]] SurfaceReading::Part sampled_part() const;

    [[nodiscard]] Device& device() { return *device_; }
    [[nodiscard]] const Fields& fields() const { return fields_; }
    [[nodiscard]] const Passes& passes() const { return passes_; }
    /// Dispatches and barriers recorded so far.
    [[nodiscard]] int dispatches() const { return dispatches_; }
    [[nodiscard]] int barriers() const { return barriers_; }
    /// Copies, fills and writes of buffers recorded so far.
    [[nodiscard]] int transfers() const { return transfers_; }
    [[nodiscard]] bool holds_gusts() const { return settings_.gusts; }
    /// Steps were recorded since `begin`; the report counts their cells together.
    [[nodiscard]] bool stepped() const { return stepped_; }
    /// The last step did without the obstacles, for which there was no memory; the next one tries again.
    [[nodiscard]] bool lacks_obstacles() const { return place_again_; }
    /// The same of deposits of drag.
    [[nodiscard]] bool lacks_drag() const { return lacks_drag_; }
    /// Rooms that the last step's volume sources blow into; 0: each can let its air out.
    [[nodiscard]] int sealed_sources() const { return sealed_sources_; }
    /// Most in a sub-step of the last step.
    [[nodiscard]] int sealed_rooms() const { return sealed_rooms_; }
    /// Obstacles of the last step; null: none were placed.
    [[nodiscard]] const Solids* solids() const { return solids_ ? &solids_->solids() : nullptr; }
    /// Sub-steps of each step from now on; 0, as at the start: the device chooses.
    void force_substeps(int substeps) { forced_substeps_ = substeps; }
    /// Times what is recorded from now on; null, as at the start: nothing is timed. The clock outlives the recordings.
    void set_clock(PassClock* clock) { clock_ = clock; }

    // --- Boundaries ------------------------------------------------------------------------------------------------------
    /// Boundaries to come, with the tables of their solves where their kinds are others, and where these lie on their way to the
    /// device.
    struct NewBoundaries {
        Boundaries boundaries;
        std::optional<SolveTables> tables;
        Buffer piece;
        std::vector<WindrowRule> rules;
    };
    /// Rejects where there is no memory for the tables.
    [[nodiscard]] Result<NewBoundaries> prepare(const Boundaries& boundaries, bool kinds);
    /// From the next recording on. Another kind of side leaves the air without a past.
    void set_boundaries(VkCommandBuffer commands, NewBoundaries&& boundaries);

    // --- Frames in flight ------------------------------------------------------------------------------------------------------
    /// The following commands are of this slot; the earlier ones of this slot are done.
    void begin(int slot);
    /// After all else in a command buffer.
    void end(VkCommandBuffer commands) { wait(commands); }
    /// The contents of the device memory are unknown: the next `fill` writes all of it.
    void forget();

  private:
    Air(std::unique_ptr<Device> device, const Config& config, const Settings& settings)
        : device_(std::move(device)), config_(config), settings_(settings), rows_table_(windrow::detail::box_of(config).rows),
          reading_maker_(box(), config_) {}
    [[nodiscard]] Result<Memory::Measured> measure();
    [[nodiscard]] Result<void> make_memory();
    [[nodiscard]] Result<void> make();
    [[nodiscard]] Result<Passes> passes_for(bool obstacles);
    [[nodiscard]] Box box() const { return {config_.cells, config_.cell_size, config_.boundaries, rows_table_}; }
    [[nodiscard]] std::vector<WindrowRow> rows_in(const RowTable& rows) const;
    /// Moves the air of a box with rows of its own down, as that has moved up.
    void lift(VkCommandBuffer commands, const CellChange& change);
    [[nodiscard]] SolveTables tables_of(const Boundaries& boundaries) const;
    [[nodiscard]] Result<Buffer> piece_of(const SolveTables& tables);
    [[nodiscard]] DiffusionMethod diffusion_of(double duration) const;
    [[nodiscard]] WindrowStep block_of(const AmbientWind& ambient, const Window& window, const CellStep& step = {}) const;
    /// `tile` is what the passes read; null: they read none, or the wind's own.
    void write_step(VkCommandBuffer commands, const WindrowStep& block, const AmbientWind& ambient,
                    std::shared_ptr<const GustTile> tile = nullptr);
    static constexpr VkDeviceSize k_max_update = 65536; ///< [bytes] of vkCmdUpdateBuffer
    void write(VkCommandBuffer commands, const Buffer& to, std::span<const std::byte> bytes, VkDeviceSize first = 0);
    /// Gives the passes to come a block of these bytes. Returns its offset.
    [[nodiscard]] std::uint32_t put(VkCommandBuffer commands, HostBlocks& blocks, std::span<const std::byte> bytes);
    void put_step(VkCommandBuffer commands);
    /// Barrier: earlier commands in stages `from` are done before later ones in stages `to`. Recorded with the next command, as
    /// one with all that are asked for before it.
    void barrier(VkPipelineStageFlags from, VkPipelineStageFlags to);
    void wait(VkCommandBuffer commands, std::span<const VkImageMemoryBarrier> images = {});
    /// Passes to come find what earlier ones did.
    void order_passes() {
        if (!ordered_)
            barrier(k_compute, k_compute);
    }
    void copy(VkCommandBuffer commands, const Buffer& from, const Buffer& to, VkDeviceSize at = 0);
    void copy(VkCommandBuffer commands, const Buffer& from, const Buffer& to, const VkBufferCopy& region);
    void clear(VkCommandBuffer commands, const Buffer& buffer, VkDeviceSize at = 0, VkDeviceSize bytes = VK_WHOLE_SIZE);
    /// `command`: its work groups are entry `command` of Fields::commands.
    void dispatch(VkCommandBuffer commands, Pass pass, const Push& push = {}, int frame = 0,
                  std::optional<std::uint32_t> command = std::nullopt);
    /// -1: the rehearsal of the first. `command`: of its first pass.
    void substep(VkCommandBuffer commands, std::span<const Passes::Stage> stages, int number,
                 std::optional<std::uint32_t> command);
    void place(VkCommandBuffer commands, const WindrowPlacePush& push);

    // Obstacles (air_obstacles.cpp)
    [[nodiscard]] int obstacle_flags() const { return solids_ ? solids_->flags() : 0; }
    void place_within_boundaries(VkCommandBuffer commands);
    void lift_obstacles(VkCommandBuffer commands, CellIndex by);
    [[nodiscard]] bool put_obstacles(VkCommandBuffer commands, bool keeps_faces);
    /// As they are `early` [s] before the end of the step.
    void place_obstacles(VkCommandBuffer commands, std::span<const detail::PlacedObstacle> obstacles, double early);
    void restore_obstacles(VkCommandBuffer commands, DeviceSurface&& surface, std::vector<float>&& terms,
                           std::span<const BodyLoad> loads);
    void restore_loads(VkCommandBuffer commands, std::span<const BodyLoad> loads);
    /// Before they are placed for a sub-step; -1: the first one of a tick.
    void uncover(VkCommandBuffer commands, int substep);
    [[nodiscard]] bool finds_forces() const { return settings_.reads.forces > 0; }
    /// Where the history of a slot begins in Fields::around.
    [[nodiscard]] VkDeviceSize history_at(int slot) const;
    [[nodiscard]] VkDeviceSize loads_at(int slot) const; ///< the same of the forces
    [[nodiscard]] bool write_obstacles(VkCommandBuffer commands);
    [[nodiscard]] Result<void> make_room_for_obstacles(VkCommandBuffer commands);
    [[nodiscard]] Result<void> replace(Buffer& buffer, VkDeviceSize bytes);
    [[nodiscard]] Result<void> bind_anew(bool for_obstacles);
    void work_on_rooms(VkCommandBuffer commands, int work);
    [[nodiscard]] Passes::Around around_obstacles(bool has_past) const;
    [[nodiscard]] Passes::Around around_sources() const;
    [[nodiscard]] bool rough() const { return config_.roughness && config_.stages.diffusion; }
    /// `placed`: the obstacles were placed again.
    void renew_layer(VkCommandBuffer commands, const CellStep& step, bool placed);
    // Deposits of drag (air_drag.cpp)
    /// Uploads what has changed since the last step.
    void renew_drag(VkCommandBuffer commands, const CellStep& step);
    [[nodiscard]] bool make_room_for_drag();
    void upload_drag(VkCommandBuffer commands, const DragCells& drag, const detail::CellRange& range);
    /// Motors as the device takes them: what obstacles cover of a volume source blows nothing.
    [[nodiscard]] std::span<const detail::MotorReach> uncovered(std::span<const detail::MotorReach> motors);
    // The outer wind (air_levels.cpp); without one they do nothing
    void follow_outer(const CellChange& change);
    void begin_outer(VkCommandBuffer commands, const CellStep& step);
    void end_outer();
    /// What the passes to come find, where they do not yet.
    void upload_outer(VkCommandBuffer commands);
    void upload_outer(VkCommandBuffer commands, std::span<const glm::vec4> cells, bool second);
    // What is shown (air_shown.cpp)
    void renew_reading(VkCommandBuffer commands);
    [[nodiscard]] Result<void> write_reading(VkCommandBuffer commands);
    void write_tables(VkCommandBuffer commands);
    void make_room_for_sides();
    /// Writes the cells that the last shift exposed, where nothing did yet.
    void place_exposed(VkCommandBuffer commands);
    /// The same in all cells.
    void place_all(VkCommandBuffer commands, int fields, int value) {
        place(commands, {.shift = config_.cells, .fields = fields, .value = value});
    }
    /// The air has no past: no time that is behind, none in which viscosity has not acted.
    void begin_anew(VkCommandBuffer commands);
    [[nodiscard]] WindrowPlacePush exposed() const;
    void adjust(VkCommandBuffer commands, const CellChange& change);
    void upload(VkCommandBuffer commands, std::span<const glm::vec4> cells);

    std::unique_ptr<Device> device_; // before what is made from it
    Config config_;
    Settings settings_;
    std::shared_ptr<const RowTable> rows_table_; ///< of the config; null: none
    std::optional<SolveTables> tables_;
    DiffusionMethod prepared_ = DiffusionMethod::none; ///< the most that any step may ask of the viscosity
    struct Shapes {
        DiffusionMethod diffusion;
        Passes::Around around;
        friend bool operator==(const Shapes&, const Shapes&) = default;
    };
    std::optional<Shapes> shapes_; ///< whose sub-steps Fields::shapes describes
    Fields fields_;
    Passes passes_;
    PassClock* clock_ = nullptr;
    std::shared_ptr<const GustTile> tile_; ///< what Fields::tile holds
    Passes::Blocks blocks_;                ///< that the passes read
    std::vector<std::byte> step_block_{};  ///< the last one: WindrowStep, then the rows
    bool step_put_ = false;                ///< where this recording's passes read it
    bool tables_written_ = false, rules_written_ = false;
    /// Tables on their way, where they are too many for the command buffer itself; they stay for `forget`.
    Buffer piece_;
    int slot_ = 0;        ///< of the recording
    int slot_before_ = 0; ///< and of the one before it
    int piece_slot_ = -1; ///< the one that copies piece_; -1: none
    struct Retired {
        Buffer piece;
        int slot;
    };
    std::vector<Retired> retired_;               ///< pieces that a slot in flight may still copy; with room for one a slot
    std::unique_ptr<SolidTables> solids_;        ///< null until there is an obstacle
    std::vector<detail::PlacedObstacle> placed_; ///< in the sub-step
    std::vector<detail::MotorReach> uncovered_;  ///< scratch
    std::optional<SurfaceLayer> layer_;          ///< over rough ground
    std::vector<float> layer_written_;           ///< what Fields::layer holds; empty before the first time
    std::vector<float> layer_wanted_;            ///< scratch
    std::vector<float> restored_terms_;          ///< the pressure's history of a loaded wind, until its first placement
    std::unique_ptr<OuterAir> outer_;            ///< null: the ambient wind is around the box
    bool outer_stale_ = true;                    ///< the device does not hold its values
    bool outer_turned_ = false;                  ///< the second of the two fields holds those of now
    std::vector<float> drag_words_;              ///< scratch, as `drag_copies_`
    std::vector<VkBufferCopy> drag_copies_;
    bool drag_stale_ = true;  ///< Fields::drag does not hold what the last step had
    bool holds_drag_ = false; ///< some deposit meets the box, and the field has it
    bool lacks_drag_ = false;
    glm::ivec3 unplaced_shift_{0}; ///< [cells] of the box since the obstacles were placed
    bool place_again_ = false;
    bool inside_is_air_ = false;                     ///< cells of `placed_` were filled since, and do not hold their velocity
    std::uint32_t surface_room_ = 0, face_room_ = 0; ///< surface cells and faces that Fields::around holds
    int history_slot_ = 0;
    std::uint32_t body_room_ = 0; ///< bodies whose forces Fields::around holds
    double step_duration_ = 0.0;  ///< [s]
    int sealed_sources_ = 0, sealed_rooms_ = 0;
    bool passes_know_obstacles_ = false;
    struct RetiredPasses { ///< or their sets alone
        Passes passes;
        Sets sets;
        int slot;
    };
    std::vector<RetiredPasses> retired_passes_;
    ReadingMaker reading_maker_;
    std::shared_ptr<const SurfaceReading> reading_; ///< of the last show; null: every cell is shown as it is
    std::vector<std::int32_t> reading_words_;       ///< scratch
    CellIndex reading_origin_{0};                   ///< of the window that it was made for
    DragCells drag_{};                              ///< of the last step
    CellIndex drag_origin_{0};                      ///< of the window that it is of
    glm::ivec3 drag_torus_{0};                      ///< of the fields then
    bool reading_stale_ = true;
    bool reading_known_ = false;      ///< Fields::reading holds what `reading_` says
    Window window_{};                 ///< of the last command
    std::vector<WindrowRule> rules_;  ///< how each padded cell takes its value by the boundaries
    glm::ivec3 torus_{0};             ///< WindrowStep::torus
    std::optional<CellChange> shift_; ///< the last one, whose exposed cells the next tick's first pass writes
    bool fresh_ = true;
    bool first_sources_ = false; ///< the next flow of volume sources follows none
    bool keeps_ = false;         ///< the air of the tick before is the velocity, which the next tick's first pass keeps
    bool counted_ = false; ///< the last sub-step has guarded the air and found its largest speed, and nothing changed it since
    bool cleared_ = false;
    bool stepped_ = false; ///< since `begin`
    float shown_factor_ = 1.0f;
    int reported_slot_ = -1; ///< that the last `show` wrote the report to; -1: none
    int forced_substeps_ = 0;
    int dispatches_ = 0, barriers_ = 0, transfers_ = 0;
    VkPipelineStageFlags waits_from_ = 0, waits_to_ = 0; ///< of the barrier to come
    bool ordered_ = false;                               ///< a barrier between passes was recorded behind the last one
};

} // namespace windrow::vulkan
