// Settings of a wind: the box, the wind around it, the method, and time. Each has its default, range and meaning in the table of
// its struct, from which validation, scene files, the C interface and docs/scene_keys.md follow.
#pragma once

#include "ambient.h"
#include "api.h"
#include "box.h"
#include "canopy.h"
#include "operators.h"
#include "parallel.h"
#include "result.h"
#include "roughness.h"
#include "setting.h"
#include "simd.h"

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <tuple>

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
    /// Default true. Motors and the canopy.
    bool sources = true;
    /// Default true. The return to the ambient wind.
    bool relaxation = true;
    /// Default true. Viscosity, and the mixing over rough ground.
    bool diffusion = true;
    /// Default true. Transport of the velocity by itself.
    bool advection = true;
    /// Default true. The pressure, which makes the air incompressible.
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
    /// 1 to 10000, default 30. Ticks a second. At 30, blended between ticks, leaves move as smoothly as at 144, at a fifth of the
    /// cost.
    double hz = 30.0;
    /// 1 to 1000, default 4. Maximal number of ticks in one call. Time beyond them is dropped and reported: a slow machine gets a
    /// slower wind, not an ever longer frame.
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

/// Settings of a wind, copied when it is created.
struct Config {
    /// [cells] Each component 1 to 2048, default (32, 16, 32). Cells along x, y, z; at most 67,108,864 in all. Odd sizes too. The
    /// default is 32 m around a player at 1 m, half as high.
    glm::ivec3 cells{32, 16, 32};
    /// [m] 1e-6 to 1e6, default 1. Edge of a cell; with rows of their own, along x and z. At 1 m a gust that a person notices
    /// spans several.
    float cell_size = 1.0f;
    /// Boundary conditions of the six faces. Default: open everywhere; Boundaries::open_over_floor() adds ground. Periodic
    /// boundaries come in pairs.
    Boundaries boundaries{};
    /// [m] Each component -1e12 to 1e12, default (0, 0, 0). Point that the box is centred on at the start, to whole cells; for
    /// good on axes that do not follow. Its height does not count over a wall at boundaries.y_low: the box stands on floor.
    glm::dvec3 centre{0.0};
    /// [m] -1e12 to 1e12, default 0. Height of the ground, where boundaries.y_low is a wall: the box's low side, to whole cells.
    /// Default 0. set_floor changes it.
    double floor = 0.0;
    /// Axes x, y, z along which the box follows. Default: those with two open boundaries; others cannot.
    std::optional<glm::bvec3> follow_axes{};
    /// [m/s] Each component -10000 to 10000, default (0, 0, 0). Mean wind: of the air at the start, of the inflow through open
    /// boundaries, of new cells. Its component along an axis that a wall closes is dropped.
    glm::vec3 ambient{0.0f};
    /// Wind over open ground: log((z + z0) / z0), 0 at the ground (the box's floor, or height 0 without one), the ambient wind at
    /// the reference height, more above. Default none: the same wind at all heights; {} for the profile with its own defaults.
    std::optional<LogProfile> profile{};
    /// A frozen pattern that the ambient wind carries along, outside the box and through it. Calm air has none. The pattern is
    /// not periodic in the box: it jumps at periodic boundaries.
    Gusts gusts{};
    /// Drag of plants of uniform height and density on the floor, or at height 0 without one. The inflow, and the wind to which
    /// the air relaxes, is still the ambient wind. Default none, which costs nothing: plants then bend in the wind and do not
    /// slow it; {} for wheat.
    std::optional<Canopy> canopy{};
    /// Rough ground: its drag, and the mixing of the air above it by turbulence. Default none, which costs nothing: the ground is
    /// smooth, and a profile is worn away by what the air does; {} for short grass.
    std::optional<Roughness> roughness{};
    /// Rows of cells of unequal thickness, thin near the ground and thick aloft; {} for rows of half a metre that grow by a tenth
    /// from the fifth on. Default none, which costs nothing: all rows are cell_size thick. At most 128 rows. Such a box keeps its
    /// height, which set_floor changes by whole lowest rows, and the air is then interpolated; it cannot repeat along y.
    std::optional<Rows> rows{};
    /// [cells] 0 (none) to 64, default 2. Width over which sampled wind fades to ambient at the boundaries along which the box
    /// follows. It ends one cell before the box does (two with ticks), so that a shift of the box moves nothing. Axes of fewer
    /// than 8 cells (10 with ticks) have none.
    float blend_width = 2.0f;
    /// [m^2/s] 0 to 1e9, default 1.5e-5. Kinematic viscosity. Default: that of air, which at 1 m cells is below what the solver
    /// resolves and costs nothing.
    float viscosity = 1.5e-5f;
    /// [s] 0 (never) to 1e9. Time constant of the relaxation to the ambient wind. Default 20; 200 while wind meets obstacles,
    /// whose lees 20 would fill. A collocated solver has no other damping of the checkerboard mode in still air. 0 is for
    /// analytic cases.
    std::optional<float> relaxation_time{};
    /// [m/s] 0 (never) to 10000, default 0.001. Air that differs from ambient by less everywhere, with no motor in reach and no
    /// gusts, sleeps: it becomes ambient, and a step costs microseconds until something acts. It does not sleep without a
    /// relaxation time or while viscosity acts.
    float sleep_speed = 1e-3f;
    /// [m/s] 0 (never) to 1e9, default 100. An obstacle or a wake that is moved faster has jumped: it is at its new place at
    /// once, at rest, and pushes no air on the way (Diagnostics::jumps). Default 100: above what moves in a game's air, below a
    /// respawn over two metres.
    float jump_speed = 100.0f;
    /// Default second_order. Time scheme. second_order: semi-implicit semi-Lagrangian. stable_fluids: the classic split, first
    /// order.
    Scheme scheme = Scheme::second_order;
    /// Default cubic. Interpolation of the advection. linear: never overshoots, smooths. cubic: third order. cubic_32: reads 32
    /// of its 64 cells, 1.00 to 1.05 of its error, less time without AVX-512.
    Interpolation interpolation = Interpolation::cubic;
    /// A number above 0, at most 1e6, default 2. Cells that the air may cross in one sub-step. Above 2 the backtrace may miss
    /// thin motors; large values are for tests of the raw step.
    float max_cfl = 2.0f;
    /// 1 to 64, default 8. Maximal number of sub-steps in a step. Beyond max_cfl * max_substeps cells a step, speeds are limited
    /// (and counted). While obstacles move, the number follows from speeds of four steps ago and from what acts since.
    int max_substeps = 8;
    /// 0 (two, eight in the first step of a flow) to 64, default 0. Direct solves of the pressure around obstacles in a sub-step.
    /// Each further solve costs about a fifth of a step; without obstacles in the box there is one.
    int pressure_solves = 0;
    /// Stages that run.
    Stages stages{};
    /// Fixed ticks of `advance`.
    Ticks ticks{};
    /// Default best. Instructions of the hot loops. Default: the best that this machine runs. Each level gives one result,
    /// baseline the same on all machines.
    Simd simd = Simd::best;
    /// Threads of the host. Default: a serial loop; results do not depend on it.
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
            Setting(
                "centre", &Config::centre, k_world_range,
                "Point that the box is centred on at the start, to whole cells; for good on axes that do not follow. Its height "
                "does not count over a wall at boundaries.y_low: the box stands on floor."),
            Setting("floor", &Config::floor, k_world_range,
                    "Height of the ground, where boundaries.y_low is a wall: the box's low side, to whole cells. Default 0. "
                    "set_floor changes it."),
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
            Setting(
                "relaxation_time", &Config::relaxation_time, {0.0, 1e9, "s", "never"},
                "Time constant of the relaxation to the ambient wind. Default 20; 200 while wind meets obstacles, whose lees 20 "
                "would fill. A collocated solver has no other damping of the checkerboard mode in still air. 0 is for analytic "
                "cases."),
            Setting("sleep_speed", &Config::sleep_speed, {0.0, 1e4, "m/s", "never"},
                    "Air that differs from ambient by less everywhere, with no motor in reach and no gusts, sleeps: it becomes "
                    "ambient, and a step costs microseconds until something acts. It does not sleep without a relaxation time or "
                    "while "
                    "viscosity acts."),
            Setting(
                "jump_speed", &Config::jump_speed, {0.0, 1e9, "m/s", "never"},
                "An obstacle or a wake that is moved faster has jumped: it is at its new place at once, at rest, and pushes no "
                "air on the way (Diagnostics::jumps). Default 100: above what moves in a game's air, below a respawn over two "
                "metres."),
            Setting("scheme", &Config::scheme,
                    "Time scheme. second_order: semi-implicit semi-Lagrangian. stable_fluids: the classic split, first "
                    "order."),
            Setting(
                "interpolation", &Config::interpolation,
                "Interpolation of the advection. linear: never overshoots, smooths. cubic: third order. cubic_32: reads 32 of "
                "its 64 cells, 1.00 to 1.05 of its error, less time without AVX-512."),
            Setting("max_cfl", &Config::max_cfl, Range::above(0.0, 1e6),
                    "Cells that the air may cross in one sub-step. Above 2 the backtrace may miss thin motors; large values are "
                    "for tests "
                    "of the raw step."),
            Setting("max_substeps", &Config::max_substeps, {1.0, 64.0},
                    "Maximal number of sub-steps in a step. Beyond max_cfl * max_substeps cells a step, speeds are limited (and "
                    "counted). While obstacles move, the number follows from speeds of four steps ago and from what acts since."),
            Setting(
                "pressure_solves", &Config::pressure_solves,
                {.min = 0.0, .max = 64.0, .zero = "two, eight in the first step of a flow"},
                "Direct solves of the pressure around obstacles in a sub-step. Each further solve costs about a fifth of a step; "
                "without obstacles in the box there is one."),
            Setting("stages", &Config::stages, "Stages that run.", k_in_snapshots),
            Setting("ticks", &Config::ticks, "Fixed ticks of `advance`.", k_in_snapshots),
            Setting(
                "simd", &Config::simd,
                "Instructions of the hot loops. Default: the best that this machine runs. Each level gives one result, baseline "
                "the same on all machines.",
                k_in_snapshots),
            Setting("parallel_for", &Config::parallel_for,
                    "Threads of the host. Default: a serial loop; results do not depend on it.", k_not_stored),
        };
    }
};

/// All reasons why a config is invalid, one per line.
[[nodiscard]] WINDROW_API Result<void> validate(const Config& config);
WINDROW_API void check_rules(detail::Reasons& reasons, const detail::FieldPath& path, const Config& config);

} // namespace windrow
