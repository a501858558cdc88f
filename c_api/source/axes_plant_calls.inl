// Made by ./dev schema from the headers and tools/c_kinds.py. Do not edit.
// clang-format off
// Each call that converts: what goes in, the call itself, what comes out.

WINDROW_EXPORT windrow_result windrow_flutter_step_make(const windrow_flutter_class* flutter, double time, double duration,
    windrow_flutter_block* block) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_flutter_step_make(flutter, time, duration, block);
    return turned<Same>(own_windrow_flutter_step_make, in_array<Whole>(flutter, 1), same(time), same(duration), same(block));
}
WINDROW_EXPORT windrow_result windrow_cascade_create(const windrow_cascade_config* config, const windrow_pose* body,
    windrow_cascade** cascade) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_cascade_create(config, body, cascade);
    return turned<Same>(own_windrow_cascade_create, same(config), in_array<Whole>(body, 1), same(cascade));
}
WINDROW_EXPORT windrow_result windrow_cascade_advance(windrow_cascade* cascade, double duration, const windrow_pose* body) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_cascade_advance(cascade, duration, body);
    return turned<Same>(own_windrow_cascade_advance, same(cascade), same(duration), in_array<Whole>(body, 1));
}
WINDROW_EXPORT windrow_result windrow_cascade_reset(windrow_cascade* cascade, const windrow_pose* body) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_cascade_reset(cascade, body);
    return turned<Same>(own_windrow_cascade_reset, same(cascade), in_array<Whole>(body, 1));
}
WINDROW_EXPORT windrow_result windrow_cascade_move(windrow_cascade* cascade, windrow_dvec3 offset) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_cascade_move(cascade, offset);
    return turned<Same>(own_windrow_cascade_move, same(cascade), in<Vector<1>>(offset));
}
WINDROW_EXPORT windrow_result windrow_cascade_at(const windrow_cascade* cascade, double height, windrow_pose* pose) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_cascade_at(cascade, height, pose);
    return turned<Same>(own_windrow_cascade_at, same(cascade), same(height), out_array<Whole>(pose, 1));
}
WINDROW_EXPORT windrow_result windrow_cascade_previous_at(const windrow_cascade* cascade, double height, windrow_pose* pose) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_cascade_previous_at(cascade, height, pose);
    return turned<Same>(own_windrow_cascade_previous_at, same(cascade), same(height), out_array<Whole>(pose, 1));
}
WINDROW_EXPORT windrow_result windrow_cascade_shader_poses(windrow_cascade* cascade, windrow_dvec3 anchor, const
    windrow_pose_block** poses, uint64_t* count) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_cascade_shader_poses(cascade, anchor, poses, count);
    return turned<Same>(own_windrow_cascade_shader_poses, same(cascade), in<Vector<1>>(anchor), same(poses), same(count));
}
WINDROW_EXPORT windrow_result windrow_cascade_previous_shader_poses(windrow_cascade* cascade, windrow_dvec3 anchor, const
    windrow_pose_block** poses, uint64_t* count) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_cascade_previous_shader_poses(cascade, anchor, poses, count);
    return turned<Same>(own_windrow_cascade_previous_shader_poses, same(cascade), in<Vector<1>>(anchor), same(poses),
        same(count));
}
WINDROW_EXPORT windrow_result windrow_ground_config_init(windrow_ground_config* config, uint32_t struct_size) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_ground_config_init(config, struct_size);
    return turned<Same>(own_windrow_ground_config_init, out_array<Whole>(config, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_ground_step_init(windrow_ground_step* step, uint32_t struct_size) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_ground_step_init(step, struct_size);
    return turned<Same>(own_windrow_ground_step_init, out_array<Whole>(step, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_ground_create(const windrow_ground_config* config, const windrow_parallel_for* parallel_for,
    windrow_ground** ground) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_ground_create(config, parallel_for, ground);
    return turned<Same>(own_windrow_ground_create, in_array<Whole>(config, 1), same(parallel_for), same(ground));
}
WINDROW_EXPORT windrow_result windrow_ground_follow(windrow_ground* ground, windrow_dvec3 point) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_ground_follow(ground, point);
    return turned<Same>(own_windrow_ground_follow, same(ground), in<Vector<1>>(point));
}
WINDROW_EXPORT windrow_result windrow_ground_shift_origin(windrow_ground* ground, windrow_dvec3 offset) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_ground_shift_origin(ground, offset);
    return turned<Same>(own_windrow_ground_shift_origin, same(ground), in<Vector<1>>(offset));
}
WINDROW_EXPORT windrow_result windrow_ground_advance(windrow_ground* ground, const windrow_ground_step* step, const windrow_vec2*
    wind_leans, uint64_t count) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_ground_advance(ground, step, wind_leans, count);
    return turned<Same>(own_windrow_ground_advance, same(ground), in_array<Whole>(step, 1), same(wind_leans), same(count));
}
WINDROW_EXPORT windrow_dvec2 windrow_ground_next_centre(const windrow_ground* ground, windrow_ivec2 slot) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_ground_next_centre(ground, slot);
    return turned<Level<1>>(own_windrow_ground_next_centre, same(ground), same(slot));
}
WINDROW_EXPORT windrow_result windrow_ground_at(const windrow_ground* ground, windrow_dvec3 position, windrow_ground_sample*
    sample) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_ground_at(ground, position, sample);
    return turned<Same>(own_windrow_ground_at, same(ground), in<Vector<1>>(position), out_array<Whole>(sample, 1));
}
WINDROW_EXPORT windrow_result windrow_ground_previous_at(const windrow_ground* ground, windrow_dvec3 position,
    windrow_ground_sample* sample) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_ground_previous_at(ground, position, sample);
    return turned<Same>(own_windrow_ground_previous_at, same(ground), in<Vector<1>>(position), out_array<Whole>(sample, 1));
}
WINDROW_EXPORT windrow_result windrow_ground_block_of(const windrow_ground* ground, windrow_dvec3 anchor, windrow_ground_block*
    block) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_ground_block_of(ground, anchor, block);
    return turned<Same>(own_windrow_ground_block_of, same(ground), in<Vector<1>>(anchor), same(block));
}
WINDROW_EXPORT windrow_result windrow_drag_init(windrow_drag* drag, uint32_t struct_size) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_drag_init(drag, struct_size);
    return turned<Same>(own_windrow_drag_init, out_array<Whole>(drag, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_drag_of(windrow_plant plant, windrow_drag* drag) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_drag_of(plant, drag);
    return turned<Same>(own_windrow_drag_of, same(plant), out_array<Whole>(drag, 1));
}
WINDROW_EXPORT windrow_result windrow_drag_validate(const windrow_drag* drag) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_drag_validate(drag);
    return turned<Same>(own_windrow_drag_validate, in_array<Whole>(drag, 1));
}
WINDROW_EXPORT windrow_result windrow_drag_block_of(const windrow_drag* drag, windrow_drag_block* block) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_drag_block_of(drag, block);
    return turned<Same>(own_windrow_drag_block_of, in_array<Whole>(drag, 1), same(block));
}
WINDROW_EXPORT windrow_result windrow_cauchy_number(const windrow_drag* drag, double speed, double* number) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_cauchy_number(drag, speed, number);
    return turned<Same>(own_windrow_cauchy_number, in_array<Whole>(drag, 1), in<Number<1>>(speed), same(number));
}
WINDROW_EXPORT windrow_result windrow_bend_angle(const windrow_drag* drag, float speed, float* angle) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_bend_angle(drag, speed, angle);
    return turned<Same>(own_windrow_bend_angle, in_array<Whole>(drag, 1), in<Number<1>>(speed), same(angle));
}
WINDROW_EXPORT float windrow_rectangle_rigidity(float young, float width, float thickness) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_rectangle_rigidity(young, width, thickness);
    return turned<Number<3>>(own_windrow_rectangle_rigidity, in<Number<-1>>(young), in<Number<1>>(width),
        in<Number<1>>(thickness));
}
WINDROW_EXPORT float windrow_folded_rigidity(float young, float width, float thickness, float depth) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_folded_rigidity(young, width, thickness, depth);
    return turned<Number<3>>(own_windrow_folded_rigidity, in<Number<-1>>(young), in<Number<1>>(width), in<Number<1>>(thickness),
        in<Number<1>>(depth));
}
WINDROW_EXPORT float windrow_rod_rigidity(float young, float diameter) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_rod_rigidity(young, diameter);
    return turned<Number<3>>(own_windrow_rod_rigidity, in<Number<-1>>(young), in<Number<1>>(diameter));
}
WINDROW_EXPORT float windrow_tube_rigidity(float young, float outer_diameter, float inner_diameter) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_tube_rigidity(young, outer_diameter, inner_diameter);
    return turned<Number<3>>(own_windrow_tube_rigidity, in<Number<-1>>(young), in<Number<1>>(outer_diameter),
        in<Number<1>>(inner_diameter));
}
WINDROW_EXPORT float windrow_plant_yaw(windrow_plant_key key) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_plant_yaw(key);
    return turned<LevelSign>(own_windrow_plant_yaw, same(key));
}
WINDROW_EXPORT windrow_result windrow_blade_settings_init(windrow_blade_settings* settings, uint32_t struct_size) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_blade_settings_init(settings, struct_size);
    return turned<Same>(own_windrow_blade_settings_init, out_array<Whole>(settings, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_blades_create(const windrow_blade_settings* settings, windrow_blades** blades) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_blades_create(settings, blades);
    return turned<Same>(own_windrow_blades_create, in_array<Whole>(settings, 1), same(blades));
}
WINDROW_EXPORT float windrow_blades_length(const windrow_blades* blades, windrow_plant_key key) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_blades_length(blades, key);
    return turned<Number<1>>(own_windrow_blades_length, same(blades), same(key));
}
WINDROW_EXPORT windrow_vec3 windrow_blades_load(const windrow_blades* blades, windrow_plant_key key, windrow_vec3 wind) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_blades_load(blades, key, wind);
    return turned<Vector<0>>(own_windrow_blades_load, same(blades), same(key), in<Vector<1>>(wind));
}
WINDROW_EXPORT windrow_result windrow_blades_vertex(const windrow_blades* blades, windrow_plant_key key, windrow_vec3 load, float
    h, float side, windrow_vec3 view, windrow_plant_vertex* vertex) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_blades_vertex(blades, key, load, h, side, view, vertex);
    return turned<Same>(own_windrow_blades_vertex, same(blades), same(key), in<Vector<0>>(load), same(h), same(side),
        in<Vector<0>>(view), out_array<Whole>(vertex, 1));
}
WINDROW_EXPORT windrow_result windrow_blades_loads(const windrow_blades* blades, uint64_t count, const windrow_plant_key* keys,
    const windrow_vec4* winds, windrow_vec4* loads, const windrow_parallel_for* parallel_for) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_blades_loads(blades, count, keys, winds, loads, parallel_for);
    return turned<Same>(own_windrow_blades_loads, same(blades), same(count), same(keys), in_array<Vector<1>>(winds, count),
        out_array<Vector<0>>(loads, count), same(parallel_for));
}
WINDROW_EXPORT windrow_result windrow_blades_vertices(const windrow_blades* blades, uint64_t count, const windrow_plant_key* keys,
    const windrow_vec4* roots, const windrow_vec4* loads, uint64_t rows, const float* heights, windrow_vec3 view, windrow_vec4*
    positions, windrow_vec4* normals, const windrow_parallel_for* parallel_for) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_blades_vertices(blades, count, keys, roots, loads, rows, heights, view, positions, normals, parallel_for);
    return turned<Same>(own_windrow_blades_vertices, same(blades), same(count), same(keys), in_array<Vector<1>>(roots, count),
        in_array<Vector<0>>(loads, count), same(rows), same(heights), in<Vector<0>>(view), out_array<Vector<1>>(positions, 2 *
        count * rows), out_array<Vector<0>>(normals, 2 * count * rows), same(parallel_for));
}
WINDROW_EXPORT windrow_result windrow_shell_settings_init(windrow_shell_settings* settings, uint32_t struct_size) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_shell_settings_init(settings, struct_size);
    return turned<Same>(own_windrow_shell_settings_init, out_array<Whole>(settings, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_shells_create(const windrow_shell_settings* settings, windrow_shells** shells) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_shells_create(settings, shells);
    return turned<Same>(own_windrow_shells_create, in_array<Whole>(settings, 1), same(shells));
}
WINDROW_EXPORT windrow_vec3 windrow_shells_load(const windrow_shells* shells, windrow_vec3 normal, float map, windrow_vec3 wind) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_shells_load(shells, normal, map, wind);
    return turned<Vector<0>>(own_windrow_shells_load, same(shells), in<Vector<0>>(normal), same(map), in<Vector<1>>(wind));
}
WINDROW_EXPORT windrow_vec3 windrow_shells_bent(const windrow_shells* shells, windrow_vec3 position, windrow_vec3 normal, float h,
    float map, windrow_vec3 load) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_shells_bent(shells, position, normal, h, map, load);
    return turned<Vector<1>>(own_windrow_shells_bent, same(shells), in<Vector<1>>(position), in<Vector<0>>(normal), same(h),
        same(map), in<Vector<0>>(load));
}
WINDROW_EXPORT windrow_vec3 windrow_shells_translated(const windrow_shells* shells, windrow_vec3 position, windrow_vec3 normal,
    float h, float map, windrow_vec3 direction) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_shells_translated(shells, position, normal, h, map, direction);
    return turned<Vector<1>>(own_windrow_shells_translated, same(shells), in<Vector<1>>(position), in<Vector<0>>(normal), same(h),
        same(map), in<Vector<0>>(direction));
}
WINDROW_EXPORT windrow_result windrow_shells_loads_many(const windrow_shells* shells, const windrow_skin* skin, const
    windrow_vec4* winds, windrow_vec4* loads, const windrow_parallel_for* parallel_for) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_shells_loads_many(shells, skin, winds, loads, parallel_for);
    return turned<Same>(own_windrow_shells_loads_many, same(shells), in_array<Whole>(skin, 1), in_array<Vector<1>>(winds,
        count_of(skin)), out_array<Vector<0>>(loads, count_of(skin)), same(parallel_for));
}
WINDROW_EXPORT windrow_result windrow_shells_bent_many(const windrow_shells* shells, const windrow_skin* skin, float h, const
    windrow_vec4* loads, windrow_vec4* positions, const windrow_parallel_for* parallel_for) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_shells_bent_many(shells, skin, h, loads, positions, parallel_for);
    return turned<Same>(own_windrow_shells_bent_many, same(shells), in_array<Whole>(skin, 1), same(h), in_array<Vector<0>>(loads,
        count_of(skin)), out_array<Vector<1>>(positions, count_of(skin)), same(parallel_for));
}
WINDROW_EXPORT windrow_result windrow_shells_translated_many(const windrow_shells* shells, const windrow_skin* skin, float h,
    const windrow_vec4* directions, windrow_vec4* positions, const windrow_parallel_for* parallel_for) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_shells_translated_many(shells, skin, h, directions, positions, parallel_for);
    return turned<Same>(own_windrow_shells_translated_many, same(shells), in_array<Whole>(skin, 1), same(h),
        in_array<Vector<0>>(directions, count_of(skin)), out_array<Vector<1>>(positions, count_of(skin)), same(parallel_for));
}
WINDROW_EXPORT windrow_result windrow_tree_classes_init(windrow_tree_classes* classes, uint32_t struct_size) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_tree_classes_init(classes, struct_size);
    return turned<Same>(own_windrow_tree_classes_init, out_array<Whole>(classes, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_tree_create(const windrow_tree_classes* classes, windrow_tree** tree) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_tree_create(classes, tree);
    return turned<Same>(own_windrow_tree_create, in_array<Whole>(classes, 1), same(tree));
}
WINDROW_EXPORT windrow_result windrow_tree_vertex(const windrow_tree* tree, const windrow_tree_part* trunk, const
    windrow_tree_part* branch, const windrow_tree_part* leaf, windrow_vec3 wind, const windrow_plant_vertex* rest,
    windrow_plant_vertex* bent) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_tree_vertex(tree, trunk, branch, leaf, wind, rest, bent);
    return turned<Same>(own_windrow_tree_vertex, same(tree), in_array<Whole>(trunk, 1), in_array<Whole>(branch, 1),
        in_array<Whole>(leaf, 1), in<Vector<1>>(wind), in_array<Whole>(rest, 1), out_array<Whole>(bent, 1));
}
WINDROW_EXPORT windrow_result windrow_tree_vertices(const windrow_tree* tree, uint64_t part_count, const windrow_tree_part* parts,
    const windrow_vec4* winds, uint64_t count, const windrow_vec4* rest_positions, const windrow_vec4* rest_normals, const
    windrow_tree_bearers* bearers, windrow_vec4* positions, windrow_vec4* normals, const windrow_parallel_for* parallel_for) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_tree_vertices(tree, part_count, parts, winds, count, rest_positions, rest_normals, bearers, positions, normals, parallel_for);
    return turned<Same>(own_windrow_tree_vertices, same(tree), same(part_count), in_array<Whole>(parts, part_count),
        in_array<Vector<1>>(winds, part_count), same(count), in_array<Vector<1>>(rest_positions, count),
        in_array<Vector<0>>(rest_normals, count), same(bearers), out_array<Vector<1>>(positions, count),
        out_array<Vector<0>>(normals, count), same(parallel_for));
}
WINDROW_EXPORT windrow_result windrow_vulkan_ground_create(const windrow_vulkan_host* host, const windrow_ground_config* config,
    windrow_texel texel, windrow_vulkan_ground** ground) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_vulkan_ground_create(host, config, texel, ground);
    return turned<Same>(own_windrow_vulkan_ground_create, same(host), in_array<Whole>(config, 1), same(texel), same(ground));
}
WINDROW_EXPORT windrow_result windrow_vulkan_ground_follow(windrow_vulkan_ground* ground, windrow_dvec3 point) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_vulkan_ground_follow(ground, point);
    return turned<Same>(own_windrow_vulkan_ground_follow, same(ground), in<Vector<1>>(point));
}
WINDROW_EXPORT windrow_result windrow_vulkan_ground_shift_origin(windrow_vulkan_ground* ground, windrow_dvec3 offset) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_vulkan_ground_shift_origin(ground, offset);
    return turned<Same>(own_windrow_vulkan_ground_shift_origin, same(ground), in<Vector<1>>(offset));
}
WINDROW_EXPORT windrow_result windrow_vulkan_ground_record(windrow_vulkan_ground* ground, void* commands, const
    windrow_ground_step* step, windrow_wind_leans leans) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_vulkan_ground_record(ground, commands, step, leans);
    return turned<Same>(own_windrow_vulkan_ground_record, same(ground), same(commands), in_array<Whole>(step, 1), same(leans));
}
WINDROW_EXPORT windrow_result windrow_vulkan_ground_next_place(const windrow_vulkan_ground* ground, windrow_dvec3 anchor,
    windrow_ground_place_block* place) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_vulkan_ground_next_place(ground, anchor, place);
    return turned<Same>(own_windrow_vulkan_ground_next_place, same(ground), in<Vector<1>>(anchor), same(place));
}
WINDROW_EXPORT windrow_result windrow_vulkan_ground_block(const windrow_vulkan_ground* ground, windrow_dvec3 anchor,
    windrow_ground_block* block) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_vulkan_ground_block(ground, anchor, block);
    return turned<Same>(own_windrow_vulkan_ground_block, same(ground), in<Vector<1>>(anchor), same(block));
}
WINDROW_EXPORT windrow_result windrow_vulkan_settings_init(windrow_vulkan_settings* settings, uint32_t struct_size) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_vulkan_settings_init(settings, struct_size);
    return turned<Same>(own_windrow_vulkan_settings_init, out_array<Whole>(settings, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_vulkan_frame_init(windrow_vulkan_frame* frame, uint32_t struct_size) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_vulkan_frame_init(frame, struct_size);
    return turned<Same>(own_windrow_vulkan_frame_init, out_array<Whole>(frame, 1), same(struct_size));
}
WINDROW_EXPORT windrow_result windrow_vulkan_wind_required_bytes(const windrow_vulkan_host* host, const windrow_config* config,
    const windrow_vulkan_settings* settings, uint64_t* memory, uint64_t* reserved) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_vulkan_wind_required_bytes(host, config, settings, memory, reserved);
    return turned<Same>(own_windrow_vulkan_wind_required_bytes, same(host), in_array<Whole>(config, 1), in_array<Whole>(settings,
        1), same(memory), same(reserved));
}
WINDROW_EXPORT windrow_result windrow_vulkan_wind_required_bytes_inside(const windrow_vulkan_host* host, const windrow_config*
    config, const windrow_vulkan_settings* settings, const windrow_wind* outer, uint64_t* memory, uint64_t* reserved) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_vulkan_wind_required_bytes_inside(host, config, settings, outer, memory, reserved);
    return turned<Same>(own_windrow_vulkan_wind_required_bytes_inside, same(host), in_array<Whole>(config, 1),
        in_array<Whole>(settings, 1), same(outer), same(memory), same(reserved));
}
WINDROW_EXPORT windrow_result windrow_vulkan_wind_create(const windrow_vulkan_host* host, const windrow_config* config, const
    windrow_vulkan_settings* settings, windrow_wind** wind) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_vulkan_wind_create(host, config, settings, wind);
    return turned<Same>(own_windrow_vulkan_wind_create, same(host), in_array<Whole>(config, 1), in_array<Whole>(settings, 1),
        same(wind));
}
WINDROW_EXPORT windrow_result windrow_vulkan_wind_create_inside(const windrow_vulkan_host* host, const windrow_config* config,
    const windrow_vulkan_settings* settings, const windrow_wind* outer, windrow_wind** wind) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_vulkan_wind_create_inside(host, config, settings, outer, wind);
    return turned<Same>(own_windrow_vulkan_wind_create_inside, same(host), in_array<Whole>(config, 1), in_array<Whole>(settings,
        1), same(outer), same(wind));
}
WINDROW_EXPORT windrow_result windrow_vulkan_wind_load(const windrow_vulkan_host* host, const void* bytes, uint64_t size, const
    windrow_vulkan_settings* settings, windrow_wind** wind) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_vulkan_wind_load(host, bytes, size, settings, wind);
    return turned<Same>(own_windrow_vulkan_wind_load, same(host), same(bytes), same(size), in_array<Whole>(settings, 1),
        same(wind));
}
WINDROW_EXPORT windrow_result windrow_vulkan_wind_load_inside(const windrow_vulkan_host* host, const void* bytes, uint64_t size,
    const windrow_vulkan_settings* settings, const windrow_wind* outer, windrow_wind** wind) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_vulkan_wind_load_inside(host, bytes, size, settings, outer, wind);
    return turned<Same>(own_windrow_vulkan_wind_load_inside, same(host), same(bytes), same(size), in_array<Whole>(settings, 1),
        same(outer), same(wind));
}
WINDROW_EXPORT windrow_result windrow_vulkan_wind_record(windrow_wind* wind, void* commands, const windrow_vulkan_frame* frame,
    windrow_advance* advance, windrow_diagnostics* last) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_vulkan_wind_record(wind, commands, frame, advance, last);
    return turned<Same>(own_windrow_vulkan_wind_record, same(wind), same(commands), in_array<Whole>(frame, 1), same(advance),
        out_array<Whole>(last, 1));
}
WINDROW_EXPORT windrow_result windrow_vulkan_wind_record_step(windrow_wind* wind, void* commands, const windrow_vulkan_frame*
    frame, windrow_diagnostics* diagnostics) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_vulkan_wind_record_step(wind, commands, frame, diagnostics);
    return turned<Same>(own_windrow_vulkan_wind_record_step, same(wind), same(commands), in_array<Whole>(frame, 1),
        out_array<Whole>(diagnostics, 1));
}
WINDROW_EXPORT windrow_result windrow_vulkan_sampler_info(const windrow_boundaries* boundaries, void* sampler_info) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_vulkan_sampler_info(boundaries, sampler_info);
    return turned<Same>(own_windrow_vulkan_sampler_info, in_array<Whole>(boundaries, 1), same(sampler_info));
}
WINDROW_EXPORT windrow_result windrow_vulkan_wind_reported(windrow_wind* wind, windrow_diagnostics* diagnostics) {
    if (!host_axes.turned) [[likely]]
        return own_windrow_vulkan_wind_reported(wind, diagnostics);
    return turned<Same>(own_windrow_vulkan_wind_reported, same(wind), out_array<Whole>(diagnostics, 1));
}
