// The wind in a box that follows a player, on the CPU: the main header of the library.
//
//     auto wind = windrow::Wind::create({.ambient = {3.0f, 0.0f, 0.0f}});          // 32 x 16 x 32 cells of 1 m, open boundaries
//     auto fan  = wind->motors().add(windrow::DirectionalMotor{.position = {4.0, 1.0, 0.0}});
//     wind->follow(player_position);                                               // moves by whole cells, without loss
//     wind->advance(frame_seconds);                                                // fixed ticks, blended for this frame
//     glm::vec3 at_leaf = wind->velocity(leaf_position);                           // [m/s]
//
// Right-handed, y up, metres and seconds. Positions are double; the solver works relative to the box, so 10^6 m away is
// as exact as the origin. One thread at a time may use a Wind; two Winds have no common state.
#pragma once

#include "ambient.h"
#include "api.h"
#include "box.h"
#include "canopy.h"
#include "diagnostics.h"
#include "motors.h"
#include "obstacle_force.h"
#include "obstacles.h"
#include "operators.h"
#include "owned.h"
#include "parallel.h"
#include "result.h"
#include "roughness.h"
#include "simd.h"
#include "textures.h"
#include "view.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

namespace windrow {

enum class Scheme : std::uint8_t {
    second_order,  ///< Semi-implicit semi-Lagrangian, centred forces, one direct projection: order 2 at fixed CFL. The default.
    stable_fluids, ///< The classic split (Stam 1999): forces, diffusion, advection, projection, each whole: order 1.
};

template <>
inline constexpr std::array<const char*, 2> k_words<Scheme>{"second_order", "stable_fluids"};

/// Stages of a step, to switch off in tests. A stage whose parameter is 0 costs nothing anyway.
/// Without advection there is no trajectory to centre forces on: the whole f dt acts in the step.
struct Stages {
    bool sources = true;
    bool relaxation = true;
    bool diffusion = true;
    bool advection = true;
    bool projection = true;

    static constexpr auto settings() {
        return std::tuple{
            Setting("sources", &Stages::sources, "Motors and the canopy."),
            Setting("relaxation", &Stages::relaxation, "The return to the ambient wind."),
            Setting("diffusion", &Stages::diffusion, "Viscosity, and the mixing over rough ground."),
            Setting("advection", &Stages::advection, "Transport of the velocity by itself."),
            Setting("projection", &Stages::projection, "The pressure, which makes the air incompressible."),
        };
    }
};

/// Fixed ticks of `advance`.
struct Ticks {
    double hz = 30.0;
    int max_per_call = 4;

    static constexpr auto settings() {
        return std::tuple{
            Setting("hz", &Ticks::hz, {1.0, 1e4},
                    "Ticks a second. At 30, blended between ticks, leaves move as smoothly as at 144, at a fifth of the cost."),
            Setting("max_per_call", &Ticks::max_per_call, {1.0, 1000.0},
                    "Maximal number of ticks in one call. Time beyond them is dropped and reported: a slow machine gets a slower "
                    "wind, not an "
                    "ever longer frame."),
        };
    }
};

struct Config {
    glm::ivec3 cells{32, 16, 32};
    float cell_size = 1.0f;
    Boundaries boundaries{};
    glm::dvec3 centre{0.0};
    std::optional<glm::bvec3> follow_axes{};
    glm::vec3 ambient{0.0f};
    std::optional<LogProfile> profile{};
    Gusts gusts{};
    std::optional<Canopy> canopy{};
    std::optional<Roughness> roughness{};
    std::optional<Rows> rows{};
    float blend_width = 2.0f;
    float viscosity = 1.5e-5f;
    float relaxation_time = 20.0f;
    float sleep_speed = 1e-3f;
    Scheme scheme = Scheme::second_order;
    Interpolation interpolation = Interpolation::cubic;
    float max_cfl = 2.0f;
    int max_substeps = 8;
    int pressure_solves = 0;
    Stages stages{};
    Ticks ticks{};
    Simd simd = Simd::best;
    /// Threads of the host; default serial. Results do not depend on it.
    ParallelFor parallel_for{};

    static constexpr auto settings() {
        return std::tuple{
            Setting("cells", &Config::cells, Box::k_cells_range,
                    "Cells along x, y, z; at most 67,108,864 in all. Odd sizes too. The default is 32 m around a player at 1 m, "
                    "half as "
                    "high."),
            Setting("cell_size", &Config::cell_size, Box::k_cell_size_range,
                    "Edge of a cell; with rows of their own, along x and z. At 1 m a gust that a person notices spans several."),
            Setting("boundaries", &Config::boundaries,
                    "Boundary conditions of the six faces. Default: open everywhere; Boundaries::open_over_floor() adds ground. "
                    "Periodic boundaries come in pairs."),
            Setting("centre", &Config::centre, k_world_range,
                    "Point that the box is centred on at the start, to whole cells; for good on axes that do not follow."),
            Setting("follow_axes", &Config::follow_axes,
                    "Axes x, y, z along which the box follows. Default: those with two open boundaries; others cannot."),
            Setting(
                "ambient", &Config::ambient, k_speed_range,
                "Mean wind: of the air at the start, of the inflow through open boundaries, of new cells. Its component along an "
                "axis that a wall closes is dropped."),
            Setting("profile", &Config::profile,
                    "Wind over open ground: log((z + z0) / z0), 0 at the ground (the box's floor, or height 0 without one), the "
                    "ambient wind at the reference height, more above. Default none: the same wind at all heights; {} for the "
                    "profile with its own defaults."),
            Setting(
                "gusts", &Config::gusts,
                "A frozen pattern that the ambient wind carries along, outside the box and through it. Calm air has none. The "
                "pattern is not periodic in the box: it jumps at periodic boundaries."),
            Setting(
                "canopy", &Config::canopy,
                "Drag of plants of uniform height and density on the floor, or at height 0 without one. The inflow, and the "
                "wind to which the air relaxes, is still the ambient wind. Default none, which costs nothing: plants then bend "
                "in the wind and do not slow it; {} for wheat."),
            Setting(
                "roughness", &Config::roughness,
                "Rough ground: its drag, and the mixing of the air above it by turbulence. Default none, which costs nothing: "
                "the ground is smooth, and a profile is worn away by what the air does; {} for short grass."),
            Setting(
                "rows", &Config::rows,
                "Rows of cells of unequal thickness, thin near the ground and thick aloft; {} for rows of half a metre that grow "
                "by a tenth from the fifth on. Default none, which costs nothing: all rows are cell_size thick. At most 128 "
                "rows. Such a box keeps its height, which set_floor changes by whole lowest rows, and the air is then "
                "interpolated; it cannot repeat along y."),
            Setting(
                "blend_width", &Config::blend_width, {.min = 0.0, .max = 64.0, .unit = "cells", .zero = "none"},
                "Width over which sampled wind fades to ambient at the boundaries along which the box follows. It ends one cell "
                "before the box does (two with ticks), so that a shift of the box moves nothing. Axes of fewer than 8 cells "
                "(10 with "
                "ticks) have none."),
            Setting("viscosity", &Config::viscosity, {0.0, 1e9, "m^2/s"},
                    "Kinematic viscosity. Default: that of air, which at 1 m cells is below what the solver resolves and costs "
                    "nothing."),
            Setting("relaxation_time", &Config::relaxation_time, {0.0, 1e9, "s", "never"},
                    "Time constant of the relaxation to the ambient wind. Default 20: a collocated solver has no other damping "
                    "of the "
                    "checkerboard mode in still air. 0 is for analytic cases."),
            Setting("sleep_speed", &Config::sleep_speed, {0.0, 1e4, "m/s", "never"},
                    "Air that differs from ambient by less everywhere, with no motor in reach and no gusts, sleeps: it becomes "
                    "ambient, and a step costs microseconds until something acts. It does not sleep without a relaxation time or "
                    "while "
                    "viscosity acts."),
            Setting("scheme", &Config::scheme,
                    "Time scheme. second_order: semi-implicit semi-Lagrangian. stable_fluids: the classic split, first "
                    "order."),
            Setting("interpolation", &Config::interpolation,
                    "Interpolation of the advection. linear: never overshoots, smooths. cubic: third order."),
            Setting("max_cfl", &Config::max_cfl, Range::above(0.0, 1e6),
                    "Cells that the air may cross in one sub-step. Above 2 the backtrace may miss thin motors; large values are "
                    "for tests "
                    "of the raw step."),
            Setting("max_substeps", &Config::max_substeps, {1.0, 64.0},
                    "Maximal number of sub-steps in a step. Beyond max_cfl * max_substeps cells a step, speeds are limited (and "
                    "counted)."),
            Setting(
                "pressure_solves", &Config::pressure_solves, {.min = 0.0, .max = 64.0, .zero = "one, two while obstacles move"},
                "Direct solves of the pressure around obstacles in a sub-step. Each further solve costs about a fifth of a step; "
                "without obstacles in the box there is one."),
            Setting("stages", &Config::stages, "Stages that run.", k_in_snapshots),
            Setting("ticks", &Config::ticks, "Fixed ticks of `advance`.", k_in_snapshots),
            Setting(
                "simd", &Config::simd,
                "Instructions of the hot loops. Default: the best that this machine runs. Each level gives one result, baseline "
                "the same on all machines.",
                k_in_snapshots),
            Setting("parallel_for", &Config::parallel_for, "Threads of the host.", k_not_stored),
        };
    }
};

/// All reasons why a config is invalid, one per line.
[[nodiscard]] WINDROW_API Result<void> validate(const Config& config);
WINDROW_API void check_rules(detail::Reasons& reasons, const detail::FieldPath& path, const Config& config);

/// Result of `advance`.
struct Advance {
    int ticks = 0;        ///< ticks that ran
    double dropped = 0.0; ///< [s] time beyond Ticks::max_per_call that was not simulated
    float factor = 0.0f;  ///< position of this frame between the last two ticks, 0 to 1
    Diagnostics last{};   ///< of the last tick that ran; stepped = false if none did
};

class WINDROW_API Wind {
  public:
    [[nodiscard]] static Result<Wind> create(const Config& config);

    /// Advances the air by dt [s]. Steps may have any length and may differ: the order stays 2, and no sequence creates energy.
    /// 0 is a pause: nothing changes. A dt that is negative or not finite does nothing and returns Diagnostics::stepped = false.
    /// Does not allocate; only the first step with a volume source among the motors, and a step above 1 s that asks more of the
    /// viscosity than shorter ones, do so, once. Where that memory is missing the wind stays as it was and the step returns
    /// Diagnostics::out_of_memory.
    Diagnostics step(double dt);
    /// Advances by a frame of dt [s] in fixed ticks (Config::ticks), so that the air does not depend on the frame rate: `follow`
    /// and `Motors::move` give where things are at the end of this frame, and each tick sees them at its own time on the way.
    /// Sampling then returns the wind blended between the last two ticks, up to a tick old. The first call allocates
    /// three fields; later ones nothing beyond what `step` may. Where memory is missing nothing is done and
    /// `last.out_of_memory` is true. A dt that is negative or not finite does nothing. Mixing with `step` ends the blending.
    Advance advance(double dt);

    // --- Motors, obstacles, ambient wind, boundaries: without memory each call fails and the wind is unchanged --------------
    [[nodiscard]] Motors& motors();
    [[nodiscard]] const Motors& motors() const;
    /// Bodies and buildings that the air flows around.
    [[nodiscard]] Obstacles& obstacles();
    [[nodiscard]] const Obstacles& obstacles() const;
    /// What the air did to an obstacle in the last step or tick; rejects a stale handle. 0 before the first step, while the air
    /// sleeps, and for an obstacle outside of the box (ObstacleForce::in_box).
    [[nodiscard]] Result<ObstacleForce> force_on(ObstacleId id) const;
    /// Changes the mean wind [m/s]. All air of the box changes by the difference at once, as under a pressure gradient that is
    /// far wider than the box; entering through the boundaries alone, a new wind would never reach still air. Ramp it for a gust.
    /// Components along axes that a wall closes are dropped. Rejects what is not finite or above 1e4 m/s.
    [[nodiscard]] Result<void> set_ambient(glm::vec3 ambient);
    [[nodiscard]] glm::vec3 ambient() const;
    /// Changes the gusts; the air of the box changes with them at once, so ramp the intensity. Rejects what `validate` rejects.
    /// Allocates when gusts begin.
    [[nodiscard]] Result<void> set_gusts(const Gusts& gusts);
    /// Changes kinds or wall velocities between steps. A changed kind starts the second-order history anew. Rejects what
    /// `validate` rejects and a wall across an axis that follows.
    [[nodiscard]] Result<void> set_boundaries(const Boundaries& boundaries);

    // --- Position of the box ------------------------------------------------------------------------------------------
    /// Centres the box on a point, to whole cells, on the axes that follow. Air that stays inside keeps its values to the bit;
    /// new cells hold the ambient wind. A jump beyond the box starts afresh. Rejects a point that is not finite or beyond 1e12
    /// cells. With `advance` the box moves in its ticks, with `step` at once.
    Result<void> follow(glm::dvec3 point);
    /// Sets the height [m] of the box's low y face, to whole cells: the ground under a player. For boxes with a wall there.
    Result<void> set_floor(double height);
    /// [m] World position of the box's low corner.
    [[nodiscard]] glm::dvec3 origin() const;
    [[nodiscard]] const Box& box() const;

    // --- Reading the air: of this frame with `advance`, of the last step with `step` ----------------------------------------
    /// [m/s] Wind at a world point: trilinear between cell centres, as a vertex stage samples the textures; it fades to ambient
    /// over the blend zone (view.h). A point that is not finite gets the mean wind.
    [[nodiscard]] glm::vec3 velocity(glm::dvec3 position) const { return view().velocity(position); }
    /// The same for many points; `velocities` holds as many.
    void velocity(std::span<const glm::dvec3> positions, std::span<glm::vec3> velocities) const {
        view().velocity(positions, velocities);
    }
    /// The same as four floats each, w = 0: as plants take winds (Blades::loads, Shells::loads).
    void velocity(std::span<const glm::dvec3> positions, std::span<glm::vec4> velocities) const {
        view().velocity(positions, velocities);
    }
    /// [m/s] Wind that acts on a plant there: scaled, limited, with small-scale detail.
    [[nodiscard]] glm::vec3 felt(glm::dvec3 position, const Sampling& sampling) const { return view().felt(position, sampling); }
    /// The same for many points, as `velocity` takes them.
    void felt(std::span<const glm::dvec3> positions, const Sampling& sampling, std::span<glm::vec3> velocities) const {
        view().felt(positions, sampling, velocities);
    }
    void felt(std::span<const glm::dvec3> positions, const Sampling& sampling, std::span<glm::vec4> velocities) const {
        view().felt(positions, sampling, velocities);
    }
    /// One texture of four components, as float or half: x, y, z of the velocity and 0. The span holds four numbers for each of
    /// box().cell_count() texels, or the call is rejected.
    Result<void> write_vectors(std::span<float> texels) const { return view().write_vectors(texels); }
    Result<void> write_vectors(std::span<std::uint16_t> texels) const { return view().write_vectors(texels); }
    /// Three textures, one an axis, as float or half; each span holds box().cell_count() texels or the call is rejected.
    Result<void> write_axes(std::span<float> x, std::span<float> y, std::span<float> z) const {
        return view().write_axes(x, y, z);
    }
    Result<void> write_axes(std::span<std::uint16_t> x, std::span<std::uint16_t> y, std::span<std::uint16_t> z) const {
        return view().write_axes(x, y, z);
    }
    /// 1 for each cell whose centre is inside an obstacle, else 0, as of the last step; box().cell_count() values or the call is
    /// rejected. A plate has no inside. Where set_floor has moved a box with rows of its own, 0 until the next step.
    Result<void> write_obstacles(std::span<float> cells) const;
    /// [m^2/s^2] Pressure over the air's density (1.2 kg/m^3) at the end of the last step, relative to that outside of the box, or
    /// to its mean where no boundary is open; box().cell_count() values or the call is rejected. 0 in still air, before the first
    /// step and with Scheme::stable_fluids. Without that of volume sources. Solves once, in the scratch of the step: no other call
    /// may read this wind meanwhile. Allocates a field.
    Result<void> write_pressure(std::span<float> cells);
    /// Position of the textures relative to `anchor` [m] (one that is not finite counts as 0), now and in the frame before.
    [[nodiscard]] WindowBlock window_block(glm::dvec3 anchor) const;
    /// The same with the ambient wind: all inputs of shaders/coupling/windrow_wind.glsl beside the textures.
    [[nodiscard]] FrameBlock frame_block(glm::dvec3 anchor, const Sampling& sampling = {}) const;
    /// All of the above of this moment, and of the frame before, for motion vectors. Without `advance` both are the last step: a
    /// host that steps by itself keeps the textures of its last frame.
    [[nodiscard]] WindView view() const;
    [[nodiscard]] WindView previous_view() const;
    /// [m/s] The cells after the last step or tick, laid out as box.h says; w = 0.
    [[nodiscard]] std::span<const glm::vec4> field() const;

    // --- Setting the air ----------------------------------------------------------------------------------------------
    /// Sets every cell from a function of its centre's world position; the second-order history starts anew, and with `advance`
    /// the next frame shows these cells alone, not blended with what was before. Values that are not finite are caught by the
    /// next step.
    void set_velocity(const std::function<glm::vec3(glm::dvec3 centre)>& velocity_at);
    /// The same from an array laid out as box.h says; rejects another size.
    Result<void> set_velocity(std::span<const glm::vec4> field);
    /// Sets all cells and the history to the ambient wind, as after creation.
    void reset();

    // --- Snapshots and logs -------------------------------------------------------------------------------------------
    /// The whole state as bytes: config, air, motors, obstacles, gusts, ticks. Little-endian, with a version and a checksum. Fails
    /// without memory for them.
    [[nodiscard]] Result<std::vector<std::byte>> save() const;
    /// A wind that continues from there with the same bits (on the same SIMD level). Rejects bytes that are truncated, changed,
    /// or of another version.
    [[nodiscard]] static Result<Wind> load(std::span<const std::byte> bytes, ParallelFor parallel_for = {});
    /// Adds every accepted call that changes the wind to `log` from now on; null: no longer. See event_log.h.
    void record_to(EventLog* log);

    [[nodiscard]] const Config& config() const;
    /// Bytes that this object has allocated.
    [[nodiscard]] std::size_t memory_bytes() const;

    Wind(Wind&&) noexcept;
    Wind& operator=(Wind&&) noexcept;
    ~Wind();

    struct State; // wind_state.h
    [[nodiscard]] State& state() { return *state_; }

  private:
    explicit Wind(std::unique_ptr<State> state);
    detail::Owned<State> state_;
};

} // namespace windrow
