// Made by ./dev schema from the headers and tools/c_kinds.py. Do not edit.
// clang-format off
extern "C" {
windrow_result own_windrow_ambient_settings_init(windrow_ambient_settings* settings, uint32_t struct_size);
windrow_result own_windrow_ambient_wind_block(const windrow_ambient_wind* ambient, windrow_dvec3 anchor, const windrow_sampling*
    sampling, windrow_ambient_block* block);
windrow_result own_windrow_ambient_wind_create(const windrow_ambient_settings* settings, windrow_ambient_wind** ambient);
windrow_result own_windrow_ambient_wind_felt(const windrow_ambient_wind* ambient, windrow_dvec3 position, const windrow_sampling*
    sampling, windrow_vec3* velocity);
double own_windrow_ambient_wind_ground(const windrow_ambient_wind* ambient);
windrow_vec3 own_windrow_ambient_wind_mean(const windrow_ambient_wind* ambient);
double own_windrow_ambient_wind_period(const windrow_ambient_wind* ambient);
windrow_dvec3 own_windrow_ambient_wind_phase(const windrow_ambient_wind* ambient);
float own_windrow_ambient_wind_profile_at(const windrow_ambient_wind* ambient, double height);
windrow_result own_windrow_ambient_wind_set_ground(windrow_ambient_wind* ambient, double height);
windrow_result own_windrow_ambient_wind_set_mean(windrow_ambient_wind* ambient, windrow_vec3 mean);
windrow_result own_windrow_ambient_wind_set_phase(windrow_ambient_wind* ambient, windrow_dvec3 phase);
windrow_result own_windrow_ambient_wind_velocity(const windrow_ambient_wind* ambient, windrow_dvec3 position, windrow_vec3*
    velocity);
windrow_result own_windrow_belt_drag_init(windrow_belt_drag* belt, uint32_t struct_size);
windrow_result own_windrow_bend_angle(const windrow_drag* drag, float speed, float* angle);
windrow_result own_windrow_blade_settings_init(windrow_blade_settings* settings, uint32_t struct_size);
windrow_result own_windrow_blades_create(const windrow_blade_settings* settings, windrow_blades** blades);
float own_windrow_blades_length(const windrow_blades* blades, windrow_plant_key key);
windrow_vec3 own_windrow_blades_load(const windrow_blades* blades, windrow_plant_key key, windrow_vec3 wind);
windrow_result own_windrow_blades_loads(const windrow_blades* blades, uint64_t count, const windrow_plant_key* keys, const
    windrow_vec4* winds, windrow_vec4* loads, const windrow_parallel_for* parallel_for);
windrow_result own_windrow_blades_vertex(const windrow_blades* blades, windrow_plant_key key, windrow_vec3 load, float h, float
    side, windrow_vec3 view, windrow_plant_vertex* vertex);
windrow_result own_windrow_blades_vertices(const windrow_blades* blades, uint64_t count, const windrow_plant_key* keys, const
    windrow_vec4* roots, const windrow_vec4* loads, uint64_t rows, const float* heights, windrow_vec3 view, windrow_vec4*
    positions, windrow_vec4* normals, const windrow_parallel_for* parallel_for);
windrow_boundaries own_windrow_boundaries_open_over_floor(void);
windrow_result own_windrow_box_init(windrow_box* box, uint32_t struct_size);
windrow_result own_windrow_canopy_init(windrow_canopy* canopy, uint32_t struct_size);
windrow_result own_windrow_cascade_advance(windrow_cascade* cascade, double duration, const windrow_pose* body);
windrow_result own_windrow_cascade_at(const windrow_cascade* cascade, double height, windrow_pose* pose);
windrow_result own_windrow_cascade_create(const windrow_cascade_config* config, const windrow_pose* body, windrow_cascade**
    cascade);
windrow_result own_windrow_cascade_move(windrow_cascade* cascade, windrow_dvec3 offset);
windrow_result own_windrow_cascade_previous_at(const windrow_cascade* cascade, double height, windrow_pose* pose);
windrow_result own_windrow_cascade_previous_shader_poses(windrow_cascade* cascade, windrow_dvec3 anchor, const
    windrow_pose_block** poses, uint64_t* count);
windrow_result own_windrow_cascade_reset(windrow_cascade* cascade, const windrow_pose* body);
windrow_result own_windrow_cascade_shader_poses(windrow_cascade* cascade, windrow_dvec3 anchor, const windrow_pose_block** poses,
    uint64_t* count);
windrow_result own_windrow_cauchy_number(const windrow_drag* drag, double speed, double* number);
windrow_result own_windrow_config_init(windrow_config* config, uint32_t struct_size);
windrow_result own_windrow_config_validate(const windrow_config* config);
windrow_result own_windrow_debug_view_init(windrow_debug_view* view, uint32_t struct_size);
windrow_result own_windrow_diagnostics_init(windrow_diagnostics* diagnostics, uint32_t struct_size);
windrow_result own_windrow_diffuse(windrow_workspace* work, const windrow_vec4* field, float viscosity, float dt, windrow_vec4*
    result, windrow_diffusion_method* method, uint64_t count);
windrow_result own_windrow_directional_motor_init(windrow_directional_motor* motor, uint32_t struct_size);
windrow_result own_windrow_drag_block_of(const windrow_drag* drag, windrow_drag_block* block);
windrow_result own_windrow_drag_force_init(windrow_drag_force* force, uint32_t struct_size);
windrow_result own_windrow_drag_init(windrow_drag* drag, uint32_t struct_size);
windrow_result own_windrow_drag_of(windrow_plant plant, windrow_drag* drag);
windrow_result own_windrow_drag_validate(const windrow_drag* drag);
windrow_result own_windrow_flutter_step_make(const windrow_flutter_class* flutter, double time, double duration,
    windrow_flutter_block* block);
float own_windrow_folded_rigidity(float young, float width, float thickness, float depth);
windrow_result own_windrow_ground_advance(windrow_ground* ground, const windrow_ground_step* step, const windrow_vec2* wind_leans,
    uint64_t count);
windrow_result own_windrow_ground_at(const windrow_ground* ground, windrow_dvec3 position, windrow_ground_sample* sample);
windrow_result own_windrow_ground_block_of(const windrow_ground* ground, windrow_dvec3 anchor, windrow_ground_block* block);
windrow_result own_windrow_ground_config_init(windrow_ground_config* config, uint32_t struct_size);
windrow_result own_windrow_ground_create(const windrow_ground_config* config, const windrow_parallel_for* parallel_for,
    windrow_ground** ground);
windrow_result own_windrow_ground_follow(windrow_ground* ground, windrow_dvec3 point);
windrow_dvec2 own_windrow_ground_next_centre(const windrow_ground* ground, windrow_ivec2 slot);
windrow_result own_windrow_ground_previous_at(const windrow_ground* ground, windrow_dvec3 position, windrow_ground_sample*
    sample);
windrow_result own_windrow_ground_shift_origin(windrow_ground* ground, windrow_dvec3 offset);
windrow_result own_windrow_ground_step_init(windrow_ground_step* step, uint32_t struct_size);
windrow_result own_windrow_gusts_init(windrow_gusts* gusts, uint32_t struct_size);
windrow_result own_windrow_height_map_create(windrow_ivec2 corners, float spacing, const float* heights, uint64_t count,
    windrow_height_map** map);
windrow_result own_windrow_height_map_create_with_holes(windrow_ivec2 corners, float spacing, const float* heights, uint64_t
    count, windrow_ivec2 cells, const uint8_t* open, uint64_t cell_count, windrow_height_map** map);
float own_windrow_height_map_height(const windrow_height_map* map, windrow_vec2 place);
windrow_vec3 own_windrow_height_map_normal(const windrow_height_map* map, windrow_vec2 place);
windrow_result own_windrow_jet_motor_init(windrow_jet_motor* motor, uint32_t struct_size);
windrow_result own_windrow_log_profile_init(windrow_log_profile* profile, uint32_t struct_size);
windrow_result own_windrow_mesh_create(const windrow_vec3* vertices, uint64_t vertex_count, const uint32_t* indices, uint64_t
    triangle_count, windrow_mesh** mesh);
float own_windrow_mesh_distance(const windrow_mesh* mesh, windrow_vec3 point);
windrow_result own_windrow_obstacle_force_init(windrow_obstacle_force* force, uint32_t struct_size);
windrow_result own_windrow_obstacle_init(windrow_obstacle* obstacle, uint32_t struct_size);
windrow_result own_windrow_omni_motor_init(windrow_omni_motor* motor, uint32_t struct_size);
windrow_plant_key own_windrow_place_key(float x, float z);
windrow_result own_windrow_plant_drag_init(windrow_plant_drag* plant, uint32_t struct_size);
float own_windrow_plant_yaw(windrow_plant_key key);
windrow_result own_windrow_pressure_motor_init(windrow_pressure_motor* motor, uint32_t struct_size);
windrow_result own_windrow_query_init(windrow_query* query, uint32_t struct_size);
float own_windrow_rectangle_rigidity(float young, float width, float thickness);
float own_windrow_rod_rigidity(float young, float diameter);
windrow_result own_windrow_roughness_init(windrow_roughness* roughness, uint32_t struct_size);
windrow_result own_windrow_roughness_map_init(windrow_roughness_map* map, uint32_t struct_size);
windrow_result own_windrow_rows_init(windrow_rows* rows, uint32_t struct_size);
windrow_result own_windrow_sampling_init(windrow_sampling* sampling, uint32_t struct_size);
windrow_result own_windrow_sampling_validate(const windrow_sampling* sampling);
windrow_result own_windrow_scene_step(windrow_scene* scene, windrow_diagnostics* diagnostics);
windrow_shape own_windrow_shape_plate(windrow_vec2 half_size);
windrow_result own_windrow_shell_settings_init(windrow_shell_settings* settings, uint32_t struct_size);
windrow_vec3 own_windrow_shells_bent(const windrow_shells* shells, windrow_vec3 position, windrow_vec3 normal, float h, float map,
    windrow_vec3 load);
windrow_result own_windrow_shells_bent_many(const windrow_shells* shells, const windrow_skin* skin, float h, const windrow_vec4*
    loads, windrow_vec4* positions, const windrow_parallel_for* parallel_for);
windrow_result own_windrow_shells_create(const windrow_shell_settings* settings, windrow_shells** shells);
windrow_vec3 own_windrow_shells_load(const windrow_shells* shells, windrow_vec3 normal, float map, windrow_vec3 wind);
windrow_result own_windrow_shells_loads_many(const windrow_shells* shells, const windrow_skin* skin, const windrow_vec4* winds,
    windrow_vec4* loads, const windrow_parallel_for* parallel_for);
windrow_vec3 own_windrow_shells_translated(const windrow_shells* shells, windrow_vec3 position, windrow_vec3 normal, float h,
    float map, windrow_vec3 direction);
windrow_result own_windrow_shells_translated_many(const windrow_shells* shells, const windrow_skin* skin, float h, const
    windrow_vec4* directions, windrow_vec4* positions, const windrow_parallel_for* parallel_for);
windrow_result own_windrow_tracer_blow(windrow_tracer* tracer, windrow_dvec3 point, float radius);
windrow_result own_windrow_tree_classes_init(windrow_tree_classes* classes, uint32_t struct_size);
windrow_result own_windrow_tree_create(const windrow_tree_classes* classes, windrow_tree** tree);
windrow_result own_windrow_tree_vertex(const windrow_tree* tree, const windrow_tree_part* trunk, const windrow_tree_part* branch,
    const windrow_tree_part* leaf, windrow_vec3 wind, const windrow_plant_vertex* rest, windrow_plant_vertex* bent);
windrow_result own_windrow_tree_vertices(const windrow_tree* tree, uint64_t part_count, const windrow_tree_part* parts, const
    windrow_vec4* winds, uint64_t count, const windrow_vec4* rest_positions, const windrow_vec4* rest_normals, const
    windrow_tree_bearers* bearers, windrow_vec4* positions, windrow_vec4* normals, const windrow_parallel_for* parallel_for);
float own_windrow_tube_rigidity(float young, float outer_diameter, float inner_diameter);
windrow_result own_windrow_uniform_gust_init(windrow_uniform_gust* gust, uint32_t struct_size);
windrow_result own_windrow_uniform_gust_velocity(const windrow_uniform_gust* gust, double time, windrow_vec3* velocity);
windrow_result own_windrow_vdb_film_init(windrow_vdb_film* film, uint32_t struct_size);
windrow_result own_windrow_vdb_write_film(const windrow_wind* wind, const windrow_vdb_film* film, const char* path, const
    windrow_vdb_options* options);
windrow_result own_windrow_vortex_motor_init(windrow_vortex_motor* motor, uint32_t struct_size);
windrow_result own_windrow_voxels_create(windrow_ivec3 cells, const uint8_t* closed, uint64_t count, windrow_voxels** voxels);
windrow_result own_windrow_vulkan_frame_init(windrow_vulkan_frame* frame, uint32_t struct_size);
windrow_result own_windrow_vulkan_ground_block(const windrow_vulkan_ground* ground, windrow_dvec3 anchor, windrow_ground_block*
    block);
windrow_result own_windrow_vulkan_ground_create(const windrow_vulkan_host* host, const windrow_ground_config* config,
    windrow_texel texel, windrow_vulkan_ground** ground);
windrow_result own_windrow_vulkan_ground_follow(windrow_vulkan_ground* ground, windrow_dvec3 point);
windrow_result own_windrow_vulkan_ground_next_place(const windrow_vulkan_ground* ground, windrow_dvec3 anchor,
    windrow_ground_place_block* place);
windrow_result own_windrow_vulkan_ground_record(windrow_vulkan_ground* ground, void* commands, const windrow_ground_step* step,
    windrow_wind_leans leans);
windrow_result own_windrow_vulkan_ground_shift_origin(windrow_vulkan_ground* ground, windrow_dvec3 offset);
windrow_result own_windrow_vulkan_sampler_info(const windrow_boundaries* boundaries, void* sampler_info);
windrow_result own_windrow_vulkan_settings_init(windrow_vulkan_settings* settings, uint32_t struct_size);
windrow_result own_windrow_vulkan_wind_create(const windrow_vulkan_host* host, const windrow_config* config, const
    windrow_vulkan_settings* settings, windrow_wind** wind);
windrow_result own_windrow_vulkan_wind_create_inside(const windrow_vulkan_host* host, const windrow_config* config, const
    windrow_vulkan_settings* settings, const windrow_wind* outer, windrow_wind** wind);
windrow_result own_windrow_vulkan_wind_load(const windrow_vulkan_host* host, const void* bytes, uint64_t size, const
    windrow_vulkan_settings* settings, windrow_wind** wind);
windrow_result own_windrow_vulkan_wind_load_inside(const windrow_vulkan_host* host, const void* bytes, uint64_t size, const
    windrow_vulkan_settings* settings, const windrow_wind* outer, windrow_wind** wind);
windrow_result own_windrow_vulkan_wind_record(windrow_wind* wind, void* commands, const windrow_vulkan_frame* frame,
    windrow_advance* advance, windrow_diagnostics* last);
windrow_result own_windrow_vulkan_wind_record_step(windrow_wind* wind, void* commands, const windrow_vulkan_frame* frame,
    windrow_diagnostics* diagnostics);
windrow_result own_windrow_vulkan_wind_reported(windrow_wind* wind, windrow_diagnostics* diagnostics);
windrow_result own_windrow_vulkan_wind_required_bytes(const windrow_vulkan_host* host, const windrow_config* config, const
    windrow_vulkan_settings* settings, uint64_t* memory, uint64_t* reserved);
windrow_result own_windrow_vulkan_wind_required_bytes_inside(const windrow_vulkan_host* host, const windrow_config* config, const
    windrow_vulkan_settings* settings, const windrow_wind* outer, uint64_t* memory, uint64_t* reserved);
windrow_result own_windrow_wake_motor_init(windrow_wake_motor* motor, uint32_t struct_size);
windrow_result own_windrow_wind_add_belt_drag(windrow_wind* wind, const windrow_belt_drag* belt, windrow_drag_id* id);
windrow_result own_windrow_wind_add_directional(windrow_wind* wind, const windrow_directional_motor* motor, windrow_motor_id* id);
windrow_result own_windrow_wind_add_jet(windrow_wind* wind, const windrow_jet_motor* motor, windrow_motor_id* id);
windrow_result own_windrow_wind_add_obstacle(windrow_wind* wind, const windrow_obstacle* obstacle, windrow_obstacle_id* id);
windrow_result own_windrow_wind_add_omni(windrow_wind* wind, const windrow_omni_motor* motor, windrow_motor_id* id);
windrow_result own_windrow_wind_add_plant_drag(windrow_wind* wind, const windrow_plant_drag* plant, windrow_drag_id* id);
windrow_result own_windrow_wind_add_plants(windrow_wind* wind, const windrow_plant_drag* plants, uint64_t count, windrow_drag_id*
    ids);
windrow_result own_windrow_wind_add_pressure(windrow_wind* wind, const windrow_pressure_motor* motor, windrow_motor_id* id);
windrow_result own_windrow_wind_add_vortex(windrow_wind* wind, const windrow_vortex_motor* motor, windrow_motor_id* id);
windrow_result own_windrow_wind_add_wake(windrow_wind* wind, const windrow_wake_motor* motor, windrow_motor_id* id);
windrow_result own_windrow_wind_advance(windrow_wind* wind, double dt, windrow_advance* advance, windrow_diagnostics* last);
windrow_vec3 own_windrow_wind_ambient(const windrow_wind* wind);
windrow_result own_windrow_wind_box(const windrow_wind* wind, windrow_box* box);
windrow_result own_windrow_wind_config(windrow_wind* wind, windrow_config* config);
windrow_result own_windrow_wind_create(const windrow_config* config, windrow_wind** wind);
windrow_result own_windrow_wind_create_inside(const windrow_config* config, const windrow_wind* outer, windrow_wind** wind);
windrow_result own_windrow_wind_debug_lines(const windrow_wind* wind, const windrow_debug_view* view, windrow_debug_draw draw,
    void* user);
windrow_result own_windrow_wind_drag_force_on(const windrow_wind* wind, windrow_drag_id id, windrow_drag_force* force);
windrow_result own_windrow_wind_felt(const windrow_wind* wind, windrow_dvec3 position, const windrow_sampling* sampling,
    windrow_vec3* velocity);
windrow_result own_windrow_wind_follow(windrow_wind* wind, windrow_dvec3 point);
windrow_result own_windrow_wind_force_on(const windrow_wind* wind, windrow_obstacle_id id, windrow_obstacle_force* force);
windrow_result own_windrow_wind_frame_block(const windrow_wind* wind, windrow_dvec3 anchor, const windrow_sampling* sampling,
    windrow_frame_block* block);
windrow_result own_windrow_wind_get_belt_drag(const windrow_wind* wind, windrow_drag_id id, windrow_belt_drag* belt);
windrow_result own_windrow_wind_get_directional(const windrow_wind* wind, windrow_motor_id id, windrow_directional_motor* motor);
windrow_result own_windrow_wind_get_jet(const windrow_wind* wind, windrow_motor_id id, windrow_jet_motor* motor);
windrow_result own_windrow_wind_get_obstacle(const windrow_wind* wind, windrow_obstacle_id id, windrow_obstacle* obstacle);
windrow_result own_windrow_wind_get_omni(const windrow_wind* wind, windrow_motor_id id, windrow_omni_motor* motor);
windrow_result own_windrow_wind_get_plant_drag(const windrow_wind* wind, windrow_drag_id id, windrow_plant_drag* plant);
windrow_result own_windrow_wind_get_pressure(const windrow_wind* wind, windrow_motor_id id, windrow_pressure_motor* motor);
windrow_result own_windrow_wind_get_vortex(const windrow_wind* wind, windrow_motor_id id, windrow_vortex_motor* motor);
windrow_result own_windrow_wind_get_wake(const windrow_wind* wind, windrow_motor_id id, windrow_wake_motor* motor);
windrow_result own_windrow_wind_move_motor(windrow_wind* wind, windrow_motor_id id, windrow_dvec3 position);
windrow_result own_windrow_wind_move_obstacle(windrow_wind* wind, windrow_obstacle_id id, windrow_dvec3 position, const
    windrow_quat* orientation, const windrow_vec3* spin);
windrow_dvec3 own_windrow_wind_origin(const windrow_wind* wind);
windrow_result own_windrow_wind_sample(const windrow_wind* wind, const windrow_query* query);
windrow_result own_windrow_wind_set_ambient(windrow_wind* wind, windrow_vec3 ambient);
windrow_result own_windrow_wind_set_belt_drag(windrow_wind* wind, windrow_drag_id id, const windrow_belt_drag* belt);
windrow_result own_windrow_wind_set_boundaries(windrow_wind* wind, const windrow_boundaries* boundaries);
windrow_result own_windrow_wind_set_directional(windrow_wind* wind, windrow_motor_id id, const windrow_directional_motor* motor);
windrow_result own_windrow_wind_set_floor(windrow_wind* wind, double height);
windrow_result own_windrow_wind_set_gusts(windrow_wind* wind, const windrow_gusts* gusts);
windrow_result own_windrow_wind_set_jet(windrow_wind* wind, windrow_motor_id id, const windrow_jet_motor* motor);
windrow_result own_windrow_wind_set_obstacle(windrow_wind* wind, windrow_obstacle_id id, const windrow_obstacle* obstacle);
windrow_result own_windrow_wind_set_omni(windrow_wind* wind, windrow_motor_id id, const windrow_omni_motor* motor);
windrow_result own_windrow_wind_set_plant_drag(windrow_wind* wind, windrow_drag_id id, const windrow_plant_drag* plant);
windrow_result own_windrow_wind_set_pressure(windrow_wind* wind, windrow_motor_id id, const windrow_pressure_motor* motor);
windrow_result own_windrow_wind_set_velocity(windrow_wind* wind, windrow_velocity_at velocity_at, void* user);
windrow_result own_windrow_wind_set_vortex(windrow_wind* wind, windrow_motor_id id, const windrow_vortex_motor* motor);
windrow_result own_windrow_wind_set_wake(windrow_wind* wind, windrow_motor_id id, const windrow_wake_motor* motor);
windrow_result own_windrow_wind_shift_origin(windrow_wind* wind, windrow_dvec3 offset);
windrow_result own_windrow_wind_step(windrow_wind* wind, double dt, windrow_diagnostics* diagnostics);
windrow_result own_windrow_wind_velocity(const windrow_wind* wind, windrow_dvec3 position, windrow_vec3* velocity);
windrow_result own_windrow_wind_window_block(const windrow_wind* wind, windrow_dvec3 anchor, windrow_window_block* block);
windrow_result own_windrow_workspace_create(const windrow_config* config, windrow_workspace** work);
windrow_result own_windrow_workspace_impulse_on(const windrow_workspace* work, uint64_t obstacle, windrow_vec3* impulse);
windrow_result own_windrow_workspace_set_ambient(windrow_workspace* work, windrow_vec3 ambient);
windrow_result own_windrow_workspace_set_boundaries(windrow_workspace* work, const windrow_boundaries* boundaries);
windrow_result own_windrow_workspace_set_obstacles(windrow_workspace* work, const windrow_obstacle* obstacles, const windrow_vec3*
    velocities, const windrow_vec3* spins, uint64_t count);
}
