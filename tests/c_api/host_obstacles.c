/* Obstacles of each shape, terrain, forces. */
#include "host.h"

static windrow_mesh* tetrahedron(void) {
    static const windrow_vec3 corners[4] = {{0.0f, 0.0f, 0.0f}, {2.0f, 0.0f, 0.0f}, {0.0f, 2.0f, 0.0f}, {0.0f, 0.0f, 2.0f}};
    static const uint32_t faces[12] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
    windrow_mesh* mesh = NULL;
    CHECK_FAILS(windrow_mesh_create(corners, 4, faces, 3, &mesh), WINDROW_REJECTED, "edge");
    CHECK_OK(windrow_mesh_create(corners, 4, faces, 4, &mesh));
    CHECK(windrow_mesh_distance(mesh, vec3(0.3f, 0.3f, 0.3f)) < 0.0f &&
          windrow_mesh_distance(mesh, vec3(5.0f, 0.0f, 0.0f)) > 2.9f);
    return mesh;
}

static windrow_height_map* hill(void) {
    static float heights[9 * 9];
    windrow_height_map* map = NULL;
    windrow_ivec2 corners;
    int n;
    for (n = 0; n < 81; ++n)
        heights[n] = 0.02f * (float)((n % 9) * (8 - n % 9)) * (float)((n / 9) * (8 - n / 9)) / 16.0f;
    corners.x = corners.y = 9;
    CHECK_FAILS(windrow_height_map_create(corners, 4.0f, heights, 80, &map), WINDROW_REJECTED, "give 81");
    {
        static const uint8_t open[4] = {0, 1, 0, 0}, everywhere[4] = {1, 1, 1, 1};
        windrow_ivec2 cells;
        cells.x = cells.y = 2;
        CHECK_FAILS(windrow_height_map_create_with_holes(corners, 4.0f, heights, 81, cells, open, 3, &map), WINDROW_REJECTED,
                    "give 4");
        CHECK_FAILS(windrow_height_map_create_with_holes(corners, 4.0f, heights, 81, cells, everywhere, 4, &map), WINDROW_REJECTED,
                    "is a hole everywhere");
        CHECK_OK(windrow_height_map_create_with_holes(corners, 4.0f, heights, 81, cells, open, 4, &map));
        windrow_height_map_destroy(map);
    }
    CHECK_OK(windrow_height_map_create(corners, 4.0f, heights, 81, &map));
    {
        windrow_vec2 top;
        top.x = top.y = 16.0f;
        CHECK(windrow_height_map_height(map, top) == heights[40] && windrow_height_map_normal(map, top).y > 0.9f);
    }
    return map;
}

static void add(windrow_wind* wind, windrow_shape shape, windrow_dvec3 position, windrow_obstacle_id* id) {
    windrow_obstacle obstacle, got;
    CHECK_OK(windrow_obstacle_init(&obstacle, sizeof obstacle));
    obstacle.shape = shape;
    obstacle.position = position;
    CHECK_OK(windrow_wind_add_obstacle(wind, &obstacle, id));
    CHECK_OK(windrow_obstacle_init(&got, sizeof got));
    CHECK_OK(windrow_wind_get_obstacle(wind, *id, &got));
    CHECK(got.shape.kind == shape.kind && got.shape.radius == shape.radius && got.shape.beyond == shape.beyond &&
          got.position.x == position.x && got.orientation.w == 1.0f);
}

void check_obstacles(void) {
    enum { CELLS = 24 * 12 * 24 };
    static float inside[CELLS];
    static const uint8_t closed[8] = {1, 0, 1, 1, 0, 1, 1, 1};
    windrow_config config = small_config();
    windrow_roughness roughness;
    windrow_roughness_map lengths;
    windrow_wind* wind = NULL;
    windrow_mesh* mesh = tetrahedron();
    windrow_height_map* map = hill();
    windrow_voxels* voxels = NULL;
    windrow_ivec3 cells = {2, 2, 2};
    windrow_vec2 sheet = {1.0f, 2.0f};
    windrow_obstacle_id house, id;
    windrow_obstacle obstacle;
    windrow_obstacle_force force;
    windrow_quat turned = {0.0f, 0.3826834f, 0.0f, 0.9238795f};
    windrow_vec3 lee;
    int n, count = 0;

    CHECK_FAILS(windrow_voxels_create(cells, closed, 7, &voxels), WINDROW_REJECTED, "7");
    CHECK_OK(windrow_voxels_create(cells, closed, 8, &voxels));
    CHECK_OK(windrow_roughness_init(&roughness, sizeof roughness));
    CHECK_OK(windrow_roughness_map_init(&lengths, sizeof lengths));
    lengths.lengths = map;
    lengths.scale.y = 0.1f;
    roughness.map = &lengths;
    config.roughness = &roughness;
    CHECK_OK(windrow_wind_create(&config, &wind));
    CHECK_OK(windrow_wind_set_floor(wind, 0.0));

    add(wind, windrow_shape_block(vec3(1.5f, 2.0f, 3.0f)), dvec3(0.0, 2.0, 0.0), &house);
    add(wind, windrow_shape_sphere(1.0f), dvec3(6.0, 3.0, 6.0), &id);
    add(wind, windrow_shape_capsule(vec3(0.0f, 1.0f, 0.0f), 0.8f), dvec3(-6.0, 3.0, 6.0), &id);
    add(wind, windrow_shape_cylinder(0.8f, 2.0f), dvec3(-6.0, 3.0, -6.0), &id);
    add(wind, windrow_shape_plate(sheet), dvec3(6.0, 3.0, -6.0), &id);
    add(wind, windrow_shape_mesh(mesh, 1.5f), dvec3(-9.0, 1.0, 0.0), &id);
    add(wind, windrow_shape_voxels(voxels, 1.0f), dvec3(0.0, 7.0, 8.0), &id);
    obstacle.shape = windrow_shape_ground(map, vec3(1.0f, 1.0f, 1.0f));
    CHECK(obstacle.shape.beyond == WINDROW_BEYOND_EDGE);
    obstacle.shape.beyond = WINDROW_BEYOND_NOTHING;
    add(wind, obstacle.shape, dvec3(-16.0, 0.0, -16.0), &id);
    windrow_mesh_destroy(mesh); /* the obstacles keep them */
    windrow_voxels_destroy(voxels);
    windrow_height_map_destroy(map);
    CHECK(windrow_wind_obstacle_count(wind) == 8);

    for (n = 0; n < 20; ++n) {
        CHECK_OK(windrow_wind_move_obstacle(wind, house, dvec3(0.01 * n, 2.0, 0.0), n % 2 == 0 ? NULL : &turned, NULL));
        CHECK_OK(windrow_wind_step(wind, 0.05, NULL));
    }
    CHECK_OK(windrow_wind_velocity(wind, dvec3(3.0, 2.0, 0.0), &lee));
    CHECK(lee.x < 2.5f); /* 3 m/s came */
    CHECK_OK(windrow_obstacle_force_init(&force, sizeof force));
    CHECK_OK(windrow_wind_force_on(wind, house, &force));
    CHECK(force.in_box == 1 && force.force.x > 0.0f);
    CHECK_OK(windrow_wind_write_obstacles(wind, inside, CELLS));
    for (n = 0; n < CELLS; ++n)
        count += inside[n] == 1.0f;
    CHECK(count > 36);

    CHECK_OK(windrow_obstacle_init(&obstacle, sizeof obstacle));
    obstacle.surface = WINDROW_SURFACE_NO_SLIP;
    CHECK_OK(windrow_wind_set_obstacle(wind, house, &obstacle));
    obstacle.shape.kind = -1;
    CHECK_FAILS(windrow_wind_add_obstacle(wind, &obstacle, NULL), WINDROW_REJECTED, "shape.kind is -1");
    obstacle.shape = windrow_shape_ground(NULL, vec3(1.0f, 1.0f, 1.0f));
    obstacle.shape.beyond = 2;
    CHECK_FAILS(windrow_wind_add_obstacle(wind, &obstacle, NULL), WINDROW_REJECTED, "beyond is 2: give 0 to 1.");
    obstacle.shape = windrow_shape_mesh(NULL, 1.0f);
    CHECK_FAILS(windrow_wind_add_obstacle(wind, &obstacle, NULL), WINDROW_REJECTED, "mesh");
    CHECK_OK(windrow_wind_remove_obstacle(wind, house));
    CHECK_FAILS(windrow_wind_remove_obstacle(wind, house), WINDROW_STALE, ".");
    CHECK_FAILS(windrow_wind_force_on(wind, house, &force), WINDROW_STALE, ".");
    CHECK_FAILS(windrow_wind_get_obstacle(wind, house, &obstacle), WINDROW_STALE, ".");
    windrow_wind_destroy(wind);
}
