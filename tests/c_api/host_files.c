/* Snapshots, event logs, VDB files, and the ambient wind by itself. */
#include "host.h"

static void check_ambient(void) {
    windrow_ambient_settings settings;
    windrow_log_profile profile;
    windrow_gusts gusts;
    windrow_sampling sampling;
    windrow_uniform_gust uniform;
    windrow_ambient_wind *ambient = NULL, *same = NULL;
    windrow_gust_tile *tile = NULL, *of_ambient = NULL;
    windrow_ambient_block block;
    windrow_vec3 a, b;
    uint64_t count = 0;
    CHECK_OK(windrow_ambient_settings_init(&settings, sizeof settings));
    CHECK_OK(windrow_log_profile_init(&profile, sizeof profile));
    CHECK_OK(windrow_gusts_init(&gusts, sizeof gusts));
    CHECK_OK(windrow_sampling_init(&sampling, sizeof sampling));
    CHECK_OK(windrow_gust_tile_bake(5, &tile));
    CHECK(windrow_gust_tile_texels(tile, &count) != NULL && count == 128 * 16 * 128);
    gusts.intensity = 0.3f;
    gusts.seed = 5;
    settings.mean = vec3(6.0f, 0.0f, 0.0f);
    settings.profile = &profile;
    settings.gusts = &gusts;
    CHECK_OK(windrow_ambient_wind_create(&settings, &ambient)); /* bakes the same tile */
    gusts.tile = tile;
    CHECK_OK(windrow_ambient_wind_create(&settings, &same));
    windrow_gust_tile_destroy(tile);
    CHECK_OK(windrow_ambient_wind_advance(ambient, 2.0));
    CHECK_OK(windrow_ambient_wind_set_phase(same, windrow_ambient_wind_phase(ambient)));
    CHECK_OK(windrow_ambient_wind_velocity(ambient, dvec3(3.0, 4.0, 5.0), &a));
    CHECK_OK(windrow_ambient_wind_velocity(same, dvec3(3.0, 4.0, 5.0), &b));
    CHECK(memcmp(&a, &b, sizeof a) == 0 && a.x > 1.0f);
    sampling.limit = 1.0f;
    CHECK_OK(windrow_ambient_wind_felt(ambient, dvec3(3.0, 4.0, 5.0), &sampling, &a));
    CHECK(a.x <= 1.0001f && a.x > 0.0f);
    CHECK(windrow_ambient_wind_profile_at(ambient, 10.0) > 0.99f && windrow_ambient_wind_period(ambient) > 255.0);
    CHECK_OK(windrow_ambient_wind_block(ambient, dvec3(0.0, 0.0, 0.0), NULL, &block));
    CHECK(block.mean.x == 6.0f && block.reference_height == 10.0f);
    CHECK_OK(windrow_ambient_wind_set_mean(ambient, vec3(2.0f, 0.0f, 0.0f)));
    CHECK_OK(windrow_ambient_wind_set_ground(ambient, 3.0));
    CHECK(windrow_ambient_wind_mean(ambient).x == 2.0f && windrow_ambient_wind_ground(ambient) == 3.0);
    CHECK_OK(windrow_ambient_wind_tile(same, &of_ambient));
    CHECK(of_ambient != NULL);
    windrow_gust_tile_destroy(of_ambient);
    sampling.detail = 9.0f;
    CHECK_FAILS(windrow_sampling_validate(&sampling), WINDROW_REJECTED, "detail is 9");
    CHECK_OK(windrow_uniform_gust_init(&uniform, sizeof uniform));
    CHECK_OK(windrow_uniform_gust_velocity(&uniform, 0.0, &a));
    CHECK(a.x > 1.0f);
    windrow_ambient_wind_destroy(ambient);
    windrow_ambient_wind_destroy(same);
}

static void check_vdb(const windrow_wind* wind, const char* folder) {
    char path[1024];
    windrow_vdb_options options;
    windrow_vdb_grid grid;
    windrow_vdb_scalar heat;
    windrow_vdb_film film;
    windrow_vec4 cells[8];
    const float warm[8] = {1.0f, 2.0f, 3.0f, 4.0f, 5.0f, 6.0f, 7.0f, 8.0f};
    CHECK_OK(windrow_vdb_options_init(&options, sizeof options));
    options.up = WINDROW_VDB_UP_Z;
    options.name = "wind";
    sprintf(path, "%.1000s/host.vdb", folder);
    CHECK_OK(windrow_vdb_write(wind, path, &options));
    CHECK_OK(windrow_vdb_write_frame(wind, folder, "host_", 4, 12, 0.4, NULL));
    CHECK_FAILS(windrow_vdb_write(wind, "/no/such/folder/host.vdb", NULL), WINDROW_CANNOT_WRITE, "/no/such/folder");
    options.form = 4;
    CHECK_FAILS(windrow_vdb_write(wind, path, &options), WINDROW_REJECTED, "form is 4");
    memset(cells, 0, sizeof cells);
    CHECK_OK(windrow_vdb_grid_init(&grid, sizeof grid));
    grid.cells.x = grid.cells.y = grid.cells.z = 2;
    grid.field = cells;
    grid.count = 8;
    memset(&heat, 0, sizeof heat);
    heat.name = "heat";
    heat.units = "K";
    heat.values = warm;
    grid.scalars = &heat;
    grid.scalar_count = 1;
    options.form = WINDROW_VDB_ONE_VECTOR;
    CHECK_OK(windrow_vdb_film_init(&film, sizeof film));
    CHECK(film.margin == 0.0 && film.has_region == 0 && film.speed == 0);
    film.margin = 4.0;
    film.speed = 1;
    film.vorticity = 1;
    sprintf(path, "%.1000s/host_film.vdb", folder);
    CHECK_OK(windrow_vdb_write_film(wind, &film, path, &options));
    film.margin = -1.0;
    CHECK_FAILS(windrow_vdb_write_film(wind, &film, path, NULL), WINDROW_REJECTED, "film.margin is -1 m");
    film.margin = 0.0;
    film.scalar_count = 1;
    CHECK_FAILS(windrow_vdb_write_film(wind, &film, path, NULL), WINDROW_REJECTED, "film.scalars is null");
    film.scalar_count = 0;
    film.has_region = 1; /* without extent */
    CHECK_FAILS(windrow_vdb_write_film(wind, &film, path, NULL), WINDROW_REJECTED, "");
    CHECK(windrow_vdb_has_nanovdb() == 0 || windrow_vdb_has_nanovdb() == 1);
    sprintf(path, "%.1000s/host_grid.vdb", folder);
    CHECK_OK(windrow_vdb_write_grid(&grid, path, NULL));
    grid.count = 7;
    CHECK_FAILS(windrow_vdb_write_grid(&grid, path, NULL), WINDROW_REJECTED, "7");
}

void check_files(const char* folder) {
    windrow_config config = small_config();
    windrow_wind *wind = NULL, *loaded = NULL, *replayed = NULL;
    windrow_jet_motor jet;
    windrow_motor_id id;
    windrow_bytes *start = NULL, *end = NULL, *log_bytes = NULL;
    windrow_event_log *log = NULL, *read = NULL;
    windrow_ambient_wind* around = NULL;
    unsigned char* damaged = NULL;
    int n;

    check_ambient();
    CHECK_OK(windrow_wind_create(&config, &wind));
    CHECK_OK(windrow_jet_motor_init(&jet, sizeof jet));
    CHECK_OK(windrow_wind_add_jet(wind, &jet, &id));
    CHECK_OK(windrow_wind_advance(wind, 0.1, NULL, NULL));
    CHECK_OK(windrow_wind_save(wind, &start));
    CHECK(windrow_bytes_size(start) > 24u * 12u * 24u * 16u && windrow_bytes_data(start) != NULL);

    CHECK_OK(windrow_event_log_create(&log));
    CHECK_OK(windrow_wind_record_to(wind, log));
    for (n = 0; n < 6; ++n) {
        CHECK_OK(windrow_wind_follow(wind, dvec3(0.6 * n, 0.0, 0.0)));
        CHECK_OK(windrow_wind_move_motor(wind, id, dvec3(0.2 * n, 2.0, 0.0)));
        CHECK_OK(windrow_wind_advance(wind, 0.05, NULL, NULL));
    }
    CHECK_OK(windrow_wind_record_to(wind, NULL));
    CHECK(windrow_event_log_count(log) == 18 && windrow_event_log_complete(log) == 1);
    CHECK_OK(windrow_event_log_to_bytes(log, &log_bytes));
    CHECK_OK(windrow_event_log_from_bytes(windrow_bytes_data(log_bytes), windrow_bytes_size(log_bytes), &read));

    CHECK_OK(windrow_wind_load(windrow_bytes_data(start), windrow_bytes_size(start), NULL, &replayed));
    CHECK_OK(windrow_event_log_replay(read, replayed));
    CHECK(same_cells(wind, replayed));
    CHECK_OK(windrow_wind_save(wind, &end));
    CHECK_OK(windrow_wind_load(windrow_bytes_data(end), windrow_bytes_size(end), NULL, &loaded));
    CHECK_OK(windrow_wind_step(wind, 0.02, NULL));
    CHECK_OK(windrow_wind_step(loaded, 0.02, NULL));
    CHECK(same_cells(wind, loaded));
    CHECK_OK(windrow_wind_move_motor(loaded, id, dvec3(0.0, 2.0, 0.0))); /* ids go on */

    damaged = (unsigned char*)windrow_bytes_data(log_bytes);
    damaged[windrow_bytes_size(log_bytes) / 2] ^= 1;
    windrow_event_log_destroy(read);
    CHECK_FAILS(windrow_event_log_from_bytes(damaged, windrow_bytes_size(log_bytes), &read), WINDROW_REJECTED, "log");
    CHECK(read == NULL);
    CHECK_OK(windrow_event_log_clear(log));
    CHECK(windrow_event_log_count(log) == 0);
    CHECK_OK(windrow_ambient_wind_of(wind, WINDROW_FRAME_PREVIOUS, &around));
    CHECK(windrow_ambient_wind_mean(around).x == 3.0f);
    windrow_ambient_wind_destroy(around);
    if (windrow_has_part(WINDROW_PART_VDB))
        check_vdb(wind, folder);
    else
        CHECK_FAILS(windrow_vdb_write(wind, "host.vdb", NULL), WINDROW_UNSUPPORTED, "without vdb");
    windrow_bytes_destroy(start);
    windrow_bytes_destroy(end);
    windrow_bytes_destroy(log_bytes);
    windrow_event_log_destroy(log);
    windrow_wind_destroy(wind);
    windrow_wind_destroy(loaded);
    windrow_wind_destroy(replayed);
}
