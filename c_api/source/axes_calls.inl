// Made by ./dev schema from the headers and tools/c_kinds.py. Do not edit.
// clang-format off
// Each call that converts: what goes in, the call itself, what comes out.

WINDROW_EXPORT windrow_result windrow_sampling_init(windrow_sampling* sampling, uint32_t struct_size) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_sampling_init(sampling, struct_size);
    return turned<Same>(own_windrow_sampling_init, out_array<Whole>(sampling, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_sampling_validate(const windrow_sampling* sampling) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_sampling_validate(sampling);
    return turned<Same>(own_windrow_sampling_validate, in_array<Whole>(sampling, 1));
}
WINDROW_EXPORT windrow_result windrow_ambient_settings_init(windrow_ambient_settings* settings, uint32_t struct_size) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_ambient_settings_init(settings, struct_size);
    return turned<Same>(own_windrow_ambient_settings_init, out_array<Whole>(settings, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_ambient_wind_create(const windrow_ambient_settings* settings, windrow_ambient_wind**
    ambient) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_ambient_wind_create(settings, ambient);
    return turned<Same>(own_windrow_ambient_wind_create, in_array<Whole>(settings, 1), same(ambient));
}
WINDROW_EXPORT windrow_result windrow_ambient_wind_set_mean(windrow_ambient_wind* ambient, windrow_vec3 mean) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_ambient_wind_set_mean(ambient, mean);
    return turned<Same>(own_windrow_ambient_wind_set_mean, same(ambient), in<Vector<1>>(mean));
}
WINDROW_EXPORT windrow_result windrow_ambient_wind_set_ground(windrow_ambient_wind* ambient, double height) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_ambient_wind_set_ground(ambient, height);
    return turned<Same>(own_windrow_ambient_wind_set_ground, same(ambient), in<Number<1>>(height));
}
WINDROW_EXPORT windrow_result windrow_ambient_wind_set_phase(windrow_ambient_wind* ambient, windrow_dvec3 phase) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_ambient_wind_set_phase(ambient, phase);
    return turned<Same>(own_windrow_ambient_wind_set_phase, same(ambient), in<Vector<1>>(phase));
}
WINDROW_EXPORT windrow_dvec3 windrow_ambient_wind_phase(const windrow_ambient_wind* ambient) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_ambient_wind_phase(ambient);
    return turned<Vector<1>>(own_windrow_ambient_wind_phase, same(ambient));
}
WINDROW_EXPORT double windrow_ambient_wind_period(const windrow_ambient_wind* ambient) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_ambient_wind_period(ambient);
    return turned<Number<1>>(own_windrow_ambient_wind_period, same(ambient));
}
WINDROW_EXPORT windrow_vec3 windrow_ambient_wind_mean(const windrow_ambient_wind* ambient) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_ambient_wind_mean(ambient);
    return turned<Vector<1>>(own_windrow_ambient_wind_mean, same(ambient));
}
WINDROW_EXPORT double windrow_ambient_wind_ground(const windrow_ambient_wind* ambient) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_ambient_wind_ground(ambient);
    return turned<Number<1>>(own_windrow_ambient_wind_ground, same(ambient));
}
WINDROW_EXPORT float windrow_ambient_wind_profile_at(const windrow_ambient_wind* ambient, double height) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_ambient_wind_profile_at(ambient, height);
    return turned<Same>(own_windrow_ambient_wind_profile_at, same(ambient), in<Number<1>>(height));
}
WINDROW_EXPORT windrow_result windrow_ambient_wind_velocity(const windrow_ambient_wind* ambient, windrow_dvec3 position,
    windrow_vec3* velocity) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_ambient_wind_velocity(ambient, position, velocity);
    return turned<Same>(own_windrow_ambient_wind_velocity, same(ambient), in<Vector<1>>(position), out_array<Vector<1>>(velocity,
        1));
}
WINDROW_EXPORT windrow_result windrow_ambient_wind_felt(const windrow_ambient_wind* ambient, windrow_dvec3 position, const
    windrow_sampling* sampling, windrow_vec3* velocity) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_ambient_wind_felt(ambient, position, sampling, velocity);
    return turned<Same>(own_windrow_ambient_wind_felt, same(ambient), in<Vector<1>>(position), in_array<Whole>(sampling, 1),
        both<Vector<1>>(velocity, 1));
}
WINDROW_EXPORT windrow_result windrow_ambient_wind_block(const windrow_ambient_wind* ambient, windrow_dvec3 anchor, const
    windrow_sampling* sampling, windrow_ambient_block* block) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_ambient_wind_block(ambient, anchor, sampling, block);
    return turned<Same>(own_windrow_ambient_wind_block, same(ambient), in<Vector<1>>(anchor), in_array<Whole>(sampling, 1),
        same(block));
}
WINDROW_EXPORT windrow_result windrow_uniform_gust_init(windrow_uniform_gust* gust, uint32_t struct_size) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_uniform_gust_init(gust, struct_size);
    return turned<Same>(own_windrow_uniform_gust_init, out_array<Whole>(gust, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_uniform_gust_velocity(const windrow_uniform_gust* gust, double time, windrow_vec3* velocity)
    {
    if (!host_axes.turned) [[likely]]
        return own_windrow_uniform_gust_velocity(gust, time, velocity);
    return turned<Same>(own_windrow_uniform_gust_velocity, in_array<Whole>(gust, 1), same(time), out_array<Vector<1>>(velocity,
        1));
}
WINDROW_EXPORT windrow_boundaries windrow_boundaries_open_over_floor(void) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_boundaries_open_over_floor();
    return turned<Whole>(own_windrow_boundaries_open_over_floor);
}
WINDROW_EXPORT windrow_result windrow_log_profile_init(windrow_log_profile* profile, uint32_t struct_size) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_log_profile_init(profile, struct_size);
    return turned<Same>(own_windrow_log_profile_init, out_array<Whole>(profile, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_gusts_init(windrow_gusts* gusts, uint32_t struct_size) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_gusts_init(gusts, struct_size);
    return turned<Same>(own_windrow_gusts_init, out_array<Whole>(gusts, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_canopy_init(windrow_canopy* canopy, uint32_t struct_size) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_canopy_init(canopy, struct_size);
    return turned<Same>(own_windrow_canopy_init, out_array<Whole>(canopy, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_roughness_map_init(windrow_roughness_map* map, uint32_t struct_size) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_roughness_map_init(map, struct_size);
    return turned<Same>(own_windrow_roughness_map_init, out_array<Whole>(map, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_roughness_init(windrow_roughness* roughness, uint32_t struct_size) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_roughness_init(roughness, struct_size);
    return turned<Same>(own_windrow_roughness_init, out_array<Whole>(roughness, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_rows_init(windrow_rows* rows, uint32_t struct_size) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_rows_init(rows, struct_size);
    return turned<Same>(own_windrow_rows_init, out_array<Whole>(rows, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_config_init(windrow_config* config, uint32_t struct_size) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_config_init(config, struct_size);
    return turned<Same>(own_windrow_config_init, out_array<Whole>(config, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_config_validate(const windrow_config* config) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_config_validate(config);
    return turned<Same>(own_windrow_config_validate, in_array<Whole>(config, 1));
}
WINDROW_EXPORT windrow_result windrow_scene_step(windrow_scene* scene, windrow_diagnostics* diagnostics) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_scene_step(scene, diagnostics);
    return turned<Same>(own_windrow_scene_step, same(scene), out_array<Whole>(diagnostics, 1));
}
WINDROW_EXPORT windrow_result windrow_tracer_blow(windrow_tracer* tracer, windrow_dvec3 point, float radius) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_tracer_blow(tracer, point, radius);
    return turned<Same>(own_windrow_tracer_blow, same(tracer), in<Vector<1>>(point), in<Number<1>>(radius));
}
WINDROW_EXPORT windrow_result windrow_vdb_film_init(windrow_vdb_film* film, uint32_t struct_size) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_vdb_film_init(film, struct_size);
    return turned<Same>(own_windrow_vdb_film_init, out_array<Whole>(film, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_vdb_write_film(const windrow_wind* wind, const windrow_vdb_film* film, const char* path,
    const windrow_vdb_options* options) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_vdb_write_film(wind, film, path, options);
    return turned<Same>(own_windrow_vdb_write_film, same(wind), in_array<Whole>(film, 1), same(path), same(options));
}
WINDROW_EXPORT windrow_result windrow_diagnostics_init(windrow_diagnostics* diagnostics, uint32_t struct_size) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_diagnostics_init(diagnostics, struct_size);
    return turned<Same>(own_windrow_diagnostics_init, out_array<Whole>(diagnostics, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_box_init(windrow_box* box, uint32_t struct_size) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_box_init(box, struct_size);
    return turned<Same>(own_windrow_box_init, out_array<Whole>(box, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_wind_create(const windrow_config* config, windrow_wind** wind) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_wind_create(config, wind);
    return turned<Same>(own_windrow_wind_create, in_array<Whole>(config, 1), same(wind));
}
WINDROW_EXPORT windrow_result windrow_wind_create_inside(const windrow_config* config, const windrow_wind* outer, windrow_wind**
    wind) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_wind_create_inside(config, outer, wind);
    return turned<Same>(own_windrow_wind_create_inside, in_array<Whole>(config, 1), same(outer), same(wind));
}
WINDROW_EXPORT windrow_result windrow_wind_config(windrow_wind* wind, windrow_config* config) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_wind_config(wind, config);
    return turned<Same>(own_windrow_wind_config, same(wind), out_array<Whole>(config, 1));
}
WINDROW_EXPORT windrow_result windrow_wind_step(windrow_wind* wind, double dt, windrow_diagnostics* diagnostics) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_wind_step(wind, dt, diagnostics);
    return turned<Same>(own_windrow_wind_step, same(wind), same(dt), out_array<Whole>(diagnostics, 1));
}
WINDROW_EXPORT windrow_result windrow_wind_advance(windrow_wind* wind, double dt, windrow_advance* advance, windrow_diagnostics*
    last) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_wind_advance(wind, dt, advance, last);
    return turned<Same>(own_windrow_wind_advance, same(wind), same(dt), same(advance), out_array<Whole>(last, 1));
}
WINDROW_EXPORT windrow_result windrow_wind_follow(windrow_wind* wind, windrow_dvec3 point) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_wind_follow(wind, point);
    return turned<Same>(own_windrow_wind_follow, same(wind), in<Vector<1>>(point));
}
WINDROW_EXPORT windrow_result windrow_wind_set_floor(windrow_wind* wind, double height) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_wind_set_floor(wind, height);
    return turned<Same>(own_windrow_wind_set_floor, same(wind), in<Number<1>>(height));
}
WINDROW_EXPORT windrow_result windrow_wind_shift_origin(windrow_wind* wind, windrow_dvec3 offset) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_wind_shift_origin(wind, offset);
    return turned<Same>(own_windrow_wind_shift_origin, same(wind), in<Vector<1>>(offset));
}
WINDROW_EXPORT windrow_result windrow_wind_box(const windrow_wind* wind, windrow_box* box) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_wind_box(wind, box);
    return turned<Same>(own_windrow_wind_box, same(wind), out_array<Whole>(box, 1));
}
WINDROW_EXPORT windrow_result windrow_wind_set_ambient(windrow_wind* wind, windrow_vec3 ambient) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_wind_set_ambient(wind, ambient);
    return turned<Same>(own_windrow_wind_set_ambient, same(wind), in<Vector<1>>(ambient));
}
WINDROW_EXPORT windrow_vec3 windrow_wind_ambient(const windrow_wind* wind) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_wind_ambient(wind);
    return turned<Vector<1>>(own_windrow_wind_ambient, same(wind));
}
WINDROW_EXPORT windrow_result windrow_wind_set_gusts(windrow_wind* wind, const windrow_gusts* gusts) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_wind_set_gusts(wind, gusts);
    return turned<Same>(own_windrow_wind_set_gusts, same(wind), in_array<Whole>(gusts, 1));
}
WINDROW_EXPORT windrow_result windrow_wind_set_boundaries(windrow_wind* wind, const windrow_boundaries* boundaries) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_wind_set_boundaries(wind, boundaries);
    return turned<Same>(own_windrow_wind_set_boundaries, same(wind), in_array<Whole>(boundaries, 1));
}
WINDROW_EXPORT windrow_result windrow_wind_velocity(const windrow_wind* wind, windrow_dvec3 position, windrow_vec3* velocity) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_wind_velocity(wind, position, velocity);
    return turned<Same>(own_windrow_wind_velocity, same(wind), in<Vector<1>>(position), out_array<Vector<1>>(velocity, 1));
}
WINDROW_EXPORT windrow_result windrow_wind_felt(const windrow_wind* wind, windrow_dvec3 position, const windrow_sampling*
    sampling, windrow_vec3* velocity) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_wind_felt(wind, position, sampling, velocity);
    return turned<Same>(own_windrow_wind_felt, same(wind), in<Vector<1>>(position), in_array<Whole>(sampling, 1),
        out_array<Vector<1>>(velocity, 1));
}
WINDROW_EXPORT windrow_result windrow_query_init(windrow_query* query, uint32_t struct_size) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_query_init(query, struct_size);
    return turned<Same>(own_windrow_query_init, out_array<Whole>(query, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_debug_view_init(windrow_debug_view* view, uint32_t struct_size) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_debug_view_init(view, struct_size);
    return turned<Same>(own_windrow_debug_view_init, out_array<Whole>(view, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_wind_window_block(const windrow_wind* wind, windrow_dvec3 anchor, windrow_window_block*
    block) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_wind_window_block(wind, anchor, block);
    return turned<Same>(own_windrow_wind_window_block, same(wind), in<Vector<1>>(anchor), same(block));
}
WINDROW_EXPORT windrow_result windrow_wind_frame_block(const windrow_wind* wind, windrow_dvec3 anchor, const windrow_sampling*
    sampling, windrow_frame_block* block) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_wind_frame_block(wind, anchor, sampling, block);
    return turned<Same>(own_windrow_wind_frame_block, same(wind), in<Vector<1>>(anchor), in_array<Whole>(sampling, 1),
        same(block));
}
