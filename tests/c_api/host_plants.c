/* Plants and their motion: one and many give the same. */
#include "host.h"

#include <math.h>

enum { PLANTS = 70 };

static void check_blades(void) {
    windrow_blade_settings settings;
    windrow_drag wheat;
    windrow_blades* blades = NULL;
    windrow_plant_key keys[PLANTS];
    windrow_vec4 winds[PLANTS], loads[PLANTS], roots[PLANTS], positions[PLANTS * 3 * 2], normals[PLANTS * 3 * 2];
    const float heights[3] = {0.0f, 0.5f, 1.0f};
    windrow_plant_vertex tip;
    windrow_blade_block block;
    float angle = 0.0f;
    double cauchy = 0.0;
    int n, differ = 0;
    CHECK_OK(windrow_drag_init(&wheat, sizeof wheat));
    CHECK_OK(windrow_drag_of(WINDROW_PLANT_WHEAT, &wheat));
    CHECK(wheat.rigidity == windrow_tube_rigidity(4.8e9f, 0.004f, 0.003f) && windrow_rod_rigidity(1e9f, 0.01f) > 0.0f);
    CHECK(windrow_folded_rigidity(5e8f, 0.004f, 2.5e-4f, 0.001f) > windrow_rectangle_rigidity(5e8f, 0.004f, 2.5e-4f));
    CHECK_OK(windrow_bend_angle(&wheat, 5.0f, &angle));
    CHECK_OK(windrow_cauchy_number(&wheat, 5.0, &cauchy));
    CHECK(angle > 0.0f && angle < 1.6f && cauchy > 0.0);
    CHECK_OK(windrow_blade_settings_init(&settings, sizeof settings));
    settings.stalk = &wheat;
    CHECK_OK(windrow_blades_create(&settings, &blades));
    CHECK_OK(windrow_blades_block(blades, &block));
    CHECK(block.size.x == wheat.length);
    for (n = 0; n < PLANTS; ++n) {
        windrow_vec4 wind = {3.0f, 0.0f, 0.0f, 0.0f}, root = {1.0f, 2.0f, 3.0f, 0.0f};
        wind.x += 0.1f * (float)n;
        keys[n] = windrow_place_key((float)n, 2.0f);
        winds[n] = wind;
        roots[n] = root;
    }
    CHECK_OK(windrow_blades_loads(blades, PLANTS, keys, winds, loads, NULL));
    CHECK_OK(windrow_blades_vertices(blades, PLANTS, keys, roots, loads, 3, heights, vec3(0.0f, 0.0f, 1.0f), positions, normals,
                                     NULL));
    for (n = 0; n < PLANTS; ++n) {
        const windrow_vec3 load = windrow_blades_load(blades, keys[n], vec3(winds[n].x, 0.0f, 0.0f));
        CHECK_OK(windrow_blades_vertex(blades, keys[n], load, 1.0f, 1.0f, vec3(0.0f, 0.0f, 1.0f), &tip));
        differ += fabs((double)(load.x - loads[n].x)) > 1e-5;
        differ += fabs((double)(tip.position.y + 2.0f - positions[6 * n + 5].y)) > 1e-4;
    }
    CHECK(differ == 0 && windrow_blades_length(blades, keys[0]) > 0.0f);
    CHECK(windrow_plant_yaw(keys[0]) >= 0.0f && windrow_plant_stiffness(keys[0], 0.0f) == 1.0f);
    windrow_blades_destroy(blades);
    settings.taper = -1.0f;
    CHECK_FAILS(windrow_blades_create(&settings, &blades), WINDROW_REJECTED, "taper is -1");
    CHECK_FAILS(windrow_drag_of(99, &wheat), WINDROW_REJECTED, "plant is 99");
}

static void check_shells(void) {
    windrow_shell_settings settings;
    windrow_shells* shells = NULL;
    windrow_skin skin;
    windrow_vec4 positions[PLANTS], normals[PLANTS], winds[PLANTS], loads[PLANTS], out[PLANTS];
    windrow_shell_block block;
    windrow_vec3 load, bent, pushed;
    int n;
    for (n = 0; n < PLANTS; ++n) {
        windrow_vec4 position = {0.0f, 1.0f, 0.0f, 1.0f}, normal = {0.0f, 1.0f, 0.0f, 0.0f}, wind = {2.0f, 0.0f, 0.0f, 0.0f};
        positions[n] = position;
        normals[n] = normal;
        winds[n] = wind;
    }
    skin.count = PLANTS;
    skin.positions = positions;
    skin.normals = normals;
    CHECK_OK(windrow_shell_settings_init(&settings, sizeof settings));
    settings.shells = 8;
    CHECK_OK(windrow_shells_create(&settings, &shells));
    CHECK(windrow_shells_height(shells, 0) == 0.0f && windrow_shells_height(shells, 7) == 1.0f);
    CHECK_OK(windrow_shells_block(shells, &block));
    CHECK_OK(windrow_shells_loads_many(shells, &skin, winds, loads, NULL));
    CHECK_OK(windrow_shells_bent_many(shells, &skin, 1.0f, loads, out, NULL));
    load = windrow_shells_load(shells, vec3(0.0f, 1.0f, 0.0f), 1.0f, vec3(2.0f, 0.0f, 0.0f));
    bent = windrow_shells_bent(shells, vec3(0.0f, 1.0f, 0.0f), vec3(0.0f, 1.0f, 0.0f), 1.0f, 1.0f, load);
    CHECK(fabs((double)(load.x - loads[5].x)) < 1e-5 && fabs((double)(bent.x - out[5].x)) < 1e-6 && bent.x > 0.0f);
    CHECK_OK(windrow_shells_translated_many(shells, &skin, 1.0f, winds, out, NULL));
    pushed =
        windrow_shells_translated(shells, vec3(0.0f, 1.0f, 0.0f), vec3(0.0f, 1.0f, 0.0f), 1.0f, 1.0f, vec3(2.0f, 0.0f, 0.0f));
    CHECK(fabs((double)(pushed.x - out[5].x)) < 1e-6);
    skin.normals = NULL;
    CHECK_FAILS(windrow_shells_loads_many(shells, &skin, winds, loads, NULL), WINDROW_REJECTED,
                "skin has no positions or no normals");
    windrow_shells_destroy(shells);
}

static void check_tree(void) {
    windrow_tree_classes classes;
    windrow_tree* tree = NULL;
    windrow_tree_part parts[2] = {{{0.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}, 8.0f, 1.0f},
                                  {{0.0f, 5.0f, 0.0f}, {1.0f, 0.0f, 0.0f}, 2.5f, 1.0f}};
    windrow_vec4 winds[2] = {{8.0f, 0.0f, 0.0f, 0.0f}, {8.0f, 0.0f, 0.0f, 0.0f}}, rest = {2.4f, 5.1f, 0.0f, 0.0f},
                 normal = {0.0f, 1.0f, 0.0f, 0.0f}, position, turned;
    windrow_tree_bearers bearers = {0, 1, WINDROW_NO_PART};
    windrow_plant_vertex at_rest, bent;
    windrow_tree_block block;
    CHECK_OK(windrow_tree_classes_init(&classes, sizeof classes));
    CHECK_OK(windrow_tree_create(&classes, &tree));
    CHECK_OK(windrow_tree_block_of(tree, &block));
    at_rest.position = vec3(2.4f, 5.1f, 0.0f);
    at_rest.normal = vec3(0.0f, 1.0f, 0.0f);
    at_rest.tangent = vec3(1.0f, 0.0f, 0.0f);
    CHECK_OK(windrow_tree_vertex(tree, &parts[0], &parts[1], NULL, vec3(8.0f, 0.0f, 0.0f), &at_rest, &bent));
    CHECK_OK(windrow_tree_vertices(tree, 2, parts, winds, 1, &rest, &normal, &bearers, &position, &turned, NULL));
    CHECK(fabs((double)(bent.position.x - position.x)) < 1e-5 && bent.position.x != 2.4f);
    bearers.branch = 9;
    CHECK_FAILS(windrow_tree_vertices(tree, 2, parts, winds, 1, &rest, &normal, &bearers, &position, &turned, NULL),
                WINDROW_REJECTED, "9");
    parts[0].length = -1.0f;
    CHECK_FAILS(windrow_tree_vertex(tree, &parts[0], NULL, NULL, vec3(8.0f, 0.0f, 0.0f), &at_rest, &bent), WINDROW_REJECTED,
                "length is -1");
    windrow_tree_destroy(tree);
}

static void check_springs(void) {
    windrow_spring_class spring;
    windrow_spring_step step;
    windrow_spring_block block;
    windrow_swing_block swing;
    windrow_spring_class bands[4];
    windrow_swing_block swings[4];
    windrow_flutter_class leaves = {6.0, 0.6f, 1.6f};
    windrow_flutter_block flutter, as_default;
    windrow_spring_batch batch;
    windrow_cascade_step* cascade = NULL;
    windrow_cascade_batch rows;
    double place = 0.0, velocity = 0.0, target = 1.0, stages[3] = {0.0, 0.0, 0.0};
    float place_f = 0.0f, velocity_f = 0.0f, target_f = 1.0f, stages_f[3] = {0.0f, 0.0f, 0.0f}, body = 1.0f;
    double body_d = 1.0;
    CHECK_OK(windrow_spring_class_of(WINDROW_SPRING_REED, &spring));
    CHECK(spring.frequency_hz == 0.9);
    CHECK_FAILS(windrow_spring_step_make(&spring, -1.0, &step), WINDROW_REJECTED, "-1");
    CHECK_OK(windrow_spring_step_make(&spring, 100.0, &step));
    CHECK_OK(windrow_spring_step_block(&step, &block));
    CHECK_FAILS(windrow_swing_step_make(&spring, -1.0, &swing), WINDROW_REJECTED, "-1");
    CHECK_OK(windrow_swing_step_make(&spring, 1.0 / 24.0, &swing));
    CHECK(swing.parts.x == 3.0f && swing.parts.y < 1.0f / 60.0f);
    CHECK_OK(windrow_spring_bands(&spring, bands));
    CHECK(bands[0].frequency_hz < 0.7 && bands[3].frequency_hz > 1.1 && bands[3].damping == spring.damping);
    CHECK_OK(windrow_swing_steps_make(&spring, 1.0 / 24.0, swings));
    CHECK(swings[3].parts.x == swing.parts.x && swings[3].smoothing.place.x == swing.smoothing.place.x);
    CHECK_FAILS(windrow_swing_steps_make(&spring, -1.0, swings), WINDROW_REJECTED, "-1");
    spring.frequency_hz = -5.0;
    CHECK_FAILS(windrow_spring_bands(&spring, bands), WINDROW_REJECTED, "-5");
    CHECK_OK(windrow_flutter_step_make(&leaves, 1.0, 1.0 / 60.0, &flutter));
    CHECK_OK(windrow_flutter_step_make(NULL, 1.0, 1.0 / 60.0, &as_default));
    CHECK(memcmp(&flutter, &as_default, sizeof flutter) == 0 && flutter.motion.x == 0.6f && flutter.now.x != flutter.before.x);
    leaves.onset = -1.0f;
    CHECK_FAILS(windrow_flutter_step_make(&leaves, 1.0, 0.0, &flutter), WINDROW_REJECTED, "-1");
    memset(&batch, 0, sizeof batch);
    batch.count = 1;
    batch.place = &place;
    batch.velocity = &velocity;
    batch.target_before = batch.target_now = &target;
    CHECK_OK(windrow_springs_advance_double(&step, &batch, NULL));
    batch.place = &place_f;
    batch.velocity = &velocity_f;
    batch.target_before = batch.target_now = &target_f;
    CHECK_OK(windrow_springs_advance_float(&step, &batch, NULL));
    CHECK(fabs(place - 1.0) < 1e-9 && fabs((double)place_f - 1.0) < 1e-6); /* a long step ends at the target */
    batch.velocity = NULL;
    CHECK_FAILS(windrow_springs_advance_float(&step, &batch, NULL), WINDROW_REJECTED, "batch lacks an array");

    CHECK_OK(windrow_cascade_step_create(3, &cascade));
    CHECK_OK(windrow_cascade_step_set(cascade, 10.0, 100.0));
    memset(&rows, 0, sizeof rows);
    rows.rows = 1;
    rows.value = stages;
    rows.body_before = rows.body_now = &body_d;
    CHECK_OK(windrow_cascades_advance_double(cascade, &rows, NULL));
    rows.value = stages_f;
    rows.body_before = rows.body_now = &body;
    CHECK_OK(windrow_cascades_advance_float(cascade, &rows, NULL));
    CHECK(fabs(stages[2] - 1.0) < 1e-9 && fabs((double)stages_f[2] - 1.0) < 1e-6);
    windrow_cascade_step_destroy(cascade);
}

static void check_cascade(void) {
    windrow_cascade_config config;
    windrow_cascade *tail = NULL, *again = NULL;
    windrow_bytes* bytes = NULL;
    windrow_pose body, tip;
    const windrow_pose_block* poses = NULL;
    uint64_t count = 0;
    memset(&body, 0, sizeof body);
    body.rotation.w = 1.0;
    body.scale = 1.0;
    CHECK_OK(windrow_cascade_config_init(&config, sizeof config));
    CHECK_OK(windrow_cascade_create(&config, &body, &tail));
    body.position.x = 1.0;
    CHECK_OK(windrow_cascade_advance(tail, 0.1, &body));
    CHECK_OK(windrow_cascade_at(tail, 1.0, &tip));
    CHECK(tip.position.x > 0.0 && tip.position.x < 0.9);
    CHECK_OK(windrow_cascade_previous_at(tail, 1.0, &tip));
    CHECK(tip.position.x == 0.0);
    CHECK_OK(windrow_cascade_move(tail, dvec3(0.0, 5.0, 0.0)));
    CHECK_OK(windrow_cascade_save(tail, &bytes));
    CHECK_OK(windrow_cascade_load(windrow_bytes_data(bytes), windrow_bytes_size(bytes), &again));
    windrow_bytes_destroy(bytes);
    windrow_cascade_destroy(tail);
    tail = again;
    CHECK_OK(windrow_cascade_shader_poses(tail, dvec3(0.0, 0.0, 0.0), &poses, &count));
    CHECK(count == 11 && poses[0].place.y == 5.0f);
    CHECK_OK(windrow_cascade_previous_shader_poses(tail, dvec3(0.0, 0.0, 0.0), &poses, &count));
    CHECK_OK(windrow_cascade_reset(tail, &body));
    CHECK_OK(windrow_cascade_at(tail, 1.0, &tip));
    CHECK(tip.position.x == 1.0);
    body.scale = -1.0;
    CHECK_FAILS(windrow_cascade_advance(tail, 0.1, &body), WINDROW_REJECTED, "scale");
    windrow_cascade_destroy(tail);
}

/* Two states in one file, and back. */
static void check_parts(const windrow_bytes* saved) {
    windrow_saved_part parts[2];
    windrow_bytes* file = NULL;
    const void* found = NULL;
    uint64_t size = 0;
    parts[0].name = "ground";
    parts[0].bytes = windrow_bytes_data(saved);
    parts[0].size = windrow_bytes_size(saved);
    parts[1].name = "my own";
    parts[1].bytes = "seven";
    parts[1].size = 5;
    CHECK_OK(windrow_parts_join(parts, 2, &file));
    CHECK_OK(windrow_parts_find(windrow_bytes_data(file), windrow_bytes_size(file), "my own", &found, &size));
    CHECK(size == 5 && memcmp(found, "seven", 5) == 0);
    CHECK_OK(windrow_parts_find(windrow_bytes_data(file), windrow_bytes_size(file), "ground", &found, &size));
    CHECK(size == parts[0].size && memcmp(found, parts[0].bytes, (size_t)size) == 0);
    CHECK_FAILS(windrow_parts_find(windrow_bytes_data(file), windrow_bytes_size(file), "smoke", &found, &size), WINDROW_REJECTED,
                "smoke");
    CHECK(found == NULL && size == 0);
    windrow_bytes_destroy(file);
    parts[1].name = "ground";
    CHECK_FAILS(windrow_parts_join(parts, 2, &file), WINDROW_REJECTED, "ground");
    parts[1].name = NULL;
    CHECK_FAILS(windrow_parts_join(parts, 2, &file), WINDROW_REJECTED, "name");
}

static void check_ground(void) {
    windrow_ground_config config;
    windrow_ground *ground = NULL, *again = NULL;
    windrow_cascade* tail = NULL;
    windrow_bytes* bytes = NULL;
    windrow_ground_step step;
    windrow_ground_walker walker;
    windrow_ground_sample here, away, before;
    windrow_ground_block block;
    windrow_vec2 leans[32 * 32];
    windrow_ivec2 slot = {0, 0};
    uint64_t count = 0;
    CHECK_OK(windrow_ground_config_init(&config, sizeof config));
    config.texels = 32;
    CHECK_OK(windrow_ground_create(&config, NULL, &ground));
    CHECK_OK(windrow_ground_follow(ground, dvec3(0.0, 0.0, 0.0)));
    memset(&walker, 0, sizeof walker);
    walker.position = walker.previous = dvec3(0.5, 0.0, 0.5);
    walker.radius = 0.5f;
    walker.weight = 1.0f;
    CHECK_OK(windrow_ground_step_init(&step, sizeof step));
    step.duration = 0.1;
    step.walkers = &walker;
    step.walker_count = 1;
    CHECK_OK(windrow_ground_advance(ground, &step, NULL, 0));
    CHECK_OK(windrow_ground_at(ground, dvec3(0.5, 0.0, 0.5), &here));
    CHECK_OK(windrow_ground_at(ground, dvec3(-2.0, 0.0, -2.0), &away));
    CHECK(here.trample > 0.5f && away.trample == 0.0f);
    CHECK(windrow_ground_texels(ground, &count) != NULL && count == 32 * 32 &&
          windrow_ground_previous_texels(ground, NULL) != NULL);
    memset(leans, 0, sizeof leans);
    CHECK_OK(windrow_ground_advance(ground, &step, leans, 32 * 32));
    CHECK_OK(windrow_ground_previous_at(ground, dvec3(0.5, 0.0, 0.5), &before));
    CHECK(memcmp(&before, &here, sizeof here) == 0);
    CHECK_OK(windrow_ground_save(ground, &bytes));
    CHECK_OK(windrow_ground_load(windrow_bytes_data(bytes), windrow_bytes_size(bytes), NULL, &again));
    CHECK(memcmp(windrow_ground_texels(ground, NULL), windrow_ground_texels(again, NULL), count * sizeof(windrow_vec4)) == 0);
    windrow_ground_destroy(again);
    CHECK_OK(windrow_ground_shift_origin(ground, dvec3(1000.3, 0.0, -7.0)));
    CHECK_OK(windrow_ground_previous_at(ground, dvec3(1000.8, 0.0, -6.5), &away));
    CHECK(memcmp(&away, &before, sizeof before) == 0);
    CHECK_OK(windrow_ground_shift_origin(ground, dvec3(-1000.3, 0.0, 7.0)));
    CHECK_FAILS(windrow_ground_shift_origin(ground, dvec3(1e300, 0.0, 0.0)), WINDROW_REJECTED, "1e+300");
    check_parts(bytes);
    CHECK_FAILS(windrow_cascade_load(windrow_bytes_data(bytes), windrow_bytes_size(bytes), &tail), WINDROW_REJECTED, "cascade");
    windrow_bytes_destroy(bytes);
    CHECK_FAILS(windrow_ground_advance(ground, &step, leans, 5), WINDROW_REJECTED, "5");
    CHECK(windrow_ground_walkers_left_out(ground) == 0);
    CHECK_OK(windrow_ground_block_of(ground, dvec3(0.0, 0.0, 0.0), &block));
    CHECK(block.now.corner.w == 32.0f && windrow_ground_next_centre(ground, slot).x != 0.0);
    windrow_ground_destroy(ground);
}

void check_plants(void) {
    check_blades();
    check_shells();
    check_tree();
}

void check_motion(void) {
    check_springs();
    check_cascade();
    check_ground();
}
