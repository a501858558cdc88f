/* The wind by itself: time, place, queries, textures, threads, errors, versions of structs. */
#include "host.h"

#include <math.h>

static void run_twice(void* context, int32_t count, windrow_task task, void* argument) {
    int32_t n;
    for (n = count - 1; n >= 0; --n) /* any order */
        task(argument, n);
    *(int*)context += 1;
}

static void shear(void* user, const windrow_dvec3* centre, windrow_vec3* velocity) {
    *velocity = vec3((float)(centre->y * *(const double*)user), 0.0f, 0.0f);
}

static void check_queries(windrow_wind* wind) {
    enum { POINTS = 300 };
    windrow_dvec3 positions[POINTS];
    float offsets[POINTS][4];
    windrow_vec3 one, many[POINTS];
    float strided[POINTS][4];
    windrow_query query;
    windrow_sampling sampling;
    int n, differ = 0, felt_differ = 0;
    for (n = 0; n < POINTS; ++n) {
        positions[n] = dvec3(100.0 - 7.0 + 0.125 * (n % 64), 0.25 + 0.03125 * (n % 31), -3.0 + 0.5 * (n % 13));
        offsets[n][0] = (float)(positions[n].x - 100.0);
        offsets[n][1] = (float)positions[n].y;
        offsets[n][2] = (float)positions[n].z;
    }
    CHECK_OK(windrow_query_init(&query, sizeof query));
    query.count = POINTS;
    query.positions = positions;
    query.velocities = &many[0].x;
    CHECK_OK(windrow_wind_sample(wind, &query));
    for (n = 0; n < POINTS; ++n) {
        CHECK_OK(windrow_wind_velocity(wind, positions[n], &one));
        differ += memcmp(&one, &many[n], sizeof one) != 0;
    }
    CHECK(differ == 0);
    /* floats from an anchor, with strides: the same points */
    query.number = WINDROW_NUMBER_FLOAT;
    query.positions = offsets;
    query.position_stride = sizeof offsets[0];
    query.anchor = dvec3(100.0, 0.0, 0.0);
    query.velocities = strided[0];
    query.velocity_stride = sizeof strided[0];
    CHECK_OK(windrow_wind_sample(wind, &query));
    for (n = 0; n < POINTS; ++n)
        differ += memcmp(strided[n], &many[n], sizeof one) != 0;
    CHECK(differ == 0);
    /* the wind that acts on plants */
    CHECK_OK(windrow_sampling_init(&sampling, sizeof sampling));
    sampling.strength = 2.0f;
    query.sampling = &sampling;
    CHECK_OK(windrow_wind_sample(wind, &query));
    for (n = 0; n < POINTS; ++n) {
        CHECK_OK(windrow_wind_felt(wind, positions[n], &sampling, &one));
        felt_differ += memcmp(&one, strided[n], sizeof one) != 0;
        differ += fabs((double)strided[n][0] - 2.0 * (double)many[n].x) > 1e-5;
    }
    CHECK(felt_differ == 0 && differ == 0);
    query.position_stride = 4;
    CHECK_FAILS(windrow_wind_sample(wind, &query), WINDROW_REJECTED, "position_stride is 4 bytes");
    query.position_stride = 0;
    query.frame = 7;
    CHECK_FAILS(windrow_wind_sample(wind, &query), WINDROW_REJECTED, "frame is 7");
}

static void check_textures(windrow_wind* wind) {
    enum { CELLS = 24 * 12 * 24 };
    static float vectors[4 * CELLS], x[CELLS], y[CELLS], z[CELLS];
    static uint16_t halves[4 * CELLS];
    const windrow_vec4* cells = NULL;
    uint64_t count = 0;
    windrow_window_block window;
    windrow_frame_block frame;
    int n, differ = 0;
    CHECK(windrow_wind_cell_count(wind) == CELLS);
    CHECK_OK(windrow_wind_field(wind, WINDROW_FRAME_NOW, &cells, &count, NULL));
    CHECK(count == CELLS);
    CHECK_OK(windrow_wind_write_vectors(wind, WINDROW_FRAME_NOW, WINDROW_TEXEL_FLOAT, vectors, 4 * CELLS));
    CHECK_OK(windrow_wind_write_vectors(wind, WINDROW_FRAME_NOW, WINDROW_TEXEL_HALF, halves, 4 * CELLS));
    CHECK_OK(windrow_wind_write_pressure(wind, x, CELLS));
    CHECK_OK(windrow_wind_write_axes(wind, WINDROW_FRAME_NOW, WINDROW_TEXEL_FLOAT, x, y, z, CELLS));
    for (n = 0; n < CELLS; ++n)
        differ += vectors[4 * n] != x[n] || vectors[4 * n + 1] != y[n] || vectors[4 * n + 2] != z[n] ||
                  halves[4 * n] != windrow_to_half(x[n]) || windrow_from_half(windrow_to_half(1.5f)) != 1.5f;
    CHECK(differ == 0);
    CHECK_FAILS(windrow_wind_write_vectors(wind, WINDROW_FRAME_NOW, WINDROW_TEXEL_FLOAT, vectors, 5), WINDROW_REJECTED, "5");
    CHECK_FAILS(windrow_wind_write_vectors(wind, WINDROW_FRAME_NOW, 9, vectors, 5), WINDROW_REJECTED, "texel is 9");
    CHECK_OK(windrow_wind_window_block(wind, dvec3(100.0, 0.0, 0.0), &window));
    CHECK_OK(windrow_wind_frame_block(wind, dvec3(100.0, 0.0, 0.0), NULL, &frame));
    CHECK(memcmp(&window, &frame.window, sizeof window) == 0 && window.cell_size == 1.0f && window.cells.y == 12.0f);
}

static void check_tracer(windrow_wind* wind) {
    windrow_tracer *smoke = NULL, *again = NULL;
    windrow_bytes* bytes = NULL;
    const float* cells = NULL;
    uint64_t count = 0, n;
    double before = 0.0, after = 0.0, moved = 0.0;
    CHECK_OK(windrow_tracer_create(wind, NULL, &smoke));
    CHECK_OK(windrow_tracer_blow(smoke, dvec3(104.5, 4.5, 0.5), 1.5f));
    cells = windrow_tracer_cells(smoke, &count);
    CHECK(count == 24 * 12 * 24);
    for (n = 0; n < count; ++n) {
        before += (double)cells[n];
        moved -= (double)cells[n] * (double)(n % 24);
    }
    CHECK_OK(windrow_wind_step(wind, 0.2, NULL));
    CHECK_OK(windrow_tracer_step(smoke, wind, 0.2));
    cells = windrow_tracer_cells(smoke, &count);
    for (n = 0; n < count; ++n) {
        after += (double)cells[n];
        moved += (double)cells[n] * (double)(n % 24);
    }
    CHECK_OK(windrow_tracer_save(smoke, &bytes));
    CHECK_OK(windrow_tracer_load(windrow_bytes_data(bytes), windrow_bytes_size(bytes), wind, NULL, &again));
    CHECK(memcmp(windrow_tracer_cells(again, NULL), cells, count * sizeof(float)) == 0);
    windrow_tracer_destroy(again);
    windrow_bytes_destroy(bytes);
    CHECK(before > 4.0 && fabs(after - before) < 0.2 * before && moved > 0.2 * before); /* downwind, by some of a cell */
    windrow_tracer_destroy(smoke);
}

void check_wind(void) {
    windrow_config config = small_config(), got;
    windrow_log_profile profile;
    windrow_canopy canopy;
    windrow_rows rows;
    float heights[12];
    windrow_wind *wind = NULL, *other = NULL;
    windrow_diagnostics diagnostics;
    windrow_advance advance;
    windrow_box box;
    windrow_vec3 velocity;
    windrow_thread_pool* pool = NULL;
    double slope = 0.5;
    int loops = 0, n;

    CHECK_OK(windrow_log_profile_init(&profile, sizeof profile));
    CHECK_OK(windrow_canopy_init(&canopy, sizeof canopy));
    canopy.height = 1.5f;
    config.profile = &profile;
    config.canopy = &canopy;
    config.centre = dvec3(100.0, 6.0, 0.0);
    config.parallel_for.run = run_twice;
    config.parallel_for.context = &loops;
    CHECK_OK(windrow_config_validate(&config));
    CHECK_OK(windrow_wind_create(&config, &wind));
    CHECK_OK(windrow_thread_pool_create(3, &pool));
    CHECK(windrow_thread_pool_size(pool) >= 1);
    config.parallel_for = windrow_thread_pool_parallel_for(pool);
    CHECK_OK(windrow_wind_create(&config, &other));

    CHECK_OK(windrow_diagnostics_init(&diagnostics, sizeof diagnostics));
    CHECK_OK(windrow_advance_init(&advance, sizeof advance));
    CHECK_OK(windrow_box_init(&box, sizeof box));
    for (n = 0; n < 8; ++n) {
        CHECK_OK(windrow_wind_follow(wind, dvec3(100.0 + 0.7 * n, 0.0, 0.0)));
        CHECK_OK(windrow_wind_follow(other, dvec3(100.0 + 0.7 * n, 0.0, 0.0)));
        CHECK_OK(windrow_wind_advance(wind, 0.05, &advance, &diagnostics));
        CHECK_OK(windrow_wind_advance(other, 0.05, NULL, NULL));
    }
    CHECK(loops > 0 && same_cells(wind, other)); /* threads change no bit */
    CHECK(advance.ticks >= 1 && advance.factor >= 0.0f && advance.factor <= 1.0f && diagnostics.stepped == 1);
    CHECK(diagnostics.max_speed > 2.0f && diagnostics.times_ms.total > 0.0);
    CHECK_OK(windrow_wind_box(wind, &box));
    CHECK(box.cells.x == 24 && box.size.y == 12.0f && box.origin.x == 93.0 && windrow_wind_origin(wind).x == box.origin.x);
    CHECK(box.boundaries.y_low.kind == WINDROW_BOUNDARY_FREE_SLIP);
    check_queries(wind);
    check_textures(wind);

    check_tracer(wind);
    CHECK_OK(windrow_wind_step(wind, 0.01, NULL)); /* what is read is no longer between two ticks */
    CHECK_OK(windrow_wind_set_velocity(wind, shear, &slope));
    CHECK_OK(windrow_wind_velocity(wind, dvec3(104.5, 3.5, 0.5), &velocity));
    CHECK(velocity.x == 1.75f && velocity.y == 0.0f);
    CHECK_OK(windrow_wind_reset(wind));
    CHECK_OK(windrow_wind_set_ambient(wind, vec3(0.0f, 0.0f, 5.0f)));
    CHECK(windrow_wind_ambient(wind).z == 5.0f);
    CHECK_OK(windrow_wind_set_floor(wind, 2.0));
    CHECK(windrow_wind_origin(wind).y == 2.0);
    config.boundaries.y_low.kind = WINDROW_BOUNDARY_NO_SLIP;
    CHECK_OK(windrow_wind_set_boundaries(wind, &config.boundaries));
    config.boundaries.x_low.kind = 77;
    CHECK_FAILS(windrow_wind_set_boundaries(wind, &config.boundaries), WINDROW_REJECTED, "boundaries.x_low.kind is 77");

    /* the config comes back as it went in */
    CHECK_OK(windrow_config_init(&got, sizeof got));
    CHECK_OK(windrow_wind_config(wind, &got));
    CHECK(got.cells.z == 24 && got.profile != NULL && got.profile->roughness_length == profile.roughness_length);
    CHECK(got.canopy != NULL && got.canopy->height == 1.5f && got.roughness == NULL && got.stages == WINDROW_STAGE_ALL);
    CHECK(got.ambient.z == 5.0f && got.boundaries.y_low.kind == WINDROW_BOUNDARY_NO_SLIP && got.ticks_hz == 30.0);
    windrow_wind_destroy(wind);
    windrow_wind_destroy(other);
    windrow_thread_pool_destroy(pool);

    /* rows one by one */
    config = small_config();
    CHECK_OK(windrow_rows_init(&rows, sizeof rows));
    for (n = 0; n < 12; ++n)
        heights[n] = 0.25f + 0.5f * (float)n + 0.02f * (float)(n * n);
    rows.heights = heights;
    rows.height_count = 12;
    config.rows = &rows;
    CHECK_OK(windrow_wind_create(&config, &wind));
    CHECK_OK(windrow_wind_config(wind, &got));
    CHECK(got.rows != NULL && got.rows->height_count == 12 && got.rows->heights[11] == heights[11]);
    windrow_wind_destroy(wind);
    rows.heights = NULL;
    CHECK_FAILS(windrow_wind_create(&config, &wind), WINDROW_REJECTED, "heights is null");
}

/* The same structs of older and newer hosts, with other axes and another unit. */
static void check_sizes_in_centimetres(void) {
    windrow_config config;
    windrow_wind* wind = NULL;
    static char larger[sizeof(windrow_config) + 8];
    CHECK_OK(windrow_set_axes(WINDROW_AXES_Z_UP_LEFT, 0.01));
    CHECK_OK(windrow_config_init(&config, sizeof config));
    CHECK(config.cell_size == 100.0f && config.cells.y == 32 && config.cells.z == 16);
    config.struct_size = offsetof(windrow_config, scheme);
    config.scheme = 300; /* beyond its end */
    CHECK_OK(windrow_wind_create(&config, &wind));
    config.floor = 12345.0; /* likewise */
    CHECK_OK(windrow_wind_config(wind, &config));
    CHECK(config.scheme == 300 && config.floor == 12345.0 && config.cells.z == 16);
    windrow_wind_destroy(wind);
    config.struct_size = 0;
    CHECK_FAILS(windrow_config_validate(&config), WINDROW_REJECTED, "call windrow_config_init");
    memset(larger, 0, sizeof larger);
    CHECK_OK(windrow_config_init((windrow_config*)(void*)larger, sizeof larger));
    CHECK_OK(windrow_config_validate((windrow_config*)(void*)larger));
    larger[sizeof(windrow_config) + 3] = 1;
    CHECK_FAILS(windrow_config_validate((windrow_config*)(void*)larger), WINDROW_REJECTED, "does not have");
    CHECK_OK(windrow_set_axes(WINDROW_AXES_Y_UP_RIGHT, 1.0));
}

void check_errors(void) {
    windrow_config config = small_config();
    windrow_wind *wind = (windrow_wind*)&config, *loaded = wind;
    unsigned char larger[sizeof(windrow_config) + 16];
    windrow_diagnostics diagnostics;

    /* all reasons, one a line */
    config.cells.x = 0;
    config.cell_size = -1.0f;
    CHECK_FAILS(windrow_wind_create(&config, &wind), WINDROW_REJECTED, "cells");
    CHECK(strstr(windrow_last_error(), "cell_size is -1") != NULL && strchr(windrow_last_error(), '\n') != NULL && wind == NULL);
    config = small_config();
    config.scheme = 300; /* does not become another scheme */
    CHECK_FAILS(windrow_wind_create(&config, &wind), WINDROW_REJECTED, "scheme is 300");
    config = small_config();
    config.follow_axes = 8;
    CHECK_FAILS(windrow_wind_create(&config, &wind), WINDROW_REJECTED, "follow_axes is 8");
    config = small_config();
    config.stages = 32;
    CHECK_FAILS(windrow_config_validate(&config), WINDROW_REJECTED, "stages is 32");

    /* an older host: what it does not have gets its default */
    config = small_config();
    config.struct_size = offsetof(windrow_config, scheme);
    config.scheme = 300; /* beyond its end */
    CHECK_OK(windrow_wind_create(&config, &wind));
    CHECK_OK(windrow_wind_config(wind, &config)); /* and it is written no further */
    CHECK(config.scheme == 300 && config.cells.x == 24);
    /* a size that cuts a pointer */
    config = small_config();
    config.struct_size = offsetof(windrow_config, gusts) + 4;
    CHECK_FAILS(windrow_config_validate(&config), WINDROW_REJECTED, "struct_size");
    /* a newer host: only what this library has */
    memset(larger, 0, sizeof larger);
    CHECK_OK(windrow_config_init((windrow_config*)(void*)larger, sizeof larger));
    CHECK(((windrow_config*)(void*)larger)->struct_size == sizeof larger);
    CHECK_OK(windrow_config_validate((windrow_config*)(void*)larger));
    larger[sizeof(windrow_config) + 3] = 1;
    CHECK_FAILS(windrow_config_validate((windrow_config*)(void*)larger), WINDROW_REJECTED, "does not have");
    /* a host that forgot the init function */
    memset(&config, 0, sizeof config);
    CHECK_FAILS(windrow_config_validate(&config), WINDROW_REJECTED, "call windrow_config_init");
    memset(&diagnostics, 0, sizeof diagnostics);
    CHECK_FAILS(windrow_wind_step(wind, 0.1, &diagnostics), WINDROW_REJECTED, "call windrow_diagnostics_init");

    check_sizes_in_centimetres();

    CHECK_FAILS(windrow_wind_step(wind, -1.0, NULL), WINDROW_REJECTED, "dt is -1");
    CHECK_FAILS(windrow_wind_advance(wind, HUGE_VAL, NULL, NULL), WINDROW_REJECTED, "dt is inf");
    CHECK_OK(windrow_wind_step(wind, 0.0, NULL)); /* a pause */
    CHECK_FAILS(windrow_wind_step(NULL, 0.1, NULL), WINDROW_REJECTED, "wind is null");
    CHECK(windrow_wind_motor_count(NULL) == 0 && strstr(windrow_last_error(), "wind is null") != NULL);
    CHECK_FAILS(windrow_wind_load("windrow", 7, NULL, &loaded), WINDROW_REJECTED, "snapshot");
    CHECK(loaded == NULL);
    windrow_wind_destroy(wind);
}
