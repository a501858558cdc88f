// Made by ./dev schema from the headers and tools/c_kinds.py. Do not edit.
// clang-format off
// Each struct on its way in or out, field by field.
namespace windrow::c_api {

void turn(Keep& keep, Way way, windrow_sampling& value);
void turn(Keep& keep, Way way, windrow_ambient_settings& value);
void turn(Keep& keep, Way way, windrow_uniform_gust& value);
void turn(Keep& keep, Way way, windrow_boundary& value);
void turn(Keep& keep, Way way, windrow_boundaries& value);
void turn(Keep& keep, Way way, windrow_log_profile& value);
void turn(Keep& keep, Way way, windrow_gusts& value);
void turn(Keep& keep, Way way, windrow_canopy& value);
void turn(Keep& keep, Way way, windrow_roughness_map& value);
void turn(Keep& keep, Way way, windrow_roughness& value);
void turn(Keep& keep, Way way, windrow_rows& value);
void turn(Keep& keep, Way way, windrow_config& value);
void turn(Keep& keep, Way way, windrow_plant_drag& value);
void turn(Keep& keep, Way way, windrow_belt_drag& value);
void turn(Keep& keep, Way way, windrow_drag_force& value);
void turn(Keep& keep, Way way, windrow_flutter_class& value);
void turn(Keep& keep, Way way, windrow_pose& value);
void turn(Keep& keep, Way way, windrow_ground_config& value);
void turn(Keep& keep, Way way, windrow_ground_walker& value);
void turn(Keep& keep, Way way, windrow_ground_step& value);
void turn(Keep& keep, Way way, windrow_ground_sample& value);
void turn(Keep& keep, Way way, windrow_region& value);
void turn(Keep& keep, Way way, windrow_law& value);
void turn(Keep& keep, Way way, windrow_wake_law& value);
void turn(Keep& keep, Way way, windrow_turbulence& value);
void turn(Keep& keep, Way way, windrow_directional_motor& value);
void turn(Keep& keep, Way way, windrow_wake_motor& value);
void turn(Keep& keep, Way way, windrow_jet_motor& value);
void turn(Keep& keep, Way way, windrow_vortex_motor& value);
void turn(Keep& keep, Way way, windrow_omni_motor& value);
void turn(Keep& keep, Way way, windrow_pressure_motor& value);
void turn(Keep& keep, Way way, windrow_shape& value);
void turn(Keep& keep, Way way, windrow_obstacle& value);
void turn(Keep& keep, Way way, windrow_obstacle_force& value);
void turn(Keep& keep, Way way, windrow_drag& value);
void turn(Keep& keep, Way way, windrow_plant_vertex& value);
void turn(Keep& keep, Way way, windrow_blade_settings& value);
void turn(Keep& keep, Way way, windrow_shell_settings& value);
void turn(Keep& keep, Way way, windrow_skin& value);
void turn(Keep& keep, Way way, windrow_tree_classes& value);
void turn(Keep& keep, Way way, windrow_tree_part& value);
void turn(Keep& keep, Way way, windrow_vdb_film& value);
void turn(Keep& keep, Way way, windrow_vulkan_settings& value);
void turn(Keep& keep, Way way, windrow_vulkan_frame& value);
void turn(Keep& keep, Way way, windrow_diagnostics& value);
void turn(Keep& keep, Way way, windrow_box& value);
void turn(Keep& keep, Way way, windrow_query& value);
void turn(Keep& keep, Way way, windrow_debug_line& value);
void turn(Keep& keep, Way way, windrow_debug_view& value);

inline void turn([[maybe_unused]] Keep& keep, Way way, windrow_sampling& value) {
    Number<1>::turn(way, value.limit);
    Number<1>::turn(way, value.detail_length);
}
inline void turn([[maybe_unused]] Keep& keep, Way way, windrow_ambient_settings& value) {
    Vector<1>::turn(way, value.mean);
    turn_behind<Whole>(keep, way, value.profile, 1);
    turn_behind<Whole>(keep, way, value.gusts, 1);
    Number<1>::turn(way, value.ground);
}
inline void turn([[maybe_unused]] Keep& keep, Way way, windrow_uniform_gust& value) {
    Number<1>::turn(way, value.mean);
    Number<1>::turn(way, value.amplitude);
    Vector<0>::turn(way, value.direction);
}
inline void turn([[maybe_unused]] Keep& keep, Way way, windrow_boundary& value) {
    Vector<1>::turn(way, value.wall_velocity);
}
inline void turn([[maybe_unused]] Keep& keep, Way way, windrow_log_profile& value) {
    Number<1>::turn(way, value.roughness_length);
    Number<1>::turn(way, value.reference_height);
}
inline void turn([[maybe_unused]] Keep& keep, Way way, windrow_gusts& value) {
    Number<1>::turn(way, value.length);
}
inline void turn([[maybe_unused]] Keep& keep, Way way, windrow_canopy& value) {
    Number<1>::turn(way, value.height);
    Number<-1>::turn(way, value.drag);
}
inline void turn([[maybe_unused]] Keep& keep, Way way, windrow_roughness_map& value) {
    Extents<0>::turn(way, value.scale);
    turn_by_hand(keep, way, value);
}
inline void turn([[maybe_unused]] Keep& keep, Way way, windrow_roughness& value) {
    Number<1>::turn(way, value.length);
    Number<1>::turn(way, value.longest_mixing);
    turn_behind<Whole>(keep, way, value.map, 1);
}
inline void turn([[maybe_unused]] Keep& keep, Way way, windrow_rows& value) {
    Number<1>::turn(way, value.first);
    Number<1>::turn(way, value.top);
    turn_behind<Number<1>>(keep, way, value.heights, value.height_count <= 2048 ? value.height_count : 0);
}
inline void turn([[maybe_unused]] Keep& keep, Way way, windrow_config& value) {
    Extents<0>::turn(way, value.cells);
    Number<1>::turn(way, value.cell_size);
    turn(keep, way, value.boundaries);
    Vector<1>::turn(way, value.centre);
    Vector<1>::turn(way, value.ambient);
    turn_behind<Whole>(keep, way, value.profile, 1);
    turn_behind<Whole>(keep, way, value.gusts, 1);
    turn_behind<Whole>(keep, way, value.canopy, 1);
    turn_behind<Whole>(keep, way, value.roughness, 1);
    turn_behind<Whole>(keep, way, value.rows, 1);
    Number<2>::turn(way, value.viscosity);
    Number<1>::turn(way, value.sleep_speed);
    Number<1>::turn(way, value.floor);
    Number<1>::turn(way, value.jump_speed);
    turn_by_hand(keep, way, value);
}
inline void turn([[maybe_unused]] Keep& keep, Way way, windrow_plant_drag& value) {
    Number<1>::turn(way, value.radius);
    Vector<1>::turn(way, value.position);
    Number<1>::turn(way, value.base);
    Number<1>::turn(way, value.height);
    Number<2>::turn(way, value.area);
}
inline void turn([[maybe_unused]] Keep& keep, Way way, windrow_belt_drag& value) {
    Number<1>::turn(way, value.width);
    Vector<1>::turn(way, value.start);
    Vector<1>::turn(way, value.end);
    Number<1>::turn(way, value.height);
}
inline void turn([[maybe_unused]] Keep& keep, Way way, windrow_drag_force& value) {
    Vector<1>::turn(way, value.force);
}
inline void turn([[maybe_unused]] Keep& keep, Way way, windrow_flutter_class& value) {
    Number<1>::turn(way, value.onset);
}
inline void turn([[maybe_unused]] Keep& keep, Way way, windrow_pose& value) {
    Vector<1>::turn(way, value.position);
    Turn::turn(way, value.rotation);
}
inline void turn([[maybe_unused]] Keep& keep, Way way, windrow_ground_config& value) {
    Number<1>::turn(way, value.texel_size);
    Number<1>::turn(way, value.clearance);
    Number<1>::turn(way, value.blend_width);
    Number<1>::turn(way, value.jump_speed);
}
inline void turn([[maybe_unused]] Keep& keep, Way way, windrow_ground_walker& value) {
    Vector<1>::turn(way, value.position);
    Vector<1>::turn(way, value.previous);
    Number<1>::turn(way, value.foot_height);
    Number<1>::turn(way, value.previous_foot_height);
    Number<1>::turn(way, value.radius);
}
inline void turn([[maybe_unused]] Keep& keep, Way way, windrow_ground_step& value) {
    Level<0>::turn(way, value.wind_lean);
    turn_behind<Whole>(keep, way, value.walkers, value.walker_count);
}
inline void turn([[maybe_unused]] Keep& keep, Way way, windrow_ground_sample& value) {
    Level<0>::turn(way, value.lean);
}
inline void turn([[maybe_unused]] Keep& keep, Way way, windrow_region& value) {
    Number<1>::turn(way, value.radius);
    Vector<1>::turn(way, value.half_axis);
    Extents<1>::turn(way, value.half_size);
    Vector<1>::turn(way, value.axis);
    Number<1>::turn(way, value.start_radius);
    Number<1>::turn(way, value.end_radius);
}
inline void turn([[maybe_unused]] Keep& keep, Way way, windrow_law& value) {
    Number<1>::turn(way, value.acceleration);
    Number<1>::turn(way, value.speed);
}
inline void turn([[maybe_unused]] Keep& keep, Way way, windrow_wake_law& value) {
    Number<-1>::turn(way, value.per_metre);
}
inline void turn([[maybe_unused]] Keep& keep, Way way, windrow_turbulence& value) {
    Number<1>::turn(way, value.length);
}
inline void turn([[maybe_unused]] Keep& keep, Way way, windrow_directional_motor& value) {
    Vector<0>::turn(way, value.direction);
    Vector<1>::turn(way, value.position);
    turn(keep, way, value.region);
    turn(keep, way, value.law);
    turn(keep, way, value.turbulence);
}
inline void turn([[maybe_unused]] Keep& keep, Way way, windrow_wake_motor& value) {
    Number<1>::turn(way, value.radius);
    Vector<1>::turn(way, value.position);
    turn(keep, way, value.law);
    turn(keep, way, value.turbulence);
}
inline void turn([[maybe_unused]] Keep& keep, Way way, windrow_jet_motor& value) {
    Vector<0>::turn(way, value.direction);
    Vector<1>::turn(way, value.position);
    Number<1>::turn(way, value.length);
    Number<1>::turn(way, value.start_radius);
    Number<1>::turn(way, value.end_radius);
    turn(keep, way, value.law);
    turn(keep, way, value.turbulence);
}
inline void turn([[maybe_unused]] Keep& keep, Way way, windrow_vortex_motor& value) {
    Axial<0>::turn(way, value.axis);
    Vector<1>::turn(way, value.position);
    Number<1>::turn(way, value.radius);
    Number<1>::turn(way, value.half_length);
    Handed::turn(way, value.lift);
    turn(keep, way, value.law);
}
inline void turn([[maybe_unused]] Keep& keep, Way way, windrow_omni_motor& value) {
    Number<1>::turn(way, value.radius);
    Vector<1>::turn(way, value.position);
    Number<1>::turn(way, value.speed);
}
inline void turn([[maybe_unused]] Keep& keep, Way way, windrow_pressure_motor& value) {
    Number<1>::turn(way, value.radius);
    Vector<1>::turn(way, value.position);
    Number<1>::turn(way, value.speed);
}
inline void turn([[maybe_unused]] Keep& keep, Way way, windrow_shape& value) {
    Number<1>::turn(way, value.radius);
    Number<1>::turn(way, value.half_length);
    Number<1>::turn(way, value.cell_size);
    Extents<1>::turn(way, value.half_size);
    Vector<1>::turn(way, value.half_axis);
    Extents<0>::turn(way, value.scale);
}
inline void turn([[maybe_unused]] Keep& keep, Way way, windrow_obstacle& value) {
    Vector<1>::turn(way, value.position);
    Turn::turn(way, value.orientation);
    turn(keep, way, value.shape);
}
inline void turn([[maybe_unused]] Keep& keep, Way way, windrow_obstacle_force& value) {
    Vector<1>::turn(way, value.force);
    Axial<2>::turn(way, value.moment);
    Number<-1>::turn(way, value.pressure);
}
inline void turn([[maybe_unused]] Keep& keep, Way way, windrow_drag& value) {
    Number<1>::turn(way, value.length);
    Number<1>::turn(way, value.width);
    Number<3>::turn(way, value.rigidity);
    Number<-3>::turn(way, value.air_density);
    Number<1>::turn(way, value.vogel_speed);
}
inline void turn([[maybe_unused]] Keep& keep, Way way, windrow_plant_vertex& value) {
    Vector<1>::turn(way, value.position);
    Vector<0>::turn(way, value.normal);
    Vector<0>::turn(way, value.tangent);
}
inline void turn([[maybe_unused]] Keep& keep, Way way, windrow_blade_settings& value) {
    turn_behind<Whole>(keep, way, value.stalk, 1);
    Number<1>::turn(way, value.width);
}
inline void turn([[maybe_unused]] Keep& keep, Way way, windrow_shell_settings& value) {
    Number<1>::turn(way, value.length);
    Number<1>::turn(way, value.push);
    Number<1>::turn(way, value.droop);
    Vector<0>::turn(way, value.down);
    turn_behind<Whole>(keep, way, value.strand, 1);
}
inline void turn([[maybe_unused]] Keep& keep, Way way, windrow_skin& value) {
    turn_behind<Vector<1>>(keep, way, value.positions, value.count);
    turn_behind<Vector<0>>(keep, way, value.normals, value.count);
}
inline void turn([[maybe_unused]] Keep& keep, Way way, windrow_tree_classes& value) {
    turn_behind<Whole>(keep, way, value.trunk, 1);
    turn_behind<Whole>(keep, way, value.branch, 1);
    turn_behind<Whole>(keep, way, value.leaf, 1);
}
inline void turn([[maybe_unused]] Keep& keep, Way way, windrow_tree_part& value) {
    Vector<1>::turn(way, value.root);
    Vector<0>::turn(way, value.axis);
    Number<1>::turn(way, value.length);
}
inline void turn([[maybe_unused]] Keep& keep, Way way, windrow_vdb_film& value) {
    Number<1>::turn(way, value.margin);
    Number<1>::turn(way, value.voxel_size);
    turn_by_hand(keep, way, value);
}
inline void turn([[maybe_unused]] Keep& keep, Way way, windrow_vulkan_settings& value) {
    Extents<0>::turn(way, value.read_cells);
}
inline void turn([[maybe_unused]] Keep& keep, Way way, windrow_vulkan_frame& value) {
    turn_behind<Vector<1>>(keep, way, value.around, 1);
    turn_behind<Vector<1>>(keep, way, value.points, value.point_count);
}
inline void turn([[maybe_unused]] Keep& keep, Way way, windrow_diagnostics& value) {
    Number<1>::turn(way, value.max_speed);
    Number<5>::turn(way, value.energy);
}
inline void turn([[maybe_unused]] Keep& keep, Way way, windrow_query& value) {
    turn_by_hand(keep, way, value);
}
inline void turn([[maybe_unused]] Keep& keep, Way way, windrow_debug_line& value) {
    Vector<1>::turn(way, value.begin);
    Vector<1>::turn(way, value.end);
    Number<1>::turn(way, value.speed);
}
inline void turn([[maybe_unused]] Keep& keep, Way way, windrow_debug_view& value) {
    Number<1>::turn(way, value.height);
}

} // namespace windrow::c_api
