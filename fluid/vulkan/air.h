// The air on the device: the step of fluid/cpu/step.cpp as compute passes, recorded into the host's command buffer.
//
//   place      fields move with the box                              only when it moves
//   sources    motors, guard, survey: u, f, S                        once a tick
//   plan       n sub-steps, from the largest speed                   once a tick; sub-steps that do not run get no work groups
//   pad        R = ambient + g (u - ambient) - s q + (dt/2) f, V     each sub-step, in six dispatches; eight where planes are
//   advect     w = R(xd) + (dt/2) f                                  split, up to 24 with implicit viscosity
//   solve      L phi = div w: modes of x and z, columns of y, back
//   gradient   u' = w - grad phi, q'
//   show       textures of this frame, report                        once a frame
//
// Sub-steps are chosen on the device, so all that may be are recorded. What the host tells a tick travels inside the command
// buffer (vkCmdUpdateBuffer); large tables in a piece of host memory that is written once: frames in flight share nothing that
// the host writes while they run.
#pragma once

#include "fluid/ambient.h"
#include "fluid/motor_reach.h"
#include "fluid/vulkan/blocks.h"
#include "fluid/vulkan/pass_clock.h"
#include "fluid/vulkan/passes.h"
#include "fluid/wind.h"
#include "fluid/window.h"

#include <memory>
#include <span>

namespace windrow::vulkan {

/// What acts in a tick.
struct AirTick {
    double duration = 0.0; ///< [s]
    std::span<const detail::MotorReach> motors{};
    std::shared_ptr<const GustTile> tile{}; ///< of their eddies; null: none has any
    /// As it blows at the tick's start; `Air` does not keep it.
    const AmbientWind* ambient = nullptr;
    const Window* window = nullptr;
    glm::vec3 canopy{0.0f};      ///< [1/m] drag, 0: none; ground and top [cells above the low side]
    bool renews_sources = false; ///< the sources of air are not those of the last tick
    bool lets_air_in = false;    ///< the velocity holds a flow of sources, after this tick's change
    int substeps = 0;            ///< forced; 0: the device chooses
    bool counts_on = false;      ///< not the first tick of its recording: the report counts their cells together
};

/// What the device found in a tick.
struct AirReport {
    float largest_component = 0.0f; ///< [m/s] after the tick
    float cfl = 0.0f;
    int substeps = 0;
    bool substeps_capped = false;
    int repaired_cells = 0; ///< of all ticks of the recording
    int limited_cells = 0;  ///< as these
    float apart = 0.0f;     ///< [m/s] largest difference from ambient, in a component
    double squares = 0.0;   ///< sum of |u|^2
    double divergence_squares = 0.0;
};

class Air {
  public:
    /// Refuses what the device cannot hold or run. The fields hold nothing yet: `fill` first.
    struct Settings {
        bool half = true;  ///< R16F textures, else R32F
        bool gusts = true; ///< there is room for a tile of gusts
    };
    [[nodiscard]] static Result<std::unique_ptr<Air>> create(const Host& host, const Config& config, const Settings& settings);
    /// With calls given, as a test does that has one fail.
    [[nodiscard]] static Result<std::unique_ptr<Air>> create(std::unique_ptr<Device> device, const Config& config,
                                                             const Settings& settings);

    // --- Recording. Each begins and ends with the barriers that the others need; `end` records what is left of them. ---------
    /// All cells become ambient; no past.
    void fill(VkCommandBuffer commands, const AmbientWind& ambient, const Window& window);
    /// The air stays where it is while the box moves by whole cells; `ambient` and `window` as they are after the move.
    struct Move {
        CellIndex by{0};
        bool exposed_hold_ambient = true; ///< else 0
        bool kept = true;                 ///< what is kept of the air moves too
        bool lets_air_in = true;          ///< and the flow of sources, else it is 0
    };
    void shift(VkCommandBuffer commands, const Move& move, const AmbientWind& ambient, const Window& window);
    /// What is kept of the air becomes ambient.
    void fill_before(VkCommandBuffer commands, const AmbientWind& ambient, const Window& window);
    /// Adds `factor` times the ambient wind to the air; to what is kept of it too if `to_before`.
    void add_wind(VkCommandBuffer commands, float factor, bool to_before, const AmbientWind& ambient, const Window& window);
    /// Adds a change of the mean wind, by its profile.
    void add_change(VkCommandBuffer commands, glm::vec3 change, bool to_air, bool to_before, const AmbientWind& ambient,
                    const Window& window);
    /// The field becomes `cells`, which travel inside the command buffer; no past.
    void upload(VkCommandBuffer commands, std::span<const glm::vec4> cells);
    /// Keeps the air as it is for blending.
    void keep_before(VkCommandBuffer commands);
    void step(VkCommandBuffer commands, const AirTick& tick);
    /// Writes the textures of set `frame` (0 or 1) from the last tick's air and the kept one, `factor` of the way; ends with a
    /// barrier to all shaders that sample them. Before it, they may be in any layout; after it, SHADER_READ_ONLY_OPTIMAL.
    void show(VkCommandBuffer commands, float factor, int frame, bool reports);
    /// Copies the report and, if `cells`, the shown cells for the host; `slot` is read once the host knows that these commands
    /// are done.
    void read_back(VkCommandBuffer commands, const Buffer& slot, bool cells = true);

    // --- Reading -------------------------------------------------------------------------------------------------------
    /// Bytes of a read-back slot, with or without cells.
    [[nodiscard]] VkDeviceSize slot_bytes(bool cells = true) const;
    [[nodiscard]] AirReport report(const Buffer& slot) const;
    [[nodiscard]] std::span<const glm::vec4> shown(const Buffer& slot) const;

    [[nodiscard]] Device& device() { return *device_; }
    [[nodiscard]] const Fields& fields() const { return fields_; }
    [[nodiscard]] const Passes& passes() const { return passes_; }
    /// Dispatches and barriers recorded so far.
    [[nodiscard]] int dispatches() const { return dispatches_; }
    [[nodiscard]] int barriers() const { return barriers_; }
    [[nodiscard]] bool holds_gusts() const { return settings_.gusts; }
    /// Times what is recorded from now on; null, as at the start: nothing is timed. The clock outlives the recordings.
    void set_clock(PassClock* clock) { clock_ = clock; }

    // --- Sides -----------------------------------------------------------------------------------------------------------------
    /// Sides to come, with the tables of their solves where their kinds are others, and where these lie on their way to the
    /// device.
    struct NewSides {
        Sides sides;
        std::optional<SolveTables> tables;
        Buffer piece;
        std::vector<WindrowRule> rules;
    };
    /// Refuses where there is no memory for the tables.
    [[nodiscard]] Result<NewSides> prepare(const Sides& sides, bool kinds);
    /// From the next recording on. Another kind of side leaves the air without a past.
    void set_sides(NewSides&& sides);

    // --- Frames in flight ------------------------------------------------------------------------------------------------------
    /// What follows is recorded for this slot, and what was recorded for it before is done.
    void begin(int slot);
    /// After all else in a command buffer.
    void end(VkCommandBuffer commands) { wait(commands); }
    /// What the device holds is not known: all of it is written anew by the next `fill`.
    void forget();

  private:
    Air(std::unique_ptr<Device> device, const Config& config, const Settings& settings)
        : device_(std::move(device)), config_(config), settings_(settings) {}
    [[nodiscard]] Result<void> make();
    [[nodiscard]] Box box() const { return {config_.cells, config_.cell_size, config_.sides}; }
    [[nodiscard]] SolveTables tables_of(const Sides& sides) const;
    [[nodiscard]] Result<Buffer> piece_of(const SolveTables& tables);
    [[nodiscard]] DiffusionMethod diffusion_of(double duration) const;
    [[nodiscard]] WindrowStep step_of(const AirTick& tick) const;
    /// `tile` is what the passes read; null: they read none, or the wind's own.
    void tell(VkCommandBuffer commands, const WindrowStep& step, const AmbientWind& ambient,
              std::shared_ptr<const GustTile> tile = nullptr);
    static constexpr VkDeviceSize k_most_update = 65536; ///< [bytes] of vkCmdUpdateBuffer
    void write(VkCommandBuffer commands, const Buffer& to, std::span<const std::byte> bytes);
    /// What was recorded so far in stages `from` is done before what follows in stages `to`. Recorded with the next command, as
    /// one with all that are asked for before it.
    void barrier(VkPipelineStageFlags from, VkPipelineStageFlags to);
    void wait(VkCommandBuffer commands, std::span<const VkImageMemoryBarrier> images = {});
    void copy(VkCommandBuffer commands, const Buffer& from, const Buffer& to, VkDeviceSize at = 0);
    void clear(VkCommandBuffer commands, const Buffer& buffer, VkDeviceSize at = 0, VkDeviceSize bytes = VK_WHOLE_SIZE);
    void dispatch(VkCommandBuffer commands, Pass pass, const Push& push = {}, int frame = 0);
    void place(VkCommandBuffer commands, const Buffer& field, const WindrowPlacePush& push);
    void write_tables(VkCommandBuffer commands);
    void make_room_for_sides();
    void adjust(VkCommandBuffer commands, const WindrowAdjustPush& push);
    [[nodiscard]] WindrowPlacePush everything() const { return {.shift = config_.cells, .exposed_hold_ambient = 1}; }

    std::unique_ptr<Device> device_; // before what is made from it
    Config config_;
    Settings settings_;
    std::optional<SolveTables> tables_;
    DiffusionMethod prepared_ = DiffusionMethod::none; ///< the most that any step may ask of the viscosity
    std::optional<DiffusionMethod> shapes_;            ///< whose sub-steps Fields::shapes describes
    Fields fields_;
    Passes passes_;
    PassClock* clock_ = nullptr;
    std::shared_ptr<const GustTile> tile_; ///< what Fields::tile holds
    bool tables_written_ = false, rules_written_ = false;
    /// Tables on their way, where they are too many for the command buffer itself; they stay for `forget`.
    Buffer piece_;
    int slot_ = 0;        ///< of the recording
    int piece_slot_ = -1; ///< the one that copies piece_; -1: none
    struct Retired {
        Buffer piece;
        int slot;
    };
    std::vector<Retired> retired_;   ///< pieces that a slot in flight may still copy; with room for one a slot
    std::vector<WindrowRule> rules_; ///< how each padded cell takes its value by the boundaries
    bool fresh_ = true;
    bool diffused_whole_ = true; ///< viscosity has acted for all time so far
    bool cleared_ = false;
    int dispatches_ = 0, barriers_ = 0;
    VkPipelineStageFlags waits_from_ = 0, waits_to_ = 0; ///< of the barrier to come
};

} // namespace windrow::vulkan
