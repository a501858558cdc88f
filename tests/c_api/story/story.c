/* The story of story_test.py in C. */
#include <inttypes.h>
#include <stdio.h>
#include <windrow/windrow.h>

static int failed(windrow_result result) {
    if (result != WINDROW_OK)
        fprintf(stderr, "%s\n", windrow_last_error());
    return result != WINDROW_OK;
}

int main(void) {
    windrow_config config;
    windrow_gusts gusts;
    windrow_obstacle block;
    windrow_jet_motor jet;
    windrow_wind* wind = NULL;
    windrow_bytes* bytes = NULL;
    windrow_obstacle_id block_id;
    windrow_motor_id jet_id;
    if (failed(windrow_config_init(&config, sizeof config)) || failed(windrow_gusts_init(&gusts, sizeof gusts)) ||
        failed(windrow_obstacle_init(&block, sizeof block)) || failed(windrow_jet_motor_init(&jet, sizeof jet)))
        return 2;
    gusts.intensity = 0.2f;
    config.cells = (windrow_ivec3){24, 12, 20};
    config.cell_size = 0.75f;
    config.boundaries = windrow_boundaries_open_over_floor();
    config.ambient = (windrow_vec3){3.0f, 0.0f, 1.0f};
    config.gusts = &gusts;
    config.simd = WINDROW_SIMD_BASELINE;
    block.position = (windrow_dvec3){2.0, 1.0, 0.5};
    block.shape = windrow_shape_block((windrow_vec3){0.5f, 1.0f, 0.8f});
    jet.position = (windrow_dvec3){-3.0, 1.5, 0.0};
    if (failed(windrow_wind_create(&config, &wind)) || failed(windrow_wind_add_obstacle(wind, &block, &block_id)) ||
        failed(windrow_wind_add_jet(wind, &jet, &jet_id)))
        return 2;
    for (int frame = 0; frame < 60; ++frame)
        if (failed(windrow_wind_follow(wind, (windrow_dvec3){frame / 20.0, 1.0, 0.0})) ||
            failed(windrow_wind_move_motor(wind, jet_id, (windrow_dvec3){frame / 16.0 - 3.0, 1.5, 0.0})) ||
            failed(windrow_wind_advance(wind, 1.0 / 60.0, NULL, NULL)))
            return 2;
    if (failed(windrow_wind_save(wind, &bytes)))
        return 2;
    uint64_t hash = 0xcbf29ce484222325u;
    for (uint64_t n = 0; n < windrow_bytes_size(bytes); ++n)
        hash = (hash ^ windrow_bytes_data(bytes)[n]) * 0x100000001b3u;
    printf("%016" PRIx64 "\n", hash);
    windrow_bytes_destroy(bytes);
    windrow_wind_destroy(wind);
    return 0;
}
