// Made by ./dev schema from the headers and tools/c_kinds.py. Do not edit.
// clang-format off
// Each call that converts: what goes in, the call itself, what comes out.

WINDROW_EXPORT windrow_result windrow_sampling_init(windrow_sampling* sampling, uint32_t struct_size) {
    return turned<Same>(own_windrow_sampling_init, out_array<Whole>(sampling, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_sampling_validate(const windrow_sampling* sampling) {
    return turned<Same>(own_windrow_sampling_validate, in_array<Whole>(sampling, 1));
}
WINDROW_EXPORT windrow_result windrow_ambient_settings_init(windrow_ambient_settings* settings, uint32_t struct_size) {
    return turned<Same>(own_windrow_ambient_settings_init, out_array<Whole>(settings, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_ambient_wind_create(const windrow_ambient_settings* settings, windrow_ambient_wind**
    ambient) {
    return turned<Same>(own_windrow_ambient_wind_create, in_array<Whole>(settings, 1), same(ambient));
}
WINDROW_EXPORT windrow_result windrow_ambient_wind_set_mean(windrow_ambient_wind* ambient, windrow_vec3 mean) {
    return turned<Same>(own_windrow_ambient_wind_set_mean, same(ambient), in<Vector<1>>(mean));
}
WINDROW_EXPORT windrow_result windrow_ambient_wind_set_ground(windrow_ambient_wind* ambient, double height) {
    return turned<Same>(own_windrow_ambient_wind_set_ground, same(ambient), in<Number<1>>(height));
}
WINDROW_EXPORT windrow_result windrow_ambient_wind_set_phase(windrow_ambient_wind* ambient, windrow_dvec3 phase) {
    return turned<Same>(own_windrow_ambient_wind_set_phase, same(ambient), in<Vector<1>>(phase));
}
WINDROW_EXPORT windrow_dvec3 windrow_ambient_wind_phase(const windrow_ambient_wind* ambient) {
    return turned<Vector<1>>(own_windrow_ambient_wind_phase, same(ambient));
}
WINDROW_EXPORT double windrow_ambient_wind_period(const windrow_ambient_wind* ambient) {
    return turned<Number<1>>(own_windrow_ambient_wind_period, same(ambient));
}
WINDROW_EXPORT windrow_vec3 windrow_ambient_wind_mean(const windrow_ambient_wind* ambient) {
    return turned<Vector<1>>(own_windrow_ambient_wind_mean, same(ambient));
}
WINDROW_EXPORT double windrow_ambient_wind_ground(const windrow_ambient_wind* ambient) {
    return turned<Number<1>>(own_windrow_ambient_wind_ground, same(ambient));
}
WINDROW_EXPORT float windrow_ambient_wind_profile_at(const windrow_ambient_wind* ambient, double height) {
    return turned<Same>(own_windrow_ambient_wind_profile_at, same(ambient), in<Number<1>>(height));
}
WINDROW_EXPORT windrow_result windrow_ambient_wind_velocity(const windrow_ambient_wind* ambient, windrow_dvec3 position,
    windrow_vec3* velocity) {
    return turned<Same>(own_windrow_ambient_wind_velocity, same(ambient), in<Vector<1>>(position), out_array<Vector<1>>(velocity,
        1));
}
WINDROW_EXPORT windrow_result windrow_ambient_wind_felt(const windrow_ambient_wind* ambient, windrow_dvec3 position, const
    windrow_sampling* sampling, windrow_vec3* velocity) {
    return turned<Same>(own_windrow_ambient_wind_felt, same(ambient), in<Vector<1>>(position), in_array<Whole>(sampling, 1),
        both<Vector<1>>(velocity, 1));
}
WINDROW_EXPORT windrow_result windrow_ambient_wind_block(const windrow_ambient_wind* ambient, windrow_dvec3 anchor, const
    windrow_sampling* sampling, windrow_ambient_block* block) {
    return turned<Same>(own_windrow_ambient_wind_block, same(ambient), in<Vector<1>>(anchor), in_array<Whole>(sampling, 1),
        same(block));
}
WINDROW_EXPORT windrow_result windrow_uniform_gust_init(windrow_uniform_gust* gust, uint32_t struct_size) {
    return turned<Same>(own_windrow_uniform_gust_init, out_array<Whole>(gust, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_uniform_gust_velocity(const windrow_uniform_gust* gust, double time, windrow_vec3* velocity)
    {
    return turned<Same>(own_windrow_uniform_gust_velocity, in_array<Whole>(gust, 1), same(time), out_array<Vector<1>>(velocity,
        1));
}
WINDROW_EXPORT windrow_boundaries windrow_boundaries_open_over_floor(void) {
    return turned<Whole>(own_windrow_boundaries_open_over_floor);
}
WINDROW_EXPORT windrow_result windrow_log_profile_init(windrow_log_profile* profile, uint32_t struct_size) {
    return turned<Same>(own_windrow_log_profile_init, out_array<Whole>(profile, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_gusts_init(windrow_gusts* gusts, uint32_t struct_size) {
    return turned<Same>(own_windrow_gusts_init, out_array<Whole>(gusts, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_canopy_init(windrow_canopy* canopy, uint32_t struct_size) {
    return turned<Same>(own_windrow_canopy_init, out_array<Whole>(canopy, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_roughness_map_init(windrow_roughness_map* map, uint32_t struct_size) {
    return turned<Same>(own_windrow_roughness_map_init, out_array<Whole>(map, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_roughness_init(windrow_roughness* roughness, uint32_t struct_size) {
    return turned<Same>(own_windrow_roughness_init, out_array<Whole>(roughness, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_rows_init(windrow_rows* rows, uint32_t struct_size) {
    return turned<Same>(own_windrow_rows_init, out_array<Whole>(rows, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_config_init(windrow_config* config, uint32_t struct_size) {
    return turned<Same>(own_windrow_config_init, out_array<Whole>(config, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_config_validate(const windrow_config* config) {
    return turned<Same>(own_windrow_config_validate, in_array<Whole>(config, 1));
}
WINDROW_EXPORT windrow_result windrow_plant_drag_init(windrow_plant_drag* plant, uint32_t struct_size) {
    return turned<Same>(own_windrow_plant_drag_init, out_array<Whole>(plant, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_belt_drag_init(windrow_belt_drag* belt, uint32_t struct_size) {
    return turned<Same>(own_windrow_belt_drag_init, out_array<Whole>(belt, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_wind_add_plant_drag(windrow_wind* wind, const windrow_plant_drag* plant, windrow_drag_id*
    id) {
    return turned<Same>(own_windrow_wind_add_plant_drag, same(wind), in_array<Whole>(plant, 1), same(id));
}
WINDROW_EXPORT windrow_result windrow_wind_add_belt_drag(windrow_wind* wind, const windrow_belt_drag* belt, windrow_drag_id* id) {
    return turned<Same>(own_windrow_wind_add_belt_drag, same(wind), in_array<Whole>(belt, 1), same(id));
}
WINDROW_EXPORT windrow_result windrow_wind_add_plants(windrow_wind* wind, const windrow_plant_drag* plants, uint64_t count,
    windrow_drag_id* ids) {
    return turned<Same>(own_windrow_wind_add_plants, same(wind), in_array<Whole>(plants, count), same(count), same(ids));
}
WINDROW_EXPORT windrow_result windrow_wind_set_plant_drag(windrow_wind* wind, windrow_drag_id id, const windrow_plant_drag* plant)
    {
    return turned<Same>(own_windrow_wind_set_plant_drag, same(wind), same(id), in_array<Whole>(plant, 1));
}
WINDROW_EXPORT windrow_result windrow_wind_set_belt_drag(windrow_wind* wind, windrow_drag_id id, const windrow_belt_drag* belt) {
    return turned<Same>(own_windrow_wind_set_belt_drag, same(wind), same(id), in_array<Whole>(belt, 1));
}
WINDROW_EXPORT windrow_result windrow_wind_get_plant_drag(const windrow_wind* wind, windrow_drag_id id, windrow_plant_drag* plant)
    {
    return turned<Same>(own_windrow_wind_get_plant_drag, same(wind), same(id), out_array<Whole>(plant, 1));
}
WINDROW_EXPORT windrow_result windrow_wind_get_belt_drag(const windrow_wind* wind, windrow_drag_id id, windrow_belt_drag* belt) {
    return turned<Same>(own_windrow_wind_get_belt_drag, same(wind), same(id), out_array<Whole>(belt, 1));
}
WINDROW_EXPORT windrow_result windrow_drag_force_init(windrow_drag_force* force, uint32_t struct_size) {
    return turned<Same>(own_windrow_drag_force_init, out_array<Whole>(force, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_wind_drag_force_on(const windrow_wind* wind, windrow_drag_id id, windrow_drag_force* force)
    {
    return turned<Same>(own_windrow_wind_drag_force_on, same(wind), same(id), out_array<Whole>(force, 1));
}
WINDROW_EXPORT windrow_result windrow_directional_motor_init(windrow_directional_motor* motor, uint32_t struct_size) {
    return turned<Same>(own_windrow_directional_motor_init, out_array<Whole>(motor, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_wake_motor_init(windrow_wake_motor* motor, uint32_t struct_size) {
    return turned<Same>(own_windrow_wake_motor_init, out_array<Whole>(motor, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_jet_motor_init(windrow_jet_motor* motor, uint32_t struct_size) {
    return turned<Same>(own_windrow_jet_motor_init, out_array<Whole>(motor, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_vortex_motor_init(windrow_vortex_motor* motor, uint32_t struct_size) {
    return turned<Same>(own_windrow_vortex_motor_init, out_array<Whole>(motor, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_omni_motor_init(windrow_omni_motor* motor, uint32_t struct_size) {
    return turned<Same>(own_windrow_omni_motor_init, out_array<Whole>(motor, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_pressure_motor_init(windrow_pressure_motor* motor, uint32_t struct_size) {
    return turned<Same>(own_windrow_pressure_motor_init, out_array<Whole>(motor, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_wind_add_directional(windrow_wind* wind, const windrow_directional_motor* motor,
    windrow_motor_id* id) {
    return turned<Same>(own_windrow_wind_add_directional, same(wind), in_array<Whole>(motor, 1), same(id));
}
WINDROW_EXPORT windrow_result windrow_wind_add_wake(windrow_wind* wind, const windrow_wake_motor* motor, windrow_motor_id* id) {
    return turned<Same>(own_windrow_wind_add_wake, same(wind), in_array<Whole>(motor, 1), same(id));
}
WINDROW_EXPORT windrow_result windrow_wind_add_jet(windrow_wind* wind, const windrow_jet_motor* motor, windrow_motor_id* id) {
    return turned<Same>(own_windrow_wind_add_jet, same(wind), in_array<Whole>(motor, 1), same(id));
}
WINDROW_EXPORT windrow_result windrow_wind_add_vortex(windrow_wind* wind, const windrow_vortex_motor* motor, windrow_motor_id* id)
    {
    return turned<Same>(own_windrow_wind_add_vortex, same(wind), in_array<Whole>(motor, 1), same(id));
}
WINDROW_EXPORT windrow_result windrow_wind_add_omni(windrow_wind* wind, const windrow_omni_motor* motor, windrow_motor_id* id) {
    return turned<Same>(own_windrow_wind_add_omni, same(wind), in_array<Whole>(motor, 1), same(id));
}
WINDROW_EXPORT windrow_result windrow_wind_add_pressure(windrow_wind* wind, const windrow_pressure_motor* motor, windrow_motor_id*
    id) {
    return turned<Same>(own_windrow_wind_add_pressure, same(wind), in_array<Whole>(motor, 1), same(id));
}
WINDROW_EXPORT windrow_result windrow_wind_set_directional(windrow_wind* wind, windrow_motor_id id, const
    windrow_directional_motor* motor) {
    return turned<Same>(own_windrow_wind_set_directional, same(wind), same(id), in_array<Whole>(motor, 1));
}
WINDROW_EXPORT windrow_result windrow_wind_set_wake(windrow_wind* wind, windrow_motor_id id, const windrow_wake_motor* motor) {
    return turned<Same>(own_windrow_wind_set_wake, same(wind), same(id), in_array<Whole>(motor, 1));
}
WINDROW_EXPORT windrow_result windrow_wind_set_jet(windrow_wind* wind, windrow_motor_id id, const windrow_jet_motor* motor) {
    return turned<Same>(own_windrow_wind_set_jet, same(wind), same(id), in_array<Whole>(motor, 1));
}
WINDROW_EXPORT windrow_result windrow_wind_set_vortex(windrow_wind* wind, windrow_motor_id id, const windrow_vortex_motor* motor)
    {
    return turned<Same>(own_windrow_wind_set_vortex, same(wind), same(id), in_array<Whole>(motor, 1));
}
WINDROW_EXPORT windrow_result windrow_wind_set_omni(windrow_wind* wind, windrow_motor_id id, const windrow_omni_motor* motor) {
    return turned<Same>(own_windrow_wind_set_omni, same(wind), same(id), in_array<Whole>(motor, 1));
}
WINDROW_EXPORT windrow_result windrow_wind_set_pressure(windrow_wind* wind, windrow_motor_id id, const windrow_pressure_motor*
    motor) {
    return turned<Same>(own_windrow_wind_set_pressure, same(wind), same(id), in_array<Whole>(motor, 1));
}
WINDROW_EXPORT windrow_result windrow_wind_get_directional(const windrow_wind* wind, windrow_motor_id id,
    windrow_directional_motor* motor) {
    return turned<Same>(own_windrow_wind_get_directional, same(wind), same(id), out_array<Whole>(motor, 1));
}
WINDROW_EXPORT windrow_result windrow_wind_get_wake(const windrow_wind* wind, windrow_motor_id id, windrow_wake_motor* motor) {
    return turned<Same>(own_windrow_wind_get_wake, same(wind), same(id), out_array<Whole>(motor, 1));
}
WINDROW_EXPORT windrow_result windrow_wind_get_jet(const windrow_wind* wind, windrow_motor_id id, windrow_jet_motor* motor) {
    return turned<Same>(own_windrow_wind_get_jet, same(wind), same(id), out_array<Whole>(motor, 1));
}
WINDROW_EXPORT windrow_result windrow_wind_get_vortex(const windrow_wind* wind, windrow_motor_id id, windrow_vortex_motor* motor)
    {
    return turned<Same>(own_windrow_wind_get_vortex, same(wind), same(id), out_array<Whole>(motor, 1));
}
WINDROW_EXPORT windrow_result windrow_wind_get_omni(const windrow_wind* wind, windrow_motor_id id, windrow_omni_motor* motor) {
    return turned<Same>(own_windrow_wind_get_omni, same(wind), same(id), out_array<Whole>(motor, 1));
}
WINDROW_EXPORT windrow_result windrow_wind_get_pressure(const windrow_wind* wind, windrow_motor_id id, windrow_pressure_motor*
    motor) {
    return turned<Same>(own_windrow_wind_get_pressure, same(wind), same(id), out_array<Whole>(motor, 1));
}
WINDROW_EXPORT windrow_result windrow_wind_move_motor(windrow_wind* wind, windrow_motor_id id, windrow_dvec3 position) {
    return turned<Same>(own_windrow_wind_move_motor, same(wind), same(id), in<Vector<1>>(position));
}
WINDROW_EXPORT float windrow_mesh_distance(const windrow_mesh* mesh, windrow_vec3 point) {
    return turned<Number<1>>(own_windrow_mesh_distance, same(mesh), in<Vector<1>>(point));
}
WINDROW_EXPORT windrow_result windrow_obstacle_init(windrow_obstacle* obstacle, uint32_t struct_size) {
    return turned<Same>(own_windrow_obstacle_init, out_array<Whole>(obstacle, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_obstacle_force_init(windrow_obstacle_force* force, uint32_t struct_size) {
    return turned<Same>(own_windrow_obstacle_force_init, out_array<Whole>(force, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_wind_force_on(const windrow_wind* wind, windrow_obstacle_id id, windrow_obstacle_force*
    force) {
    return turned<Same>(own_windrow_wind_force_on, same(wind), same(id), out_array<Whole>(force, 1));
}
WINDROW_EXPORT windrow_result windrow_workspace_create(const windrow_config* config, windrow_workspace** work) {
    return turned<Same>(own_windrow_workspace_create, in_array<Whole>(config, 1), same(work));
}
WINDROW_EXPORT windrow_result windrow_workspace_set_boundaries(windrow_workspace* work, const windrow_boundaries* boundaries) {
    return turned<Same>(own_windrow_workspace_set_boundaries, same(work), in_array<Whole>(boundaries, 1));
}
WINDROW_EXPORT windrow_result windrow_workspace_set_ambient(windrow_workspace* work, windrow_vec3 ambient) {
    return turned<Same>(own_windrow_workspace_set_ambient, same(work), in<Vector<1>>(ambient));
}
WINDROW_EXPORT windrow_result windrow_workspace_impulse_on(const windrow_workspace* work, uint64_t obstacle, windrow_vec3*
    impulse) {
    return turned<Same>(own_windrow_workspace_impulse_on, same(work), same(obstacle), out_array<Vector<4>>(impulse, 1));
}
WINDROW_EXPORT windrow_result windrow_diffuse(windrow_workspace* work, const windrow_vec4* field, float viscosity, float dt,
    windrow_vec4* result, windrow_diffusion_method* method, uint64_t count) {
    return turned<Same>(own_windrow_diffuse, same(work), same(field), in<Number<2>>(viscosity), same(dt), same(result),
        same(method), same(count));
}
WINDROW_EXPORT windrow_result windrow_scene_step(windrow_scene* scene, windrow_diagnostics* diagnostics) {
    return turned<Same>(own_windrow_scene_step, same(scene), out_array<Whole>(diagnostics, 1));
}
WINDROW_EXPORT windrow_result windrow_tracer_blow(windrow_tracer* tracer, windrow_dvec3 point, float radius) {
    return turned<Same>(own_windrow_tracer_blow, same(tracer), in<Vector<1>>(point), in<Number<1>>(radius));
}
WINDROW_EXPORT windrow_result windrow_vdb_film_init(windrow_vdb_film* film, uint32_t struct_size) {
    return turned<Same>(own_windrow_vdb_film_init, out_array<Whole>(film, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_vdb_write_film(const windrow_wind* wind, const windrow_vdb_film* film, const char* path,
    const windrow_vdb_options* options) {
    return turned<Same>(own_windrow_vdb_write_film, same(wind), in_array<Whole>(film, 1), same(path), same(options));
}
WINDROW_EXPORT windrow_result windrow_diagnostics_init(windrow_diagnostics* diagnostics, uint32_t struct_size) {
    return turned<Same>(own_windrow_diagnostics_init, out_array<Whole>(diagnostics, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_box_init(windrow_box* box, uint32_t struct_size) {
    return turned<Same>(own_windrow_box_init, out_array<Whole>(box, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_wind_create(const windrow_config* config, windrow_wind** wind) {
    return turned<Same>(own_windrow_wind_create, in_array<Whole>(config, 1), same(wind));
}
WINDROW_EXPORT windrow_result windrow_wind_config(windrow_wind* wind, windrow_config* config) {
    return turned<Same>(own_windrow_wind_config, same(wind), out_array<Whole>(config, 1));
}
WINDROW_EXPORT windrow_result windrow_wind_step(windrow_wind* wind, double dt, windrow_diagnostics* diagnostics) {
    return turned<Same>(own_windrow_wind_step, same(wind), same(dt), out_array<Whole>(diagnostics, 1));
}
WINDROW_EXPORT windrow_result windrow_wind_advance(windrow_wind* wind, double dt, windrow_advance* advance, windrow_diagnostics*
    last) {
    return turned<Same>(own_windrow_wind_advance, same(wind), same(dt), same(advance), out_array<Whole>(last, 1));
}
WINDROW_EXPORT windrow_result windrow_wind_follow(windrow_wind* wind, windrow_dvec3 point) {
    return turned<Same>(own_windrow_wind_follow, same(wind), in<Vector<1>>(point));
}
WINDROW_EXPORT windrow_result windrow_wind_set_floor(windrow_wind* wind, double height) {
    return turned<Same>(own_windrow_wind_set_floor, same(wind), in<Number<1>>(height));
}
WINDROW_EXPORT windrow_result windrow_wind_shift_origin(windrow_wind* wind, windrow_dvec3 offset) {
    return turned<Same>(own_windrow_wind_shift_origin, same(wind), in<Vector<1>>(offset));
}
WINDROW_EXPORT windrow_result windrow_wind_box(const windrow_wind* wind, windrow_box* box) {
    return turned<Same>(own_windrow_wind_box, same(wind), out_array<Whole>(box, 1));
}
WINDROW_EXPORT windrow_result windrow_wind_set_ambient(windrow_wind* wind, windrow_vec3 ambient) {
    return turned<Same>(own_windrow_wind_set_ambient, same(wind), in<Vector<1>>(ambient));
}
WINDROW_EXPORT windrow_vec3 windrow_wind_ambient(const windrow_wind* wind) {
    return turned<Vector<1>>(own_windrow_wind_ambient, same(wind));
}
WINDROW_EXPORT windrow_result windrow_wind_set_gusts(windrow_wind* wind, const windrow_gusts* gusts) {
    return turned<Same>(own_windrow_wind_set_gusts, same(wind), in_array<Whole>(gusts, 1));
}
WINDROW_EXPORT windrow_result windrow_wind_set_boundaries(windrow_wind* wind, const windrow_boundaries* boundaries) {
    return turned<Same>(own_windrow_wind_set_boundaries, same(wind), in_array<Whole>(boundaries, 1));
}
WINDROW_EXPORT windrow_result windrow_wind_velocity(const windrow_wind* wind, windrow_dvec3 position, windrow_vec3* velocity) {
    return turned<Same>(own_windrow_wind_velocity, same(wind), in<Vector<1>>(position), out_array<Vector<1>>(velocity, 1));
}
WINDROW_EXPORT windrow_result windrow_wind_felt(const windrow_wind* wind, windrow_dvec3 position, const windrow_sampling*
    sampling, windrow_vec3* velocity) {
    return turned<Same>(own_windrow_wind_felt, same(wind), in<Vector<1>>(position), in_array<Whole>(sampling, 1),
        out_array<Vector<1>>(velocity, 1));
}
WINDROW_EXPORT windrow_result windrow_query_init(windrow_query* query, uint32_t struct_size) {
    return turned<Same>(own_windrow_query_init, out_array<Whole>(query, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_debug_view_init(windrow_debug_view* view, uint32_t struct_size) {
    return turned<Same>(own_windrow_debug_view_init, out_array<Whole>(view, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_wind_window_block(const windrow_wind* wind, windrow_dvec3 anchor, windrow_window_block*
    block) {
    return turned<Same>(own_windrow_wind_window_block, same(wind), in<Vector<1>>(anchor), same(block));
}
WINDROW_EXPORT windrow_result windrow_wind_frame_block(const windrow_wind* wind, windrow_dvec3 anchor, const windrow_sampling*
    sampling, windrow_frame_block* block) {
    return turned<Same>(own_windrow_wind_frame_block, same(wind), in<Vector<1>>(anchor), in_array<Whole>(sampling, 1),
        same(block));
}
