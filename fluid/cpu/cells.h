// Cells of a wind on the CPU.
//
// cells.cpp: the operations of the wind's core: set to ambient, move with the box. cells_shown.cpp: what frames and views show.
// step.cpp: a step. cells_levels.cpp: what is around the box, and what a box inside this one needs.
#pragma once

#include "fluid/api.h"
#include "fluid/core/cell_storage.h"
#include "fluid/cpu/aligned.h"
#include "fluid/cpu/ambient_field.h"
#include "fluid/cpu/body_loads.h"
#include "fluid/cpu/outer_wind.h"
#include "fluid/cpu/sources.h"
#include "fluid/cpu/workspace.h"
#include "fluid/operators.h"
#include "fluid/solids/reading.h"
#include "fluid/solids/surface_layer.h"

#include <atomic>
#include <functional>
#include <mutex>
#include <vector>

namespace windrow {
class WindCore;
}

namespace windrow::cpu {

struct DragRows;

/// The air of the last two steps and the second-order history; see step.cpp.
struct TwoLevelAir {
    explicit TwoLevelAir(std::size_t cells) : velocity(cells), velocity_old(cells), history(cells) {}

    Buffer<glm::vec4> velocity;     ///< u [m/s]
    Buffer<glm::vec4> velocity_old; ///< u one sub-step earlier; unset while `fresh`
    Buffer<glm::vec4> history;      ///< q = (dt/2) grad p of the last sub-step [m/s]; unset while `fresh`
    bool fresh = true;              ///< u_old = u and q = 0 without being written
    float dt_old = 0.0f;            ///< [s] last sub-step
    float undiffused_time = 0.0f;   ///< [s] accumulated diffusion time

    [[nodiscard]] std::size_t memory_bytes() const { return velocity.bytes() + velocity_old.bytes() + history.bytes(); }
};

/// Cells of a view as they are sampled beside surfaces.
struct SampledCells {
    Buffer<glm::vec4> cells{};                       ///< empty: none was needed yet
    std::shared_ptr<const SurfaceReading> reading{}; ///< null: as the air's own
    SurfaceReading::Part part{};                     ///< the air's, of the reading's box
    bool held = false;                               ///< false until they are written

    [[nodiscard]] ShownCells shown() const;
};

/// Cells of FrameHistory's frames; empty without.
struct FrameCells {
    struct Field {
        Buffer<glm::vec4> cells{}; ///< [m/s]
        bool held = true;          ///< false while they are the frame's ambient wind, and not written yet
        SampledCells sampled{};
    };
    Buffer<glm::vec4> before; ///< [m/s] air at the tick before the last one, in the current window
    Field shown, shown_before;

    [[nodiscard]] std::size_t memory_bytes() const {
        return before.bytes() + shown.cells.bytes() + shown_before.cells.bytes() + shown.sampled.cells.bytes() +
               shown_before.sampled.cells.bytes();
    }
};

class Cells final : public CellStorage {
  public:
    /// `wind` outlives it, as does `outer`, the cells of the wind around it; null: none.
    Cells(const WindCore& wind, Workspace workspace, Cells* outer = nullptr);

    void make_room(const CellNeeds& needs) override;
    [[nodiscard]] Result<void> set_boundaries(const Boundaries& boundaries, bool kinds) override;
    void apply(const CellChange& change) override;
    [[nodiscard]] bool step(const CellStep& step, Diagnostics& report) override;
    void show(const FrameBlend& blend) override;
    void show_air() override;
    [[nodiscard]] bool filled() const override { return filled_; }
    [[nodiscard]] MeasuredSpeeds measured() const override { return {measured_}; }
    void shift_origin(const OriginShift& shift) override {
        around_origin_cells_ += shift.cells;
        reading_origin_ += shift.cells;
        drag_origin_ += shift.cells;
        if (outer_)
            outer_->shift_origin(shift.cells);
        shift.move(around_);
    }
    [[nodiscard]] std::span<glm::vec4> spare() override { // a step pads them anew
        return {reinterpret_cast<glm::vec4*>(work.state().padded_carried.data()), box().cell_count()};
    }

    [[nodiscard]] const Box& box() const { return work.box(); }
    /// Views of the air, and of the frames shown; their cells are written from then on. Thread-safe.
    [[nodiscard]] WindView air_view();
    [[nodiscard]] WindView view(FrameCells::Field& field, const ShownFrame& frame);
    /// The frame shown, or the one before it; without frames the air.
    [[nodiscard]] WindView shown_view(bool before);
    /// Writes the ambient wind into cells that are marked as ambient. Thread-safe.
    void materialise_air();
    void materialise_all(); ///< also in the frames
    /// Marks the cells of the air, and of the tick before, as written.
    void set_held();
    [[nodiscard]] std::size_t memory_bytes() const;
    [[nodiscard]] WINDROW_INTERNAL SurfaceHistory surface_history() const;
    [[nodiscard]] bool has_obstacles() const { return work.state().has_solids(); }
    /// 1 for cells inside obstacles, else 0.
    void write_obstacles(std::span<float> cells) const;
    /// [m^2/s^2] The pressure whose gradient the history holds. Throws std::bad_alloc.
    void write_pressure(std::span<float> result);
    /// Places the obstacles of the last step. Throws std::bad_alloc.
    void set_surface_history(SurfaceHistory&& history);

    /// The potential of the last step's last solve, part of the pressure that acted.
    struct KeptPotential {
        float weight = 0.0f;        ///< in what the history keeps of it; 0: it is not known
        std::vector<float> cells{}; ///< empty where it is not
    };
    [[nodiscard]] WINDROW_INTERNAL KeptPotential kept_potential() const;
    void set_kept_potential(const KeptPotential& kept);

    // --- For a wind whose surroundings are this one (outer_wind.h) ---------------------------------------------------------
    /// The plants that a loaded wind is read among until its first step.
    void set_drag(const DragCells& drag, const Window& window) {
        drag_ = drag;
        drag_origin_ = window.origin_cells;
        reading_stale_ = true;
    }
    /// Of the wind around this one; null: none.
    [[nodiscard]] Cells* outer_cells() const { return outer_ ? &outer_->cells() : nullptr; }
    /// From now on, the pressure of the last two ticks. Throws std::bad_alloc.
    void keep_pressure();
    [[nodiscard]] bool keeps_pressure() const { return !pressure_.empty(); }
    /// No longer: no wind is inside this one.
    void drop_pressure() { pressure_ = {}, pressure_before_ = {}; }
    [[nodiscard]] bool asleep() const;
    /// [m^2/s^2] Of a cell in the frame shown.
    [[nodiscard]] float shown_pressure(std::size_t cell) const;
    /// The ambient wind in the cells of the frame shown: they lie between those of two ticks, and so do their gusts.
    struct ShownAmbient {
        AmbientWind now, before;
        float factor = 1.0f; ///< of the way from `before`
    };
    [[nodiscard]] ShownAmbient shown_ambient() const;
    /// visit(cell, velocity) for each cell in a body that is read as air beside it, in the frame shown.
    void for_each_filled(const std::function<void(std::uint32_t, glm::vec3)>& visit) const;

    [[nodiscard]] WINDROW_INTERNAL LevelState level_state() const;
    /// False where it is that of another box. Throws std::bad_alloc.
    [[nodiscard]] bool set_level_state(const LevelState& level);

    Workspace work;
    TwoLevelAir air;
    FrameCells frames;
    SourceField sources;
    BodyLoads loads; ///< forces on the obstacles
    /// u_S [m/s], part of the velocity; empty until the first volume source, 0 while there is none.
    Buffer<glm::vec4> source_flow;
    Buffer<glm::vec4> solved; ///< scratch for u less its prescribed part; empty until a part is prescribed

  private:
    static constexpr std::uint64_t k_unheld = ~std::uint64_t{0};

    // --- cells.cpp ---------------------------------------------------------------------------------------------------------
    void make_room_around(const Gusts& gusts);
    void make_room_for_step(float dt);
    void make_room_for_viscosity(DiffusionMethod method);
    void reserve_solved();
    /// Updates the ambient fields to the ambient wind in `window`.
    void renew_around(const AmbientWind& ambient, const Window& window, const ParallelFor& parallel_for);
    void bend_profile(const Window& window);
    /// [m/s] Ambient wind of a cell of the box; without gusts.
    [[nodiscard]] glm::vec4 ambient_at(int i, int j, int k) const;
    [[nodiscard]] glm::vec4 mean_at(int i, int j, int k) const;
    /// The prescribed wind of cell n, and what the solved part of its velocity relaxes to: 0 in a closed room.
    [[nodiscard]] glm::vec4 wind_at(std::size_t n, int i, int j, int k) const;
    [[nodiscard]] glm::vec4 rest_at(std::size_t n, int i, int j, int k) const;
    [[nodiscard]] bool in_room(std::size_t n) const;
    /// The wind around: of a cell outside of closed rooms that is what the ambient wind, or the wind of `wind_at`, and D are.
    [[nodiscard]] glm::vec4 change_at(int i, int j, int k) const { return outer_ ? outer_->at(i, j, k) : glm::vec4(0.0f); }
    [[nodiscard]] glm::vec4 around_at(std::size_t n, int i, int j, int k) const;
    /// The cells as they are beside surfaces, of the frame shown.
    [[nodiscard]] const SampledCells& shown_sample() const { return frames.before.empty() ? sampled_ : frames.shown.sampled; }
    void fill(std::span<glm::vec4> field) const;
    void fill_air();
    void set(std::span<const glm::vec4> cells);
    void shift(const CellChange& change);
    void shift_pressure(const CellChange& change);
    void add_wind(const CellChange& change);
    void add_change(const CellChange& change);
    void keep();
    /// For calls that change the wind, which no other thread reads meanwhile.
    void materialise_air_alone(const ParallelFor& parallel_for);
    void materialise_frame(FrameCells::Field& field, const ShownFrame& frame);
    void materialise_before();
    void materialise_gusts(std::span<glm::vec4> field, const AmbientWind& wind, const Window& window);
    [[nodiscard]] bool has_source_flow() const;

    // --- cells_shown.cpp -----------------------------------------------------------------------------------------------------
    void renew_reading();
    /// Writes the sampled cells of `from`, the air in a window.
    void sample_once(std::span<const glm::vec4> from, const Window& window, SampledCells& sampled);
    void sample(std::span<const glm::vec4> from, const Window& window, SampledCells& sampled, const ParallelFor& parallel_for);

    // --- step.cpp ----------------------------------------------------------------------------------------------------------
    class Solving;
    /// Places the obstacles for a sub-step that ends `early` [s] before the step; true where some came, went or moved.
    [[nodiscard]] bool place_obstacles(const CellStep& step, double early, Diagnostics& report);
    void refill();
    void put_obstacles(glm::ivec3 shift);
    void lift_obstacles(CellIndex by);
    void uncover();
    template <class Visit>
    void for_each_room(const Visit& visit) const;
    template <class Visit>
    void for_each_inside_now(const Visit& visit) const;
    void still_new_rooms();
    [[nodiscard]] double volume_of(std::uint32_t cell) const;
    void bound_rooms(std::span<const glm::vec4> before, std::span<glm::vec4> after);
    [[nodiscard]] bool worked_on(std::span<const std::uint32_t> room) const;
    /// Of the prescribed winds at the end of the sub-step.
    [[nodiscard]] PrescribedFlow prescribed() const;
    void project_around(std::span<glm::vec4> velocity, const Workspace::State::GradientNote& note, float guess_scale, int solves,
                        Diagnostics& report, const Beyond* beyond = nullptr);
    void extend_into_bodies();
    void forget_inside();
    [[nodiscard]] std::span<const Solids::InsideCell> inside_bodies() const;
    /// Takes the mean over each closed room out of the volume sources, since no air can leave it.
    void seal_sources(std::span<const detail::MotorReach> reached, Diagnostics& report);
    [[nodiscard]] bool reaches_room(const detail::MotorReach& motor) const;
    /// Of each volume source, the fraction outside of bodies and closed rooms; empty without bodies.
    [[nodiscard]] std::span<const float> open_parts(std::span<const detail::MotorReach> reached);
    /// The flow of volume sources, around obstacles.
    void project_sources(const FreeAir* beyond);
    void add_sources(const CellStep& step, bool other_obstacles, Diagnostics& report);
    [[nodiscard]] bool acts_whole() const;
    void act_whole(float dt);
    void renew_source_flow(std::span<const detail::MotorReach> reached);
    /// Chooses the number of sub-steps.
    void limit_speeds(const CellStep& step, Diagnostics& report);
    /// [m/s] Most that a component may be where a step of dt [s] in all sub-steps allowed is to carry it.
    [[nodiscard]] float fastest_carried(float dt) const;
    void cut_speeds(float most, Diagnostics& report);
    void repair_cells();
    /// Finds the gusts at the end of the sub-step. carry_gusts makes them the current ones.
    void foresee_gusts(Diagnostics& report);
    void carry_gusts();
    [[nodiscard]] std::span<const glm::vec4> without_prescribed();
    void add_prescribed(std::span<glm::vec4> field, float factor);
    /// Not in sheltered cells.
    void add_ambient(std::span<glm::vec4> field, float factor);
    [[nodiscard]] std::span<const glm::vec4> diffuse(std::span<const glm::vec4> field, float dt, Diagnostics& report);
    [[nodiscard]] std::span<const glm::vec4> mix(std::span<const glm::vec4> field, float dt, Diagnostics& report);
    void deepen_lee(const DragRows& drag, float dt, int plane);
    void deepen_lee_beside(const Solids& solids, glm::ivec3 cell, float drag, float dt);
    void advect_among(const Transport& transport, std::span<glm::vec4> result);
    void note_pressure(float dt, const numerics::WindrowPast& past);
    void advance_second_order(float dt, Diagnostics& report);
    void rehearse(float dt, Diagnostics& report);
    void perform(float dt, int solves, Diagnostics& report);
    [[nodiscard]] bool write_prescribed(std::size_t n, glm::ivec3 cell, std::span<glm::vec4> winds) const;
    void advance_stable_fluids(float dt, Diagnostics& report);
    void advance_in_place(float dt, Diagnostics& report);
    void measure(Diagnostics& report);
    [[nodiscard]] bool at_ambient() const;
    /// What a sub-step leaves of the difference from the ambient wind.
    [[nodiscard]] float relaxation(float dt) const {
        return relaxation_time_ > 0.0f ? 1.0f / (1.0f + dt / relaxation_time_) : 1.0f;
    }

    const WindCore& wind_;
    const Config& config_;                     ///< of `wind_`
    std::optional<OuterWind> outer_;           ///< none: the ambient wind is around the box
    Buffer<float> pressure_, pressure_before_; ///< [m^2/s^2] of the air, and of the tick before; empty: not kept
    float shown_factor_ = 1.0f;                ///< of the frame shown, between them
    AmbientWind around_;                       ///< wind of the ambient fields; within a step ahead of the wind's own
    CellIndex around_origin_cells_{0};         ///< window of the ambient fields
    bool around_stale_ = true;                 ///< ambient fields unset, or boundary conditions changed
    AmbientField mean_field_;                  ///< the mean wind cell by cell; empty without a profile
    AmbientField ambient_field_;               ///< the same with gusts; empty without gusts
    AmbientField ambient_next_;                ///< within a step: at its end
    detail::HostVector<float>
        profile_bends_;                  ///< second differences of the profile, one a padded row; empty without profile or gusts
    glm::dvec3 next_phase_{0.0};         ///< [m] of the gusts at the end of the sub-step
    CanopyRows canopy_;                  ///< of the step, as `relaxation_time_`
    DragCells drag_;                     ///< the same
    CellIndex drag_origin_{0};           ///< of the window that it is of
    float relaxation_time_ = 0.0f;       ///< [s]
    std::vector<PlacedObstacle> placed_; ///< in the sub-step
    glm::ivec3 unplaced_shift_{0};       ///< cells by which the box has moved since the obstacles were placed
    std::vector<glm::vec4> sheltered_air_; ///< scratch: one a sheltered cell
    bool filled_ = false;                  ///< and not stepped since
    bool place_again_ = false;             ///< memory was missing
    float potential_weight_ = 0.0f;        ///< as KeptPotential has it
    bool inside_is_air_ = false;           ///< cells of `placed_` were filled since, and do not hold their velocity
    bool bodies_move_ = false;             ///< some obstacle in the box moves in this step
    MeasuredSpeed measured_;               ///< of the last step
    Buffer<glm::vec4> diffused_;           ///< the velocity after diffusion and mixing; empty while neither acts
    std::optional<SurfaceLayer> layer_;    ///< over rough ground
    bool placed_anew_ = false;             ///< obstacles, since the layer was renewed
    ReadingMaker reading_maker_;
    std::shared_ptr<const SurfaceReading> reading_; ///< null: none, or stale
    CellIndex reading_origin_{0};                   ///< of the window that it was made for
    bool reading_stale_ = true;
    FrameCells frames_before_;             ///< of ticks that ended: a host may still show their memory
    SampledCells sampled_;                 ///< of the air; not with frames
    detail::HostVector<float> open_parts_; ///< scratch of open_parts
    FreeAir free_air_;                     ///< potential of the volume sources; empty until the first
    /// Sleep::drift when the air, and that of the tick before, were written. Otherwise they are ambient, written when read.
    std::atomic<std::uint64_t> held_at_ = 0;
    std::uint64_t before_held_at_ = 0;
    std::mutex holding_; ///< of what is held, in frames too
};

} // namespace windrow::cpu
