// Tables of the structs of wind.h, config.h, ambient.h, motors.h, obstacles.h and drag.h.
#pragma once

#include "c_api/source/convert.h"
#include "c_api/source/handles.h"

namespace windrow::c_api {

// --- Made by ./dev schema from the marks in the headers ---------------------------------------------------------------
// config.h
WINDROW_C_STRUCT(windrow_boundary, Boundary, kind, wall_velocity);
WINDROW_C_STRUCT(windrow_boundaries, Boundaries, x_low, x_high, y_low, y_high, z_low, z_high);
WINDROW_C_STRUCT(windrow_log_profile, LogProfile, roughness_length, reference_height);
WINDROW_C_STRUCT(windrow_gusts, Gusts, intensity, length, seed, tile);
WINDROW_C_STRUCT(windrow_canopy, Canopy, height, drag);
WINDROW_C_STRUCT(windrow_roughness, Roughness, length, longest_mixing, map);
WINDROW_C_STRUCT_BUT(1, windrow_rows, Rows, first, uniform, ratio, top);
WINDROW_C_STRUCT_BUT(4, windrow_config, Config, cells, cell_size, boundaries, centre, floor, ambient, profile, gusts, canopy,
                     roughness, rows, blend_width, viscosity, sleep_speed, jump_speed, scheme, interpolation, max_cfl,
                     max_substeps, pressure_solves, simd, parallel_for);
// ambient.h
WINDROW_C_STRUCT(windrow_sampling, Sampling, strength, limit, detail, detail_length);
WINDROW_C_STRUCT(windrow_ambient_settings, AmbientWind::Settings, mean, profile, gusts, ground);
// wind.h
WINDROW_C_STRUCT(windrow_stage_times, StageTimes, sources, ambient, diffusion, advection, projection, obstacles, report, total);
WINDROW_C_STRUCT(windrow_diagnostics, Diagnostics, stepped, out_of_memory, regridded, max_speed, cfl, substeps, substeps_capped,
                 carried_time, limited_cells, repaired_cells, motors_in_reach, motors_lost, jumps, fast_turns, filling_obstacles,
                 diffusion, pressure_residual, pressure_solves, sealed_sources, sealed_rooms, divergence_rms, energy, asleep,
                 times_ms);
// motors.h
WINDROW_C_STRUCT(windrow_envelope, Envelope, attack, hold, decay, delay);
WINDROW_C_STRUCT(windrow_turbulence, Turbulence, intensity, length, seed);
WINDROW_C_STRUCT(windrow_directional_motor, DirectionalMotor, position, direction, region, law, envelope, turbulence);
WINDROW_C_STRUCT(windrow_wake_motor, WakeMotor, position, radius, law, envelope, turbulence);
WINDROW_C_STRUCT(windrow_jet_motor, JetMotor, position, direction, length, start_radius, end_radius, law, envelope, turbulence);
WINDROW_C_STRUCT(windrow_vortex_motor, VortexMotor, position, axis, radius, half_length, lift, law, envelope);
WINDROW_C_STRUCT(windrow_omni_motor, OmniMotor, position, radius, speed, envelope);
WINDROW_C_STRUCT(windrow_pressure_motor, PressureMotor, position, radius, speed, duration);
// obstacles.h
WINDROW_C_STRUCT(windrow_obstacle, Obstacle, position, orientation, shape, surface);
// drag.h
WINDROW_C_STRUCT(windrow_plant_drag, PlantDrag, position, radius, base, height, area);
WINDROW_C_STRUCT(windrow_belt_drag, BeltDrag, start, end, width, height, resistance);
// --- End of what ./dev schema makes -----------------------------------------------------------------------------------

// Structs without a table of settings, or with other names.
WINDROW_C_STRUCT(windrow_roughness_map, RoughnessMap, lengths, position, scale);
WINDROW_C_STRUCT(windrow_uniform_gust, UniformGust, mean, amplitude, period, direction);
WINDROW_C_STRUCT_BUT(1, windrow_advance, Advance, ticks, dropped, factor);
struct QueryDefaults {
    windrow_number number = WINDROW_NUMBER_DOUBLE;
};
WINDROW_C_STRUCT(windrow_query, QueryDefaults, number);
struct DebugView {
    bool box = true, motors = true, obstacles = true;
    int arrows = 16;
    float seconds = 0.2f;
    double height = 1.0;
};
WINDROW_C_STRUCT(windrow_debug_view, DebugView, box, motors, obstacles, arrows, seconds, height);
WINDROW_C_STRUCT_BUT(1, windrow_box, Box, cells, cell_size, boundaries);
WINDROW_C_STRUCT(windrow_drag_force, DragForce, force, in_box);
WINDROW_C_STRUCT(windrow_obstacle_force, ObstacleForce, force, moment, pressure, in_box);

// What a table does not hold: lists, variants, bits, what is shared (tables.cpp).
void read_rest(Reasons& reasons, const Path& path, const windrow_gust_tile* from, std::shared_ptr<const GustTile>& to);
void read_rest(Reasons& reasons, const Path& path, const windrow_height_map* from, std::shared_ptr<const HeightMap>& to);
void read_rest(Reasons& reasons, const Path& path, const windrow_parallel_for& from, ParallelFor& to);
void read_rest(Reasons& reasons, const Path& path, const windrow_rows& from, Rows& to);
void read_rest(Reasons& reasons, const Path& path, const windrow_config& from, Config& to);
void read_rest(Reasons& reasons, const Path& path, const windrow_region& from, Region& to);
void read_rest(Reasons& reasons, const Path& path, const windrow_law& from, std::variant<Force, Drive>& to);
void read_rest(Reasons& reasons, const Path& path, const windrow_wake_law& from, std::variant<WakeForce, WakeDrive>& to);
void read_rest(Reasons& reasons, const Path& path, const windrow_shape& from, Shape& to);
void write_rest(Writing, const ParallelFor& from, windrow_parallel_for& to);
void write_rest(Writing, const Config& from, windrow_config& to);
void write_rest(Writing, const Rows& from, windrow_rows& to);
void write_rest(Writing, const Box& from, windrow_box& to);
void write_rest(Writing, const Region& from, windrow_region& to);
void write_rest(Writing, const std::variant<Force, Drive>& from, windrow_law& to);
void write_rest(Writing, const std::variant<WakeForce, WakeDrive>& from, windrow_wake_law& to);
void write_rest(Writing, const Shape& from, windrow_shape& to);

/// Without settings of the host's, the defaults.
template <class Use>
[[nodiscard]] windrow_result with_sampling(const windrow_sampling* sampling, const Use& use) {
    if (sampling == nullptr)
        return done(use(Sampling{}));
    return with(sampling, use);
}
/// A block for shaders, whose layout both languages share.
template <class Block, class CBlock>
void copy_block(const Block& from, CBlock* to) {
    static_assert(sizeof(Block) == sizeof(CBlock));
    std::memcpy(static_cast<void*>(to), &from, sizeof from);
}

} // namespace windrow::c_api
