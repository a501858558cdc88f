// Tables of the structs of plants.h and motion.h.
#pragma once

#include "c_api/source/tables.h"
#include "coupling/blade.h"
#include "coupling/cascade.h"
#include "coupling/ground_memory.h"
#include "coupling/shell.h"
#include "coupling/spring.h"
#include "coupling/tree.h"

namespace windrow::c_api {

// --- Made by ./dev schema from the marks in the headers ---------------------------------------------------------------
// plants.h
WINDROW_C_STRUCT(windrow_drag, Drag, length, width, rigidity, drag_coefficient, air_density, vogel_exponent, vogel_speed,
                 max_bend);
WINDROW_C_STRUCT(windrow_blade_settings, BladeSettings, stalk, length_spread, width, tip_width, taper, along_wind,
                 stiffness_spread, rest_bend, rest_bend_spread, rest_curve, view_bend, twist);
WINDROW_C_STRUCT(windrow_shell_settings, ShellSettings, shells, reaches_tip, length, spacing, bias, push, push_exponent, droop,
                 droop_shape, sag, down, strand);
WINDROW_C_STRUCT(windrow_tree_classes, TreeClasses, trunk, branch, leaf);
WINDROW_C_STRUCT(windrow_tree_part, TreePart, root, axis, length, stiffness);
// motion.h
WINDROW_C_STRUCT(windrow_spring_class, SpringClass, frequency_hz, damping);
WINDROW_C_STRUCT(windrow_flutter_class, FlutterClass, frequency_hz, most, onset);
WINDROW_C_STRUCT(windrow_cascade_config, CascadeConfig, stages, lag);
WINDROW_C_STRUCT(windrow_ground_config, GroundConfig, texels, texel_size, spring, push, trail_fraction, trail_time, trample_time,
                 clearance, blend_width, jump_speed, max_walkers);
// --- End of what ./dev schema makes -----------------------------------------------------------------------------------

// Structs without a table of settings.
WINDROW_C_STRUCT(windrow_plant_vertex, PlantVertex, position, normal, tangent);
WINDROW_C_STRUCT(windrow_spring_step, SpringStep, place_place, place_velocity, place_target, velocity_place, velocity_velocity,
                 velocity_target);
WINDROW_C_STRUCT(windrow_pose, Pose, position, rotation, scale);
WINDROW_C_STRUCT(windrow_ground_walker, GroundWalker, position, previous, foot_height, previous_foot_height, radius, weight);
WINDROW_C_STRUCT_BUT(1, windrow_ground_step, GroundStep, duration, wind_lean);
WINDROW_C_STRUCT(windrow_ground_sample, GroundSample, lean, trample, trail);

/// An array of C as the same of C++.
template <class To, class From>
[[nodiscard]] std::span<To> span_of(From* from, std::uint64_t count) {
    return {same_layout<To>(from), from != nullptr ? static_cast<std::size_t>(count) : 0};
}
/// A struct without a version, none of whose fields can be of a wrong kind.
template <class C>
[[nodiscard]] typename Fields<C>::Cpp plain(const C& from) {
    Reasons none;
    typename Fields<C>::Cpp to{};
    read_fields(none, Path{nullptr, ""}, from, to);
    return to;
}
template <class C>
[[nodiscard]] C plain_c(const typename Fields<C>::Cpp& from) {
    C to{};
    write_fields(from, to);
    return to;
}
/// Runs use(step) on a step with its walkers.
template <class Use>
[[nodiscard]] windrow_result with_ground_step(const windrow_ground_step* from, const Use& use) {
    Reasons reasons;
    windrow_ground_step taken;
    if (!take(reasons, Path{nullptr, "step"}, from, taken))
        return fail(WINDROW_REJECTED, reasons.take());
    if (taken.walkers == nullptr && taken.walker_count > 0)
        return fail(WINDROW_REJECTED, detail::message("step.walkers is null: give ", taken.walker_count, " walkers."));
    GroundStep step;
    read_fields(reasons, Path{nullptr, "step"}, taken, step);
    step.walkers = span_of<const GroundWalker>(taken.walkers, taken.walker_count);
    return done(use(step));
}

} // namespace windrow::c_api
