// Motors, obstacles, deposits of drag, forms, operators and VDB films by hosts of other axes and units.
#include "tests/c_api/axes_host.h"
#include "tests/shapes.h"

#include <filesystem>
#include <random>

namespace {

using namespace windrow::test;

windrow_wind* air(const Host& host) {
    windrow_config config;
    EXPECT_EQ(windrow_config_init(&config, sizeof config), WINDROW_OK);
    config.cells = host.cells(16, 10, 13);
    config.boundaries = windrow_boundaries_open_over_floor();
    config.ambient = host.vector(2.0, 0.0, 0.5, 1);
    windrow_wind* wind = nullptr;
    EXPECT_EQ(windrow_wind_create(&config, &wind), WINDROW_OK) << windrow_last_error();
    return wind;
}

void finish(Record& record, windrow_wind* wind, int steps) {
    windrow_diagnostics report;
    WINDROW_AXES_OK(windrow_diagnostics_init(&report, sizeof report));
    for (int n = 0; n < steps; ++n)
        WINDROW_AXES_OK(windrow_wind_step(wind, 0.0625, &report));
    record.number("max_speed", static_cast<double>(report.max_speed), 1);
    record.number("energy", report.energy, 5);
    record.number("motors", report.motors_in_reach);
    const windrow_vec4* cells = nullptr;
    std::uint64_t count = 0;
    WINDROW_AXES_OK(windrow_wind_field(wind, WINDROW_FRAME_NOW, &cells, &count, nullptr));
    record.bytes(cells, count * sizeof *cells);
    for (std::uint64_t n = 0; n < count; n += 97) { // the library's own, for all hosts
        record.number("u", static_cast<double>(cells[n].x));
        record.number("v", static_cast<double>(cells[n].y));
        record.number("w", static_cast<double>(cells[n].z));
    }
}

void law(const Host& host, Record& record, const windrow_law& heard) {
    record.number("law.acceleration", static_cast<double>(heard.acceleration), 1);
    record.number("law.speed", static_cast<double>(heard.speed), 1);
    record.number("law.rate", static_cast<double>(heard.rate));
    (void)host;
}

TEST(AxesInC, MotorsBlowTheSame) {
    expect_same_for_all_hosts([](const Host& host, Record& record) {
        windrow_wind* const wind = air(host);
        std::array<windrow_motor_id, 8> ids{};
        windrow_directional_motor fan;
        WINDROW_AXES_OK(windrow_directional_motor_init(&fan, sizeof fan));
        fan.direction = host.vector(0.0, 1.0, 2.0, 0);
        fan.position = host.place(1.0, 3.0, -2.0);
        fan.region = windrow_region_box(host.extents(2.0, 1.0, 3.0, 1));
        fan.law = windrow_law_force(host.single(4.0));
        fan.turbulence.length = host.single(2.0);
        WINDROW_AXES_OK(windrow_wind_add_directional(wind, &fan, &ids[0]));
        fan.region = windrow_region_capsule(host.vector(1.0, 0.5, -1.0, 1), host.single(1.5));
        WINDROW_AXES_OK(windrow_wind_add_directional(wind, &fan, &ids[6]));
        fan.region = windrow_region_cone(host.vector(0.0, 1.0, 4.0, 1), host.single(0.5), host.single(2.0));
        WINDROW_AXES_OK(windrow_wind_set_directional(wind, ids[0], &fan));
        windrow_wake_motor wake;
        WINDROW_AXES_OK(windrow_wake_motor_init(&wake, sizeof wake));
        record.number("default radius", static_cast<double>(wake.radius), 1);
        wake.position = host.place(-4.0, 1.5, 0.0);
        wake.radius = host.single(1.25);
        wake.law = windrow_wake_law_drive(host.single(2.0, -1), 0.5f);
        WINDROW_AXES_OK(windrow_wind_add_wake(wind, &wake, &ids[1]));
        WINDROW_AXES_OK(windrow_wind_set_wake(wind, ids[1], &wake));
        windrow_jet_motor jet;
        WINDROW_AXES_OK(windrow_jet_motor_init(&jet, sizeof jet));
        jet.direction = host.vector(-1.0, 0.0, 1.0, 0);
        jet.position = host.place(5.0, 2.0, 1.0);
        jet.length = host.single(5.0);
        jet.law = windrow_law_drive(host.single(8.0), 3.0f);
        WINDROW_AXES_OK(windrow_wind_add_jet(wind, &jet, &ids[2]));
        WINDROW_AXES_OK(windrow_wind_set_jet(wind, ids[2], &jet));
        windrow_vortex_motor vortex;
        WINDROW_AXES_OK(windrow_vortex_motor_init(&vortex, sizeof vortex));
        vortex.axis = host.axial(0.25, 1.0, 0.5);
        vortex.position = host.place(0.0, 4.0, 3.0);
        vortex.radius = host.single(3.0);
        vortex.half_length = host.single(2.0);
        vortex.lift = static_cast<float>(host.hand) * 0.5f; // along the host's own axis
        WINDROW_AXES_OK(windrow_wind_add_vortex(wind, &vortex, &ids[3]));
        WINDROW_AXES_OK(windrow_wind_set_vortex(wind, ids[3], &vortex));
        windrow_omni_motor omni;
        WINDROW_AXES_OK(windrow_omni_motor_init(&omni, sizeof omni));
        omni.position = host.place(-2.0, 3.0, -4.0);
        omni.radius = host.single(1.5);
        WINDROW_AXES_OK(windrow_wind_add_omni(wind, &omni, &ids[4]));
        WINDROW_AXES_OK(windrow_wind_set_omni(wind, ids[4], &omni));
        windrow_pressure_motor burst;
        WINDROW_AXES_OK(windrow_pressure_motor_init(&burst, sizeof burst));
        burst.position = host.place(3.0, 4.0, 2.0);
        burst.speed = host.single(6.0);
        WINDROW_AXES_OK(windrow_wind_add_pressure(wind, &burst, &ids[5]));
        WINDROW_AXES_OK(windrow_wind_set_pressure(wind, ids[5], &burst));
        WINDROW_AXES_OK(windrow_wind_move_motor(wind, ids[1], host.place(-3.5, 1.5, 0.5)));

        WINDROW_AXES_OK(windrow_wind_get_directional(wind, ids[0], &fan));
        record.vector("fan.direction", fan.direction, 0);
        record.vector("fan.position", fan.position, 1);
        record.vector("fan.region.axis", fan.region.axis, 1);
        record.number("fan.region.end_radius", static_cast<double>(fan.region.end_radius), 1);
        law(host, record, fan.law);
        WINDROW_AXES_OK(windrow_wind_get_directional(wind, ids[6], &fan));
        record.vector("fan.region.half_axis", fan.region.half_axis, 1);
        WINDROW_AXES_OK(windrow_wind_get_wake(wind, ids[1], &wake));
        record.number("wake.per_metre", static_cast<double>(wake.law.per_metre), -1);
        record.vector("wake.position", wake.position, 1);
        WINDROW_AXES_OK(windrow_wind_get_jet(wind, ids[2], &jet));
        record.vector("jet.direction", jet.direction, 0);
        record.number("jet.end_radius", static_cast<double>(jet.end_radius), 1);
        law(host, record, jet.law);
        WINDROW_AXES_OK(windrow_wind_get_vortex(wind, ids[3], &vortex));
        record.axial("vortex.axis", vortex.axis, 0);
        record.number("vortex.lift", host.hand * static_cast<double>(vortex.lift));
        WINDROW_AXES_OK(windrow_wind_get_omni(wind, ids[4], &omni));
        record.number("omni.speed", static_cast<double>(omni.speed), 1);
        WINDROW_AXES_OK(windrow_wind_get_pressure(wind, ids[5], &burst));
        record.vector("burst.position", burst.position, 1);
        finish(record, wind, 4);
        windrow_wind_destroy(wind);
    });
}

windrow_obstacle placed(const Host& host, const windrow_shape& shape, const windrow_dvec3& position) {
    windrow_obstacle obstacle;
    EXPECT_EQ(windrow_obstacle_init(&obstacle, sizeof obstacle), WINDROW_OK);
    obstacle.shape = shape;
    obstacle.position = position;
    obstacle.orientation = host.turn(0.0, 1.0, 0.0, 0.25);
    return obstacle;
}

/// A wedge that is the same along no axis.
windrow_mesh* wedge(const Host& host) {
    const windrow::MeshData ball = ball_mesh(1.0f, 2);
    std::vector<windrow_vec3> vertices;
    for (const glm::vec3& v : ball.vertices)
        vertices.push_back(host.vector(static_cast<double>(v.x) * 1.5 + 0.25 * static_cast<double>(v.z), static_cast<double>(v.y),
                                       static_cast<double>(v.z) * (v.z > 0.0f ? 2.0 : 0.75), 1));
    std::vector<std::uint32_t> indices;
    for (const auto& triangle : ball.triangles)
        for (const int corner : host.hand > 0.0 ? std::array{0, 1, 2} : std::array{0, 2, 1}) // counter-clockwise to the host
            indices.push_back(triangle[corner]);
    windrow_mesh* mesh = nullptr;
    EXPECT_EQ(windrow_mesh_create(vertices.data(), vertices.size(), indices.data(), indices.size() / 3, &mesh), WINDROW_OK)
        << windrow_last_error();
    return mesh;
}

windrow_voxels* stairs(const Host& host) {
    const std::array<int, 3> size{4, 3, 2};
    std::vector<std::uint8_t> closed(24);
    for (int k = 0; k < size[2]; ++k)
        for (int j = 0; j < size[1]; ++j)
            for (int i = 0; i < size[0]; ++i)
                closed[host.index({i, j, k}, size)] = i + j + 2 * k < 4;
    windrow_voxels* voxels = nullptr;
    EXPECT_EQ(windrow_voxels_create(host.cells(4, 3, 2), closed.data(), closed.size(), &voxels), WINDROW_OK)
        << windrow_last_error();
    EXPECT_EQ(windrow_voxels_create(host.cells(4, 3, 2), closed.data(), 7, &voxels), WINDROW_REJECTED);
    EXPECT_EQ(windrow_voxels_create(host.cells(4, 3, 2), closed.data(), closed.size(), &voxels), WINDROW_OK);
    return voxels;
}

constexpr int k_columns = 6, k_rows = 4;
/// Hills of 5 m x 3 m, with a hole in one corner: a host's rows go along its own second level axis.
windrow_height_map* hills(const Host& host, bool holes) {
    std::vector<float> heights(k_columns * k_rows);
    for (int k = 0; k < k_rows; ++k)
        for (int i = 0; i < k_columns; ++i)
            heights[host.index({i, 0, k}, {k_columns, 1, k_rows})] = host.single(0.25 * i + 0.5 * k * k);
    std::vector<std::uint8_t> open(6);
    open[host.index({2, 0, 1}, {3, 1, 2})] = 1;
    windrow_height_map* map = nullptr;
    if (holes)
        EXPECT_EQ(windrow_height_map_create_with_holes({k_columns, k_rows}, host.single(1.0), heights.data(), heights.size(),
                                                       {3, 2}, open.data(), open.size(), &map),
                  WINDROW_OK)
            << windrow_last_error();
    else
        EXPECT_EQ(windrow_height_map_create({k_columns, k_rows}, host.single(1.0), heights.data(), heights.size(), &map),
                  WINDROW_OK);
    return map;
}
/// A place of a map by its first corner to the host, which is the far one of the library where an axis is mirrored.
double along(const Host& host, double z) {
    return static_cast<double>(host.level(0.0, 1.0, 0).y) < 0.0 ? z - (k_rows - 1) : z;
}

void record_obstacle(Record& record, const windrow_wind* wind, windrow_obstacle_id id) {
    windrow_obstacle heard;
    WINDROW_AXES_OK(windrow_obstacle_init(&heard, sizeof heard));
    WINDROW_AXES_OK(windrow_wind_get_obstacle(wind, id, &heard));
    record.turn("orientation", heard.orientation);
    record.extents("half_size", heard.shape.half_size, 1);
    record.vector("half_axis", heard.shape.half_axis, 1);
    record.number("radius", static_cast<double>(heard.shape.radius), 1);
    record.number("half_length", static_cast<double>(heard.shape.half_length), 1);
    if (heard.shape.kind != WINDROW_SHAPE_GROUND)
        record.vector("position", heard.position, 1);
}

TEST(AxesInC, ObstaclesStandAndMoveTheSame) {
    expect_same_for_all_hosts([](const Host& host, Record& record) {
        windrow_wind* const wind = air(host);
        windrow_mesh* const mesh = wedge(host);
        windrow_voxels* const voxels = stairs(host);
        record.number("distance", static_cast<double>(windrow_mesh_distance(mesh, host.vector(0.25, 0.5, 2.5, 1))), 1);
        windrow_shape plate = windrow_shape_plate({host.single(1.5), host.single(0.75)});
        plate.half_size = host.extents(1.5, 0.75, 0.0, 1); // as made: x and y of the library
        const windrow_shape made_plate = windrow_shape_plate({host.single(1.5), host.single(0.75)});
        EXPECT_TRUE(std::memcmp(&plate.half_size, &made_plate.half_size, sizeof plate.half_size) == 0) << host.name;
        const std::array shapes{windrow_shape_sphere(host.single(1.0)),
                                windrow_shape_capsule(host.vector(0.5, 1.0, 0.75, 1), host.single(0.75)),
                                windrow_shape_block(host.extents(1.0, 2.0, 1.5, 1)),
                                windrow_shape_cylinder(host.single(0.75), host.single(1.5)),
                                plate,
                                windrow_shape_mesh(mesh, 0.75f),
                                windrow_shape_voxels(voxels, host.single(0.75))};
        std::vector<windrow_obstacle_id> ids;
        for (std::size_t n = 0; n < shapes.size(); ++n) {
            const auto number = static_cast<double>(n);
            const windrow_obstacle obstacle =
                placed(host, shapes[n], host.place(-6.0 + 2.0 * number, 2.0 + 0.5 * number, 1.0 - 0.75 * number));
            ids.emplace_back();
            WINDROW_AXES_OK(windrow_wind_add_obstacle(wind, &obstacle, &ids.back()));
            WINDROW_AXES_OK(windrow_wind_set_obstacle(wind, ids.back(), &obstacle));
            record_obstacle(record, wind, ids.back());
        }
        finish(record, wind, 1);
        const windrow_quat turned = host.turn(1.0, 0.5, 0.25, 0.375);
        const windrow_vec3 spin = host.axial(0.5, 1.0, -0.25);
        WINDROW_AXES_OK(windrow_wind_move_obstacle(wind, ids[2], host.place(-1.75, 3.0, -0.5), &turned, &spin));
        WINDROW_AXES_OK(windrow_wind_move_obstacle(wind, ids[5], host.place(4.25, 4.5, -2.5), nullptr, nullptr));
        finish(record, wind, 2);
        for (const windrow_obstacle_id& id : ids) {
            record_obstacle(record, wind, id);
            windrow_obstacle_force force;
            WINDROW_AXES_OK(windrow_obstacle_force_init(&force, sizeof force));
            WINDROW_AXES_OK(windrow_wind_force_on(wind, id, &force));
            if (host.exact) {
                record.vector("force", force.force, 1);
                record.axial("moment", force.moment, 2);
                record.number("pressure", static_cast<double>(force.pressure), -1);
            } else
                for (int n = 0; n < 7; ++n)
                    record.exact("force", 0.0); // rounding of a surface moves whole faces
        }
        windrow_wind_destroy(wind);
        windrow_mesh_destroy(mesh);
        windrow_voxels_destroy(voxels);
    });
}

TEST(AxesInC, HillsLieTheSame) {
    expect_same_for_all_hosts([](const Host& host, Record& record) {
        windrow_wind* const wind = air(host);
        windrow_height_map* const map = hills(host, true);
        windrow_height_map* const lengths = hills(host, false);
        const windrow_vec2 place = host.level(1.25, along(host, 0.75), 1);
        record.number("height", static_cast<double>(windrow_height_map_height(map, place)), 1);
        record.vector("normal", windrow_height_map_normal(map, place), 0);
        windrow_shape shape = windrow_shape_ground(map, host.extents(1.5, 1.0, 2.0, 0));
        shape.beyond = WINDROW_BEYOND_NOTHING;
        windrow_obstacle ground = placed(host, shape, host.place(-3.0, 0.5, -2.0));
        ground.orientation = {0.0f, 0.0f, 0.0f, 1.0f};
        // The host's first corner is (k_rows - 1) rows of 2 m away from the library's where the axis is mirrored.
        const double far = 2.0 * (0.0 - along(host, 0.0));
        ground.position = host.place(-3.0, 0.5, -2.0 + far);
        windrow_obstacle_id id{};
        WINDROW_AXES_OK(windrow_wind_add_obstacle(wind, &ground, &id));
        windrow_obstacle heard;
        WINDROW_AXES_OK(windrow_obstacle_init(&heard, sizeof heard));
        WINDROW_AXES_OK(windrow_wind_get_obstacle(wind, id, &heard));
        record.number("x", heard.position.x, 1);
        EXPECT_NEAR(heard.position.y, ground.position.y, 1e-9) << host.name;
        EXPECT_NEAR(heard.position.z, ground.position.z, 1e-9) << host.name;
        finish(record, wind, 1);
        WINDROW_AXES_OK(windrow_wind_move_obstacle(wind, id, host.place(-2.5, 0.5, -2.0 + far), nullptr, nullptr));
        finish(record, wind, 2);
        windrow_wind_destroy(wind);

        windrow_config config;
        windrow_roughness roughness;
        windrow_roughness_map rough;
        WINDROW_AXES_OK(windrow_config_init(&config, sizeof config));
        WINDROW_AXES_OK(windrow_roughness_init(&roughness, sizeof roughness));
        WINDROW_AXES_OK(windrow_roughness_map_init(&rough, sizeof rough));
        config.cells = host.cells(16, 10, 13);
        config.boundaries = windrow_boundaries_open_over_floor();
        config.ambient = host.vector(4.0, 0.0, 1.0, 1);
        rough.lengths = lengths;
        rough.scale = host.extents(1.0, 0.25, 2.0, 0);
        rough.position = host.place(-3.0, 0.03125, -2.0 + far);
        roughness.map = &rough;
        config.roughness = &roughness;
        windrow_wind* other = nullptr;
        WINDROW_AXES_OK(windrow_wind_create(&config, &other));
        finish(record, other, 2);
        windrow_wind_destroy(other);
        windrow_height_map_destroy(map);
        windrow_height_map_destroy(lengths);
    });
}

TEST(AxesInC, DragSlowsTheSame) {
    expect_same_for_all_hosts([](const Host& host, Record& record) {
        windrow_wind* const wind = air(host);
        windrow_plant_drag plant;
        WINDROW_AXES_OK(windrow_plant_drag_init(&plant, sizeof plant));
        plant.position = host.place(2.0, 0.0, 1.0);
        plant.area = host.single(3.0, 2);
        plant.radius = host.single(1.25);
        windrow_drag_id bush{}, hedge{};
        WINDROW_AXES_OK(windrow_wind_add_plant_drag(wind, &plant, &bush));
        WINDROW_AXES_OK(windrow_wind_set_plant_drag(wind, bush, &plant));
        windrow_belt_drag belt;
        WINDROW_AXES_OK(windrow_belt_drag_init(&belt, sizeof belt));
        belt.start = host.place(-4.0, 0.0, -3.0);
        belt.end = host.place(-3.0, 0.25, 4.0);
        WINDROW_AXES_OK(windrow_wind_add_belt_drag(wind, &belt, &hedge));
        WINDROW_AXES_OK(windrow_wind_set_belt_drag(wind, hedge, &belt));
        std::array<windrow_plant_drag, 3> many{plant, plant, plant};
        for (std::size_t n = 0; n < many.size(); ++n)
            many[n].position = host.place(4.0 + static_cast<double>(n), 0.0, -3.0);
        std::array<windrow_drag_id, 3> ids{};
        WINDROW_AXES_OK(windrow_wind_add_plants(wind, many.data(), many.size(), ids.data()));
        WINDROW_AXES_OK(windrow_wind_get_plant_drag(wind, ids[2], &plant));
        record.vector("plant.position", plant.position, 1);
        record.number("plant.area", static_cast<double>(plant.area), 2);
        WINDROW_AXES_OK(windrow_wind_get_belt_drag(wind, hedge, &belt));
        record.vector("belt.end", belt.end, 1);
        finish(record, wind, 3);
        windrow_drag_force force;
        WINDROW_AXES_OK(windrow_drag_force_init(&force, sizeof force));
        WINDROW_AXES_OK(windrow_wind_drag_force_on(wind, hedge, &force));
        record.vector("force", force.force, 1);
        windrow_tracer* smoke = nullptr;
        WINDROW_AXES_OK(windrow_tracer_create(wind, nullptr, &smoke));
        WINDROW_AXES_OK(windrow_tracer_blow(smoke, host.place(1.0, 2.0, -1.0), host.single(2.0)));
        std::uint64_t count = 0;
        const float* const cells = windrow_tracer_cells(smoke, &count);
        record.bytes(cells, count * sizeof *cells);
        windrow_tracer_destroy(smoke);
        windrow_wind_destroy(wind);
    });
}

TEST(AxesInC, OperatorsAndFilmsAreTheSame) {
    expect_same_for_all_hosts([](const Host& host, Record& record) {
        windrow_config config;
        WINDROW_AXES_OK(windrow_config_init(&config, sizeof config));
        config.cells = host.cells(12, 8, 10);
        windrow_workspace* work = nullptr;
        WINDROW_AXES_OK(windrow_workspace_create(&config, &work));
        const windrow_boundaries boundaries = windrow_boundaries_open_over_floor();
        WINDROW_AXES_OK(windrow_workspace_set_boundaries(work, &boundaries));
        WINDROW_AXES_OK(windrow_workspace_set_ambient(work, host.vector(2.0, 0.0, 1.0, 1)));
        const windrow_obstacle block =
            placed(host, windrow_shape_block(host.extents(1.0, 1.5, 2.0, 1)), host.place(5.0, 3.0, 4.0));
        const windrow_vec3 velocity = host.vector(0.0, 0.0, 1.0, 1), spin = host.axial(0.0, 0.5, 0.0);
        WINDROW_AXES_OK(windrow_workspace_set_obstacles(work, &block, &velocity, &spin, 1));
        struct alignas(16) Cell {
            windrow_vec4 v;
        };
        std::vector<Cell> field(960, {{2.0f, 0.0f, 1.0f, 0.0f}}), result(960);
        WINDROW_AXES_OK(windrow_project(work, &field[0].v, nullptr, nullptr, 960));
        windrow_vec3 impulse{};
        WINDROW_AXES_OK(windrow_workspace_impulse_on(work, 0, &impulse));
        record.vector("impulse", impulse, 4);
        windrow_diffusion_method method = 0;
        WINDROW_AXES_OK(windrow_diffuse(work, &field[0].v, host.single(0.125, 2), 0.25f, &result[0].v, &method, 960));
        record.bytes(result.data(), result.size() * sizeof result[0]);
        windrow_workspace_destroy(work);
        if (!windrow_has_part(WINDROW_PART_VDB))
            return;
        windrow_wind* const wind = air(host);
        windrow_vdb_film film;
        WINDROW_AXES_OK(windrow_vdb_film_init(&film, sizeof film));
        const windrow_dvec3 a = host.place(-4.0, 1.0, -3.0), b = host.place(5.0, 4.0, 2.0);
        film.has_region = 1;
        film.low = {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
        film.high = {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
        film.voxel_size = host.single(0.5);
        const std::filesystem::path file = std::filesystem::temp_directory_path() / "windrow_axes_film.vdb";
        WINDROW_AXES_OK(windrow_vdb_write_film(wind, &film, file.string().c_str(), nullptr));
        record.exact("bytes of a film", static_cast<double>(std::filesystem::file_size(file)));
        std::filesystem::remove(file);
        windrow_wind_destroy(wind);
    });
}

/// Any motors and bodies, moved anywhere; each seed is a story of its own.
TEST(AxesInC, RandomCallsAreTheSame) {
    for (unsigned seed = 1; seed <= 8; ++seed)
        expect_same_for_all_hosts([seed](const Host& host, Record& record) {
            std::mt19937 random(seed);
            const auto any = [&](int low, int high) {
                return 0.125 * static_cast<double>(low + static_cast<int>(random() % static_cast<unsigned>(high - low)));
            };
            windrow_wind* const wind = air(host);
            std::vector<windrow_motor_id> motors;
            std::vector<windrow_obstacle_id> bodies;
            for (int call = 0; call < 24; ++call) {
                const double x = any(-56, 56), y = any(4, 64), z = any(-44, 44), size = any(4, 16);
                const windrow_dvec3 place = host.place(x, y, z);
                switch (random() % 6) {
                case 0: {
                    windrow_jet_motor jet;
                    WINDROW_AXES_OK(windrow_jet_motor_init(&jet, sizeof jet));
                    jet.position = place;
                    jet.direction = host.vector(y, z, x, 0);
                    jet.start_radius = jet.end_radius = host.single(size);
                    motors.emplace_back();
                    WINDROW_AXES_OK(windrow_wind_add_jet(wind, &jet, &motors.back()));
                    break;
                }
                case 1: {
                    windrow_vortex_motor vortex;
                    WINDROW_AXES_OK(windrow_vortex_motor_init(&vortex, sizeof vortex));
                    vortex.position = place;
                    vortex.axis = host.axial(x, y, z);
                    motors.emplace_back();
                    WINDROW_AXES_OK(windrow_wind_add_vortex(wind, &vortex, &motors.back()));
                    break;
                }
                case 2: {
                    windrow_obstacle body = placed(host, windrow_shape_block(host.extents(size, 1.0, 0.5 * size, 1)), place);
                    body.orientation = {0.0f, 0.0f, 0.0f, 1.0f};
                    bodies.emplace_back();
                    WINDROW_AXES_OK(windrow_wind_add_obstacle(wind, &body, &bodies.back()));
                    break;
                }
                case 3:
                    if (!motors.empty()) {
                        WINDROW_AXES_OK(windrow_wind_move_motor(wind, motors[random() % motors.size()], place));
                    }
                    break;
                case 4:
                    WINDROW_AXES_OK(windrow_wind_follow(wind, host.place(0.25 * x, y, 0.25 * z)));
                    break;
                default: {
                    windrow_vec3 velocity{};
                    WINDROW_AXES_OK(windrow_wind_velocity(wind, place, &velocity));
                    if (host.exact)
                        record.vector("velocity", velocity, 1);
                    else
                        for (int n = 0; n < 3; ++n)
                            record.exact("velocity", 0.0);
                    WINDROW_AXES_OK(windrow_wind_step(wind, 0.03125, nullptr));
                }
                }
            }
            const windrow_vec4* cells = nullptr;
            std::uint64_t count = 0;
            WINDROW_AXES_OK(windrow_wind_field(wind, WINDROW_FRAME_NOW, &cells, &count, nullptr));
            record.number("cells", static_cast<double>(count));
            record.bytes(cells, count * sizeof *cells);
            windrow_wind_destroy(wind);
        });
}

} // namespace
