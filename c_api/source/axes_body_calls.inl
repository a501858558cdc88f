// Made by ./dev schema from the headers and tools/c_kinds.py. Do not edit.
// clang-format off
// Each call that converts: what goes in, the call itself, what comes out.

WINDROW_EXPORT windrow_result windrow_plant_drag_init(windrow_plant_drag* plant, uint32_t struct_size) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_plant_drag_init(plant, struct_size);
    return turned<Same>(own_windrow_plant_drag_init, out_array<Whole>(plant, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_belt_drag_init(windrow_belt_drag* belt, uint32_t struct_size) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_belt_drag_init(belt, struct_size);
    return turned<Same>(own_windrow_belt_drag_init, out_array<Whole>(belt, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_wind_add_plant_drag(windrow_wind* wind, const windrow_plant_drag* plant, windrow_drag_id*
    id) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_wind_add_plant_drag(wind, plant, id);
    return turned<Same>(own_windrow_wind_add_plant_drag, same(wind), in_array<Whole>(plant, 1), same(id));
}
WINDROW_EXPORT windrow_result windrow_wind_add_belt_drag(windrow_wind* wind, const windrow_belt_drag* belt, windrow_drag_id* id) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_wind_add_belt_drag(wind, belt, id);
    return turned<Same>(own_windrow_wind_add_belt_drag, same(wind), in_array<Whole>(belt, 1), same(id));
}
WINDROW_EXPORT windrow_result windrow_wind_add_plants(windrow_wind* wind, const windrow_plant_drag* plants, uint64_t count,
    windrow_drag_id* ids) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_wind_add_plants(wind, plants, count, ids);
    return turned<Same>(own_windrow_wind_add_plants, same(wind), in_array<Whole>(plants, count), same(count), same(ids));
}
WINDROW_EXPORT windrow_result windrow_wind_set_plant_drag(windrow_wind* wind, windrow_drag_id id, const windrow_plant_drag* plant)
    {
    if (!host_axes.turned) [[likely]]
        return own_windrow_wind_set_plant_drag(wind, id, plant);
    return turned<Same>(own_windrow_wind_set_plant_drag, same(wind), same(id), in_array<Whole>(plant, 1));
}
WINDROW_EXPORT windrow_result windrow_wind_set_belt_drag(windrow_wind* wind, windrow_drag_id id, const windrow_belt_drag* belt) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_wind_set_belt_drag(wind, id, belt);
    return turned<Same>(own_windrow_wind_set_belt_drag, same(wind), same(id), in_array<Whole>(belt, 1));
}
WINDROW_EXPORT windrow_result windrow_wind_get_plant_drag(const windrow_wind* wind, windrow_drag_id id, windrow_plant_drag* plant)
    {
    if (!host_axes.turned) [[likely]]
        return own_windrow_wind_get_plant_drag(wind, id, plant);
    return turned<Same>(own_windrow_wind_get_plant_drag, same(wind), same(id), out_array<Whole>(plant, 1));
}
WINDROW_EXPORT windrow_result windrow_wind_get_belt_drag(const windrow_wind* wind, windrow_drag_id id, windrow_belt_drag* belt) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_wind_get_belt_drag(wind, id, belt);
    return turned<Same>(own_windrow_wind_get_belt_drag, same(wind), same(id), out_array<Whole>(belt, 1));
}
WINDROW_EXPORT windrow_result windrow_drag_force_init(windrow_drag_force* force, uint32_t struct_size) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_drag_force_init(force, struct_size);
    return turned<Same>(own_windrow_drag_force_init, out_array<Whole>(force, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_wind_drag_force_on(const windrow_wind* wind, windrow_drag_id id, windrow_drag_force* force)
    {
    if (!host_axes.turned) [[likely]]
        return own_windrow_wind_drag_force_on(wind, id, force);
    return turned<Same>(own_windrow_wind_drag_force_on, same(wind), same(id), out_array<Whole>(force, 1));
}
WINDROW_EXPORT windrow_result windrow_directional_motor_init(windrow_directional_motor* motor, uint32_t struct_size) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_directional_motor_init(motor, struct_size);
    return turned<Same>(own_windrow_directional_motor_init, out_array<Whole>(motor, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_wake_motor_init(windrow_wake_motor* motor, uint32_t struct_size) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_wake_motor_init(motor, struct_size);
    return turned<Same>(own_windrow_wake_motor_init, out_array<Whole>(motor, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_jet_motor_init(windrow_jet_motor* motor, uint32_t struct_size) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_jet_motor_init(motor, struct_size);
    return turned<Same>(own_windrow_jet_motor_init, out_array<Whole>(motor, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_vortex_motor_init(windrow_vortex_motor* motor, uint32_t struct_size) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_vortex_motor_init(motor, struct_size);
    return turned<Same>(own_windrow_vortex_motor_init, out_array<Whole>(motor, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_omni_motor_init(windrow_omni_motor* motor, uint32_t struct_size) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_omni_motor_init(motor, struct_size);
    return turned<Same>(own_windrow_omni_motor_init, out_array<Whole>(motor, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_pressure_motor_init(windrow_pressure_motor* motor, uint32_t struct_size) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_pressure_motor_init(motor, struct_size);
    return turned<Same>(own_windrow_pressure_motor_init, out_array<Whole>(motor, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_wind_add_directional(windrow_wind* wind, const windrow_directional_motor* motor,
    windrow_motor_id* id) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_wind_add_directional(wind, motor, id);
    return turned<Same>(own_windrow_wind_add_directional, same(wind), in_array<Whole>(motor, 1), same(id));
}
WINDROW_EXPORT windrow_result windrow_wind_add_wake(windrow_wind* wind, const windrow_wake_motor* motor, windrow_motor_id* id) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_wind_add_wake(wind, motor, id);
    return turned<Same>(own_windrow_wind_add_wake, same(wind), in_array<Whole>(motor, 1), same(id));
}
WINDROW_EXPORT windrow_result windrow_wind_add_jet(windrow_wind* wind, const windrow_jet_motor* motor, windrow_motor_id* id) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_wind_add_jet(wind, motor, id);
    return turned<Same>(own_windrow_wind_add_jet, same(wind), in_array<Whole>(motor, 1), same(id));
}
WINDROW_EXPORT windrow_result windrow_wind_add_vortex(windrow_wind* wind, const windrow_vortex_motor* motor, windrow_motor_id* id)
    {
    if (!host_axes.turned) [[likely]]
        return own_windrow_wind_add_vortex(wind, motor, id);
    return turned<Same>(own_windrow_wind_add_vortex, same(wind), in_array<Whole>(motor, 1), same(id));
}
WINDROW_EXPORT windrow_result windrow_wind_add_omni(windrow_wind* wind, const windrow_omni_motor* motor, windrow_motor_id* id) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_wind_add_omni(wind, motor, id);
    return turned<Same>(own_windrow_wind_add_omni, same(wind), in_array<Whole>(motor, 1), same(id));
}
WINDROW_EXPORT windrow_result windrow_wind_add_pressure(windrow_wind* wind, const windrow_pressure_motor* motor, windrow_motor_id*
    id) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_wind_add_pressure(wind, motor, id);
    return turned<Same>(own_windrow_wind_add_pressure, same(wind), in_array<Whole>(motor, 1), same(id));
}
WINDROW_EXPORT windrow_result windrow_wind_set_directional(windrow_wind* wind, windrow_motor_id id, const
    windrow_directional_motor* motor) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_wind_set_directional(wind, id, motor);
    return turned<Same>(own_windrow_wind_set_directional, same(wind), same(id), in_array<Whole>(motor, 1));
}
WINDROW_EXPORT windrow_result windrow_wind_set_wake(windrow_wind* wind, windrow_motor_id id, const windrow_wake_motor* motor) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_wind_set_wake(wind, id, motor);
    return turned<Same>(own_windrow_wind_set_wake, same(wind), same(id), in_array<Whole>(motor, 1));
}
WINDROW_EXPORT windrow_result windrow_wind_set_jet(windrow_wind* wind, windrow_motor_id id, const windrow_jet_motor* motor) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_wind_set_jet(wind, id, motor);
    return turned<Same>(own_windrow_wind_set_jet, same(wind), same(id), in_array<Whole>(motor, 1));
}
WINDROW_EXPORT windrow_result windrow_wind_set_vortex(windrow_wind* wind, windrow_motor_id id, const windrow_vortex_motor* motor)
    {
    if (!host_axes.turned) [[likely]]
        return own_windrow_wind_set_vortex(wind, id, motor);
    return turned<Same>(own_windrow_wind_set_vortex, same(wind), same(id), in_array<Whole>(motor, 1));
}
WINDROW_EXPORT windrow_result windrow_wind_set_omni(windrow_wind* wind, windrow_motor_id id, const windrow_omni_motor* motor) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_wind_set_omni(wind, id, motor);
    return turned<Same>(own_windrow_wind_set_omni, same(wind), same(id), in_array<Whole>(motor, 1));
}
WINDROW_EXPORT windrow_result windrow_wind_set_pressure(windrow_wind* wind, windrow_motor_id id, const windrow_pressure_motor*
    motor) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_wind_set_pressure(wind, id, motor);
    return turned<Same>(own_windrow_wind_set_pressure, same(wind), same(id), in_array<Whole>(motor, 1));
}
WINDROW_EXPORT windrow_result windrow_wind_get_directional(const windrow_wind* wind, windrow_motor_id id,
    windrow_directional_motor* motor) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_wind_get_directional(wind, id, motor);
    return turned<Same>(own_windrow_wind_get_directional, same(wind), same(id), out_array<Whole>(motor, 1));
}
WINDROW_EXPORT windrow_result windrow_wind_get_wake(const windrow_wind* wind, windrow_motor_id id, windrow_wake_motor* motor) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_wind_get_wake(wind, id, motor);
    return turned<Same>(own_windrow_wind_get_wake, same(wind), same(id), out_array<Whole>(motor, 1));
}
WINDROW_EXPORT windrow_result windrow_wind_get_jet(const windrow_wind* wind, windrow_motor_id id, windrow_jet_motor* motor) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_wind_get_jet(wind, id, motor);
    return turned<Same>(own_windrow_wind_get_jet, same(wind), same(id), out_array<Whole>(motor, 1));
}
WINDROW_EXPORT windrow_result windrow_wind_get_vortex(const windrow_wind* wind, windrow_motor_id id, windrow_vortex_motor* motor)
    {
    if (!host_axes.turned) [[likely]]
        return own_windrow_wind_get_vortex(wind, id, motor);
    return turned<Same>(own_windrow_wind_get_vortex, same(wind), same(id), out_array<Whole>(motor, 1));
}
WINDROW_EXPORT windrow_result windrow_wind_get_omni(const windrow_wind* wind, windrow_motor_id id, windrow_omni_motor* motor) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_wind_get_omni(wind, id, motor);
    return turned<Same>(own_windrow_wind_get_omni, same(wind), same(id), out_array<Whole>(motor, 1));
}
WINDROW_EXPORT windrow_result windrow_wind_get_pressure(const windrow_wind* wind, windrow_motor_id id, windrow_pressure_motor*
    motor) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_wind_get_pressure(wind, id, motor);
    return turned<Same>(own_windrow_wind_get_pressure, same(wind), same(id), out_array<Whole>(motor, 1));
}
WINDROW_EXPORT windrow_result windrow_wind_move_motor(windrow_wind* wind, windrow_motor_id id, windrow_dvec3 position) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_wind_move_motor(wind, id, position);
    return turned<Same>(own_windrow_wind_move_motor, same(wind), same(id), in<Vector<1>>(position));
}
WINDROW_EXPORT float windrow_mesh_distance(const windrow_mesh* mesh, windrow_vec3 point) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_mesh_distance(mesh, point);
    return turned<Number<1>>(own_windrow_mesh_distance, same(mesh), in<Vector<1>>(point));
}
WINDROW_EXPORT windrow_result windrow_obstacle_init(windrow_obstacle* obstacle, uint32_t struct_size) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_obstacle_init(obstacle, struct_size);
    return turned<Same>(own_windrow_obstacle_init, out_array<Whole>(obstacle, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_obstacle_force_init(windrow_obstacle_force* force, uint32_t struct_size) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_obstacle_force_init(force, struct_size);
    return turned<Same>(own_windrow_obstacle_force_init, out_array<Whole>(force, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_wind_force_on(const windrow_wind* wind, windrow_obstacle_id id, windrow_obstacle_force*
    force) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_wind_force_on(wind, id, force);
    return turned<Same>(own_windrow_wind_force_on, same(wind), same(id), out_array<Whole>(force, 1));
}
WINDROW_EXPORT windrow_result windrow_workspace_create(const windrow_config* config, windrow_workspace** work) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_workspace_create(config, work);
    return turned<Same>(own_windrow_workspace_create, in_array<Whole>(config, 1), same(work));
}
WINDROW_EXPORT windrow_result windrow_workspace_set_boundaries(windrow_workspace* work, const windrow_boundaries* boundaries) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_workspace_set_boundaries(work, boundaries);
    return turned<Same>(own_windrow_workspace_set_boundaries, same(work), in_array<Whole>(boundaries, 1));
}
WINDROW_EXPORT windrow_result windrow_workspace_set_ambient(windrow_workspace* work, windrow_vec3 ambient) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_workspace_set_ambient(work, ambient);
    return turned<Same>(own_windrow_workspace_set_ambient, same(work), in<Vector<1>>(ambient));
}
WINDROW_EXPORT windrow_result windrow_workspace_impulse_on(const windrow_workspace* work, uint64_t obstacle, windrow_vec3*
    impulse) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_workspace_impulse_on(work, obstacle, impulse);
    return turned<Same>(own_windrow_workspace_impulse_on, same(work), same(obstacle), out_array<Vector<4>>(impulse, 1));
}
WINDROW_EXPORT windrow_result windrow_diffuse(windrow_workspace* work, const windrow_vec4* field, float viscosity, float dt,
    windrow_vec4* result, windrow_diffusion_method* method, uint64_t count) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_diffuse(work, field, viscosity, dt, result, method, count);
    return turned<Same>(own_windrow_diffuse, same(work), same(field), in<Number<2>>(viscosity), same(dt), same(result),
        same(method), same(count));
}
