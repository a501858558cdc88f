// The same story of a wind, played by hosts of other axes and units: what they hear is the same, to the bit where the conversion is exact.
// A kind in tools/c_kinds.py that is wrong (a sign, a power, a wrong axis), or a call without one, makes a host hear something else.
#include "tests/c_api/axes_host.h"

#include <array>
#include <vector>

namespace {

using namespace windrow::test;

windrow_boundaries floor_and_walls(const Host& host) {
    windrow_boundaries boundaries = windrow_boundaries_open_over_floor();
    EXPECT_EQ(host.face(boundaries, 1, false).kind, WINDROW_BOUNDARY_FREE_SLIP) << host.name;
    auto& wall = host.face(boundaries, 2, true);
    wall.kind = WINDROW_BOUNDARY_NO_SLIP;
    wall.wall_velocity = host.vector(0.5, 0.25, 0.0, 1);
    return boundaries;
}

struct Settings {
    windrow_config config;
    windrow_log_profile profile;
    windrow_gusts gusts;
    windrow_canopy canopy;
    windrow_roughness roughness;
    windrow_rows rows;
    std::array<float, 9> heights;
};

void fill_settings(const Host& host, Settings& all) {
    windrow_config& config = all.config;
    WINDROW_AXES_OK(windrow_config_init(&config, sizeof config));
    EXPECT_FLOAT_EQ(config.cell_size, host.single(1.0)) << "defaults are in the host's unit";
    WINDROW_AXES_OK(windrow_log_profile_init(&all.profile, sizeof all.profile));
    WINDROW_AXES_OK(windrow_gusts_init(&all.gusts, sizeof all.gusts));
    WINDROW_AXES_OK(windrow_canopy_init(&all.canopy, sizeof all.canopy));
    WINDROW_AXES_OK(windrow_roughness_init(&all.roughness, sizeof all.roughness));
    WINDROW_AXES_OK(windrow_rows_init(&all.rows, sizeof all.rows));
    config.cells = host.cells(14, 9, 11);
    config.boundaries = floor_and_walls(host);
    config.centre = host.place(2.0, 1.0, -3.0);
    config.floor = host.number(0.5);
    config.ambient = host.vector(3.0, 0.0, 1.5, 1);
    config.viscosity = host.single(0.03125, 2);
    all.profile.roughness_length = host.single(0.0625);
    all.gusts.intensity = 0.125f;
    all.gusts.length = host.single(16.0);
    config.profile = &all.profile;
    config.gusts = &all.gusts;
}

void record_config(Record& record, windrow_wind* wind) {
    windrow_config config;
    WINDROW_AXES_OK(windrow_config_init(&config, sizeof config));
    WINDROW_AXES_OK(windrow_wind_config(wind, &config));
    record.extents("config.cells", config.cells, 0);
    record.number("config.cell_size", static_cast<double>(config.cell_size), 1);
    record.vector("config.centre", config.centre, 1);
    record.vector("config.ambient", config.ambient, 1);
    record.number("config.viscosity", static_cast<double>(config.viscosity), 2);
    record.number("config.floor", config.floor, 1);
    record.number("config.jump_speed", static_cast<double>(config.jump_speed), 1);
    record.number("config.follow_axes", config.follow_axes >= 0 ? 1.0 : 0.0);
    record.number("gusts.length", static_cast<double>(config.gusts->length), 1);
    if (config.profile != nullptr)
        record.number("profile.roughness_length", static_cast<double>(config.profile->roughness_length), 1);
    if (config.canopy != nullptr)
        record.number("canopy.drag", static_cast<double>(config.canopy->drag), -1);
    if (config.roughness != nullptr)
        record.number("roughness.length", static_cast<double>(config.roughness->length), 1);
    if (config.rows != nullptr)
        for (std::uint32_t n = 0; n < config.rows->height_count; ++n)
            record.number("rows.heights", static_cast<double>(config.rows->heights[n]), 1);
}

void record_box(const Host& host, Record& record, const windrow_wind* wind) {
    windrow_box box;
    WINDROW_AXES_OK(windrow_box_init(&box, sizeof box));
    WINDROW_AXES_OK(windrow_wind_box(wind, &box));
    record.extents("box.cells", box.cells, 0);
    record.extents("box.size", box.size, 1);
    // The middle is the same place, whatever corner is the low one.
    const std::array middle{box.origin.x + 0.5 * static_cast<double>(box.size.x),
                            box.origin.y + 0.5 * static_cast<double>(box.size.y),
                            box.origin.z + 0.5 * static_cast<double>(box.size.z)};
    record.vector("the middle of the box", windrow_dvec3{middle[0], middle[1], middle[2]}, 1);
    const windrow_dvec3 origin = windrow_wind_origin(wind);
    EXPECT_TRUE(origin.x == box.origin.x && origin.y == box.origin.y && origin.z == box.origin.z);
    record.number("floor", host.face(box.boundaries, 1, false).kind);
    record.number("wall", host.face(box.boundaries, 2, true).kind);
    record.number("open", host.face(box.boundaries, 2, false).kind);
    record.vector("wall velocity", host.face(box.boundaries, 2, true).wall_velocity, 1);
}

void record_air(const Host& host, Record& record, windrow_wind* wind) {
    windrow_sampling sampling;
    WINDROW_AXES_OK(windrow_sampling_init(&sampling, sizeof sampling));
    sampling.limit = host.single(2.5);
    sampling.detail = 0.25f;
    sampling.detail_length = host.single(2.0);
    EXPECT_EQ(windrow_sampling_validate(&sampling), WINDROW_OK);
    std::vector<windrow_dvec3> points;
    for (int n = 0; n < 300; ++n)
        points.push_back(host.place(-6.0 + 0.0625 * n, 0.75 + 0.25 * (n % 13), -8.0 + 0.5 * (n % 22)));
    for (std::size_t n = 0; n < points.size(); n += 37) {
        windrow_vec3 velocity{};
        WINDROW_AXES_OK(windrow_wind_velocity(wind, points[n], &velocity));
        record.vector("velocity", velocity, 1);
        WINDROW_AXES_OK(windrow_wind_felt(wind, points[n], &sampling, &velocity));
        record.vector("felt", velocity, 1);
    }
    // Many at once: doubles; floats with strides, relative to a camera.
    std::vector<windrow_vec3> found(points.size());
    windrow_query query;
    WINDROW_AXES_OK(windrow_query_init(&query, sizeof query));
    query.count = points.size();
    query.positions = points.data();
    query.velocities = &found[0].x;
    WINDROW_AXES_OK(windrow_wind_sample(wind, &query));
    for (const windrow_vec3& velocity : found)
        record.vector("sample", velocity, 1);
    struct Particle {
        float age;
        windrow_vec3 place;
        windrow_vec3 wind;
    };
    std::vector<Particle> particles;
    for (int n = 0; n < 20; ++n)
        particles.push_back({1.0f, host.vector(0.25 * n - 3.0, 0.5, 0.125 * n, 1), {}});
    query.count = particles.size();
    query.number = WINDROW_NUMBER_FLOAT;
    query.positions = &particles[0].place;
    query.velocities = &particles[0].wind.x;
    query.position_stride = query.velocity_stride = sizeof(Particle);
    query.anchor = host.place(1.0, 1.0, -2.0);
    query.sampling = &sampling;
    WINDROW_AXES_OK(windrow_wind_sample(wind, &query));
    for (const Particle& particle : particles)
        record.vector("particle", particle.wind, 1);
    query.number = 7;
    EXPECT_EQ(windrow_wind_sample(wind, &query), WINDROW_REJECTED);
}

void record_bits(Record& record, windrow_wind* wind) {
    const windrow_vec4* cells = nullptr;
    std::uint64_t count = 0;
    windrow_dvec3 origin{};
    WINDROW_AXES_OK(windrow_wind_field(wind, WINDROW_FRAME_NOW, &cells, &count, &origin));
    record.bytes(cells, count * sizeof *cells);
    record.bytes(&origin, sizeof origin); // the cells' own
    windrow_bytes* saved = nullptr;
    WINDROW_AXES_OK(windrow_wind_save(wind, &saved));
    record.bytes(windrow_bytes_data(saved), windrow_bytes_size(saved));
    windrow_bytes_destroy(saved);
    windrow_frame_block block;
    WINDROW_AXES_OK(windrow_wind_frame_block(wind, hosts()[0].place(0.0, 0.0, 0.0), nullptr, &block));
    record.bytes(&block, sizeof block);
    windrow_window_block window;
    WINDROW_AXES_OK(windrow_wind_window_block(wind, hosts()[0].place(0.0, 0.0, 0.0), &window));
    record.bytes(&window, sizeof window);
}

void record_report(Record& record, const windrow_diagnostics& report) {
    record.number("max_speed", static_cast<double>(report.max_speed), 1);
    record.number("energy", report.energy, 5);
    record.number("substeps", report.substeps);
    record.number("motors_in_reach", report.motors_in_reach);
    record.exact("divergence", report.divergence_rms);
}

void step(windrow_wind* wind, Record& record, int steps) {
    windrow_diagnostics report;
    WINDROW_AXES_OK(windrow_diagnostics_init(&report, sizeof report));
    for (int n = 0; n < steps; ++n)
        WINDROW_AXES_OK(windrow_wind_step(wind, 0.0625, &report));
    record_report(record, report);
}

TEST(AxesInC, TheAirOfABoxIsTheSame) {
    expect_same_for_all_hosts([](const Host& host, Record& record) {
        Settings all;
        fill_settings(host, all);
        EXPECT_EQ(windrow_config_validate(&all.config), WINDROW_OK) << windrow_last_error();
        windrow_wind* wind = nullptr;
        WINDROW_AXES_OK(windrow_wind_create(&all.config, &wind));
        record_config(record, wind);
        record_box(host, record, wind);
        step(wind, record, 3);
        WINDROW_AXES_OK(windrow_wind_set_ambient(wind, host.vector(2.0, 0.0, -1.0, 1)));
        record.vector("ambient", windrow_wind_ambient(wind), 1);
        all.gusts.length = host.single(12.0);
        WINDROW_AXES_OK(windrow_wind_set_gusts(wind, &all.gusts));
        WINDROW_AXES_OK(windrow_wind_follow(wind, host.place(4.0, 1.0, -3.0)));
        WINDROW_AXES_OK(windrow_wind_set_floor(wind, host.number(1.0)));
        step(wind, record, 2);
        WINDROW_AXES_OK(windrow_wind_shift_origin(wind, host.place(16.0, 0.0, -8.0)));
        record_box(host, record, wind);
        WINDROW_AXES_OK(windrow_wind_shift_origin(wind, host.place(-16.0, 0.0, 8.0)));
        windrow_boundaries boundaries = floor_and_walls(host);
        host.face(boundaries, 2, true).wall_velocity = host.vector(-1.0, 0.0, 0.0, 1);
        WINDROW_AXES_OK(windrow_wind_set_boundaries(wind, &boundaries));
        windrow_advance advance;
        windrow_diagnostics last;
        WINDROW_AXES_OK(windrow_advance_init(&advance, sizeof advance));
        WINDROW_AXES_OK(windrow_diagnostics_init(&last, sizeof last));
        WINDROW_AXES_OK(windrow_wind_advance(wind, 0.125, &advance, &last));
        record_report(record, last);
        record_air(host, record, wind);
        record_bits(record, wind);
        windrow_wind_destroy(wind);
    });
}

TEST(AxesInC, RowsCanopyAndRoughGroundAreTheSame) {
    expect_same_for_all_hosts([](const Host& host, Record& record) {
        Settings all;
        fill_settings(host, all);
        all.canopy.drag = host.single(0.5, -1);
        all.canopy.height = host.single(1.5);
        all.roughness.longest_mixing = host.single(2.0);
        all.rows.top = host.single(8.0);
        all.config.canopy = &all.canopy;
        all.config.roughness = &all.roughness;
        all.config.rows = &all.rows;
        windrow_wind* wind = nullptr;
        WINDROW_AXES_OK(windrow_wind_create(&all.config, &wind));
        step(wind, record, 2);
        record_config(record, wind);
        record_config(record, wind); // again: what the wind keeps is not converted twice
        record_bits(record, wind);
        windrow_wind_destroy(wind);
        for (std::size_t n = 0; n < all.heights.size(); ++n)
            all.heights[n] = host.single(0.25 + 0.5 * static_cast<double>(n));
        all.rows.height_count = static_cast<std::uint32_t>(all.heights.size());
        all.rows.heights = all.heights.data();
        all.rows.top = host.single(0.0);
        WINDROW_AXES_OK(windrow_wind_create(&all.config, &wind));
        record_config(record, wind);
        record_config(record, wind);
        windrow_wind_destroy(wind);
    });
}

// A size that ends within a field: what is left of a pointer is not followed.
TEST(AxesInC, ASizeOfNoStructIsConvertedUpToItsLastField) {
    WINDROW_AXES_OK(windrow_set_axes(WINDROW_AXES_Z_UP_LEFT, 0.01));
    windrow_config config;
    windrow_canopy canopy;
    WINDROW_AXES_OK(windrow_config_init(&config, sizeof config));
    WINDROW_AXES_OK(windrow_canopy_init(&canopy, sizeof canopy));
    config.canopy = &canopy;
    windrow_wind* wind = nullptr;
    WINDROW_AXES_OK(windrow_wind_create(&config, &wind));
    for (std::uint32_t size = 8; size <= sizeof config; ++size) {
        windrow_config out{};
        out.struct_size = size;
        WINDROW_AXES_OK(windrow_wind_config(wind, &out));
    }
    windrow_wind_destroy(wind);
    WINDROW_AXES_OK(windrow_set_axes(WINDROW_AXES_Y_UP_RIGHT, 1.0));
}

TEST(AxesInC, FollowedAxesAreTheHosts) {
    expect_same_for_all_hosts([](const Host& host, Record& record) {
        windrow_config config;
        WINDROW_AXES_OK(windrow_config_init(&config, sizeof config));
        config.cells = host.cells(12, 8, 10);
        const bool z_up = host.axes >= WINDROW_AXES_Z_UP_RIGHT;
        config.follow_axes = WINDROW_FOLLOW_X | (z_up ? WINDROW_FOLLOW_Z : WINDROW_FOLLOW_Y); // x and what points up
        windrow_wind* wind = nullptr;
        WINDROW_AXES_OK(windrow_wind_create(&config, &wind));
        WINDROW_AXES_OK(windrow_wind_follow(wind, host.place(20.0, 30.0, 40.0)));
        WINDROW_AXES_OK(windrow_config_init(&config, sizeof config));
        WINDROW_AXES_OK(windrow_wind_config(wind, &config));
        EXPECT_EQ(config.follow_axes, WINDROW_FOLLOW_X | (z_up ? WINDROW_FOLLOW_Z : WINDROW_FOLLOW_Y)) << host.name;
        step(wind, record, 1);
        record_box(host, record, wind);
        windrow_wind_destroy(wind);
    });
}

TEST(AxesInC, AVelocityByPlaceAndDebugLinesAreTheHosts) {
    expect_same_for_all_hosts([](const Host& host, Record& record) {
        windrow_config config;
        WINDROW_AXES_OK(windrow_config_init(&config, sizeof config));
        config.cells = host.cells(12, 8, 10);
        windrow_wind* wind = nullptr;
        WINDROW_AXES_OK(windrow_wind_create(&config, &wind));
        const auto velocity_at = [](void* user, const windrow_dvec3* centre, windrow_vec3* velocity) {
            const Host& its = *static_cast<const Host*>(user);
            const Numbers own = its.back({centre->x * its.unit, centre->y * its.unit, centre->z * its.unit});
            *velocity = its.vector(0.25 * own[1], 0.125 * own[2], -0.5 * own[0], 1);
        };
        WINDROW_AXES_OK(windrow_wind_set_velocity(wind, velocity_at, const_cast<Host*>(&host)));
        record_air(host, record, wind);
        record_bits(record, wind);
        windrow_debug_view view;
        WINDROW_AXES_OK(windrow_debug_view_init(&view, sizeof view));
        view.height = host.number(2.0);
        view.arrows = 4;
        const auto draw = [](void* user, const windrow_debug_line* line) {
            auto& heard = *static_cast<Record*>(user);
            heard.vector("begin", line->begin, 1);
            heard.vector("end", line->end, 1);
            heard.number("speed", static_cast<double>(line->speed), 1);
        };
        WINDROW_AXES_OK(windrow_wind_debug_lines(wind, &view, draw, &record));
        windrow_wind_destroy(wind);
    });
}

TEST(AxesInC, TheAmbientWindAloneIsTheSame) {
    expect_same_for_all_hosts([](const Host& host, Record& record) {
        Settings all;
        fill_settings(host, all);
        windrow_ambient_settings settings;
        WINDROW_AXES_OK(windrow_ambient_settings_init(&settings, sizeof settings));
        settings.mean = host.vector(4.0, 0.0, -2.0, 1);
        settings.profile = &all.profile;
        settings.gusts = &all.gusts;
        settings.ground = host.number(0.5);
        windrow_ambient_wind* wind = nullptr;
        WINDROW_AXES_OK(windrow_ambient_wind_create(&settings, &wind));
        WINDROW_AXES_OK(windrow_ambient_wind_advance(wind, 0.5));
        WINDROW_AXES_OK(windrow_ambient_wind_set_mean(wind, host.vector(3.0, 0.0, 1.0, 1)));
        WINDROW_AXES_OK(windrow_ambient_wind_set_ground(wind, host.number(0.25)));
        WINDROW_AXES_OK(windrow_ambient_wind_set_phase(wind, host.place(3.0, 0.0, 5.0)));
        record.vector("phase", windrow_ambient_wind_phase(wind), 1);
        record.number("period", windrow_ambient_wind_period(wind), 1);
        record.vector("mean", windrow_ambient_wind_mean(wind), 1);
        record.number("ground", windrow_ambient_wind_ground(wind), 1);
        record.number("profile", static_cast<double>(windrow_ambient_wind_profile_at(wind, host.number(5.0))));
        windrow_sampling sampling;
        WINDROW_AXES_OK(windrow_sampling_init(&sampling, sizeof sampling));
        sampling.strength = 0.5f;
        windrow_vec3 velocity{};
        WINDROW_AXES_OK(windrow_ambient_wind_velocity(wind, host.place(1.0, 2.0, 3.0), &velocity));
        record.vector("velocity", velocity, 1);
        WINDROW_AXES_OK(
            windrow_ambient_wind_felt(wind, host.place(1.0, 2.0, 3.0), &sampling, &velocity)); // goes in, and comes out
        record.vector("felt", velocity, 1);
        const windrow_vec3 kept = velocity;
        EXPECT_NE(windrow_ambient_wind_felt(nullptr, host.place(1.0, 2.0, 3.0), &sampling, &velocity), WINDROW_OK);
        EXPECT_TRUE(velocity.x == kept.x && velocity.y == kept.y && velocity.z == kept.z) << "a call that fails changes nothing";
        windrow_ambient_block block;
        WINDROW_AXES_OK(windrow_ambient_wind_block(wind, host.place(8.0, 0.0, -4.0), &sampling, &block));
        record.bytes(&block, sizeof block);
        windrow_ambient_wind_destroy(wind);
        windrow_uniform_gust gust;
        WINDROW_AXES_OK(windrow_uniform_gust_init(&gust, sizeof gust));
        gust.mean = host.single(3.0);
        gust.amplitude = host.single(1.0);
        gust.period = 4.0f;
        gust.direction = host.vector(1.0, 0.0, 2.0, 0);
        WINDROW_AXES_OK(windrow_uniform_gust_velocity(&gust, 1.5, &velocity));
        record.vector("uniform gust", velocity, 1);
    });
}

TEST(AxesInC, AWrongUnitIsRejectedAndTheMatrixTurnsPlaces) {
    EXPECT_EQ(windrow_set_axes(4, 1.0), WINDROW_REJECTED);
    EXPECT_EQ(windrow_set_axes(WINDROW_AXES_Z_UP_LEFT, 0.0), WINDROW_REJECTED);
    EXPECT_EQ(windrow_set_axes(WINDROW_AXES_Z_UP_LEFT, std::nan("")), WINDROW_REJECTED);
    for (const Host& host : hosts()) {
        WINDROW_AXES_OK(windrow_set_axes(host.axes, host.unit));
        std::array<double, 16> matrix{};
        WINDROW_AXES_OK(windrow_axes_matrix(matrix.data()));
        const windrow_dvec3 place = host.place(1.0, 2.0, -3.0);
        const Numbers own{1.0, 2.0, -3.0};
        for (std::size_t row = 0; row < 3; ++row)
            EXPECT_NEAR(matrix[row] * place.x + matrix[4 + row] * place.y + matrix[8 + row] * place.z + matrix[12 + row],
                        own[row], 1e-12)
                << host.name;
        EXPECT_EQ(matrix[15], 1.0);
    }
    WINDROW_AXES_OK(windrow_set_axes(WINDROW_AXES_Y_UP_RIGHT, 1.0));
}

TEST(AxesInC, AWindInsideAnotherIsTheSame) {
    expect_same_for_all_hosts([](const Host& host, Record& record) {
        windrow_config config;
        WINDROW_AXES_OK(windrow_config_init(&config, sizeof config));
        config.cells = host.cells(14, 6, 12);
        config.cell_size = host.single(2.0);
        config.boundaries = windrow_boundaries_open_over_floor();
        config.ambient = host.vector(4.0, 0.0, 1.0, 1);
        windrow_wind *outer = nullptr, *inner = nullptr, *loaded = nullptr;
        WINDROW_AXES_OK(windrow_wind_create(&config, &outer));
        windrow_directional_motor fan;
        WINDROW_AXES_OK(windrow_directional_motor_init(&fan, sizeof fan));
        fan.direction = host.vector(1.0, 0.0, 0.0, 0);
        fan.position = host.place(-7.0, 3.0, 0.0);
        WINDROW_AXES_OK(windrow_wind_add_directional(outer, &fan, nullptr));
        WINDROW_AXES_OK(windrow_wind_step(outer, 0.25, nullptr));
        config.cells = host.cells(10, 6, 8);
        config.cell_size = host.single(1.0);
        config.ambient = {};
        WINDROW_AXES_OK(windrow_wind_create_inside(&config, outer, &inner));
        windrow_vec3 found{};
        for (int n = 0; n < 2; ++n) {
            WINDROW_AXES_OK(windrow_wind_step(inner, 0.0625, nullptr));
            WINDROW_AXES_OK(windrow_wind_velocity(inner, host.place(-2.5, 2.25, -0.75), &found));
            record.vector("velocity inside", found, 1);
        }
        windrow_bytes* saved = nullptr;
        WINDROW_AXES_OK(windrow_wind_save(inner, &saved));
        WINDROW_AXES_OK(windrow_wind_load_inside(windrow_bytes_data(saved), windrow_bytes_size(saved), nullptr, outer, &loaded));
        windrow_bytes_destroy(saved);
        windrow_wind_destroy(outer); // the two inside keep it
        WINDROW_AXES_OK(windrow_wind_step(loaded, 0.0625, nullptr));
        WINDROW_AXES_OK(windrow_wind_velocity(loaded, host.place(-2.5, 2.25, -0.75), &found));
        record.vector("velocity again", found, 1);
        windrow_wind_destroy(loaded);
        windrow_wind_destroy(inner);
    });
}

} // namespace
