/* Obstacles: bodies, buildings and terrain that the air flows around (fluid/obstacle.h). */
#ifndef WINDROW_C_API_OBSTACLES_H
#define WINDROW_C_API_OBSTACLES_H

#include "base.h"
#include "wind.h"

#ifdef __cplusplus
extern "C" {
#endif

/* --- Forms that any number of obstacles may use. What uses one keeps it, after its destruction too ----------------------- */

/* A closed mesh of triangles. */
typedef struct windrow_mesh windrow_mesh;
WINDROW_C_API windrow_result windrow_mesh_create(const windrow_vec3* vertices, uint64_t vertex_count, const uint32_t* indices,
                                                 uint64_t triangle_count, windrow_mesh** mesh);
WINDROW_C_API void windrow_mesh_destroy(windrow_mesh* mesh);
/* All that windrow_mesh_create finds, as bytes: an engine makes its meshes when it builds its data, and loads them in a game. 110 to 190
   bytes a triangle. */
WINDROW_C_API windrow_result windrow_mesh_save(const windrow_mesh* mesh, windrow_bytes** bytes);
/* The mesh again, with the same bits in every call. Damaged bytes and those of another version are rejected: make the mesh again. */
WINDROW_C_API windrow_result windrow_mesh_load(const void* bytes, uint64_t size, windrow_mesh** mesh);
/* [m] From a point to its surface, negative inside. */
WINDROW_C_API float windrow_mesh_distance(const windrow_mesh* mesh, windrow_vec3 point);

/* Closed cells of a grid: one byte a cell, 0 is open; x fastest, z slowest. */
typedef struct windrow_voxels windrow_voxels;
WINDROW_C_API windrow_result windrow_voxels_create(windrow_ivec3 cells, const uint8_t* closed, uint64_t count,
                                                   windrow_voxels** voxels);
WINDROW_C_API void windrow_voxels_destroy(windrow_voxels* voxels);

/* Heights [m] at the corners of a grid, x fastest. */
WINDROW_C_API windrow_result windrow_height_map_create(windrow_ivec2 corners, float spacing, const float* heights, uint64_t count,
                                                       windrow_height_map** map);
/* The same with holes, where there is no ground to any depth: a grid of cells that covers the map whole, one byte a cell, other than 0
   is a hole. */
WINDROW_C_API windrow_result windrow_height_map_create_with_holes(windrow_ivec2 corners, float spacing, const float* heights,
                                                                  uint64_t count, windrow_ivec2 cells, const uint8_t* open,
                                                                  uint64_t cell_count, windrow_height_map** map);
WINDROW_C_API void windrow_height_map_destroy(windrow_height_map* map);
WINDROW_C_API float windrow_height_map_height(const windrow_height_map* map, windrow_vec2 place);
WINDROW_C_API windrow_vec3 windrow_height_map_normal(const windrow_height_map* map, windrow_vec2 place);

/* --- Shapes -------------------------------------------------------------------------------------------------------------- */

/* Made by ./dev schema from Shape. */
typedef int32_t windrow_shape_kind;
enum {
    WINDROW_SHAPE_SPHERE = 0,
    WINDROW_SHAPE_CAPSULE = 1,
    WINDROW_SHAPE_BLOCK = 2,
    WINDROW_SHAPE_CYLINDER = 3,
    WINDROW_SHAPE_PLATE = 4,
    WINDROW_SHAPE_MESH = 5,
    WINDROW_SHAPE_VOXELS = 6,
    WINDROW_SHAPE_GROUND = 7
};
/* Made by ./dev schema from Beyond. */
typedef int32_t windrow_beyond;
enum { WINDROW_BEYOND_EDGE = 0, WINDROW_BEYOND_NOTHING = 1 };
/* Made by the functions below; fields of other kinds are not read. */
typedef struct windrow_shape {
    windrow_shape_kind kind;
    float radius;           /* [m] sphere, capsule, cylinder */
    float half_length;      /* [m] cylinder, along its y axis */
    float cell_size;        /* [m] voxels */
    windrow_vec3 half_size; /* [m] block; plate: x and y */
    windrow_vec3 half_axis; /* [m] capsule */
    windrow_vec3 scale;     /* ground; mesh: x */
    windrow_beyond beyond;  /* ground: nothing makes it a tile (docs/obstacles.md, "Ground"); as made: edge */
    const windrow_mesh* mesh;
    const windrow_voxels* voxels;
    const windrow_height_map* heights; /* ground */
} windrow_shape;
WINDROW_C_API windrow_shape windrow_shape_sphere(float radius);
WINDROW_C_API windrow_shape windrow_shape_capsule(windrow_vec3 half_axis, float radius);
WINDROW_C_API windrow_shape windrow_shape_block(windrow_vec3 half_size);
WINDROW_C_API windrow_shape windrow_shape_cylinder(float radius, float half_length);
WINDROW_C_API windrow_shape windrow_shape_plate(windrow_vec2 half_size);
WINDROW_C_API windrow_shape windrow_shape_mesh(const windrow_mesh* mesh, float scale);
WINDROW_C_API windrow_shape windrow_shape_voxels(const windrow_voxels* voxels, float cell_size);
WINDROW_C_API windrow_shape windrow_shape_ground(const windrow_height_map* heights, windrow_vec3 scale);

/* --- Obstacles ----------------------------------------------------------------------------------------------------------- */

/* Made by ./dev schema from Surface. */
typedef int32_t windrow_surface;
enum { WINDROW_SURFACE_FREE_SLIP = 0, WINDROW_SURFACE_NO_SLIP = 1 };
/* Made by ./dev schema from Obstacle. */
typedef struct windrow_obstacle {
    uint32_t struct_size;
    /* Default WINDROW_SURFACE_FREE_SLIP. free_slip: the air slides along it. At 1 m cells the layer that a wall slows is
       thinner than a cell. no_slip: the air sticks to it, through the viscosity. */
    windrow_surface surface;
    /* [m] Each component -1e12 to 1e12, default (0, 0, 0). Centre of the shape; the origin of a mesh. */
    windrow_dvec3 position;
    /* A finite vector that is not 0. From the shape's own axes to the world's. Default: not turned. */
    windrow_quat orientation;
    /* Its form and size. */
    windrow_shape shape;
} windrow_obstacle;
/* A block of 2 m, not turned. */
WINDROW_C_API windrow_result windrow_obstacle_init(windrow_obstacle* obstacle, uint32_t struct_size);

/* Handle of an obstacle of one wind; all 0 names none. */
typedef struct windrow_obstacle_id {
    uint32_t slot, generation, owner;
} windrow_obstacle_id;

/* The obstacles of a wind, at most 16384. */
WINDROW_C_API windrow_result windrow_wind_add_obstacle(windrow_wind* wind, const windrow_obstacle* obstacle,
                                                       windrow_obstacle_id* id);
/* Replaces it whole; it pushes no air on the way. */
WINDROW_C_API windrow_result windrow_wind_set_obstacle(windrow_wind* wind, windrow_obstacle_id id,
                                                       const windrow_obstacle* obstacle);
/* As it is. Handles of its form are null: they belong to the host that made them. */
WINDROW_C_API windrow_result windrow_wind_get_obstacle(const windrow_wind* wind, windrow_obstacle_id id,
                                                       windrow_obstacle* obstacle);
/* To where it is at the end of the coming step or frame. `orientation` may be null: it keeps its own. `spin` [rad/s], about its
   position along the world's axes, of a wheel or a propeller, which two poses do not tell; null: by the poses, the shorter way. */
WINDROW_C_API windrow_result windrow_wind_move_obstacle(windrow_wind* wind, windrow_obstacle_id id, windrow_dvec3 position,
                                                        const windrow_quat* orientation, const windrow_vec3* spin);
WINDROW_C_API windrow_result windrow_wind_remove_obstacle(windrow_wind* wind, windrow_obstacle_id id);
WINDROW_C_API int32_t windrow_wind_obstacle_count(const windrow_wind* wind);

/* What the pressure of the air does to an obstacle. */
typedef struct windrow_obstacle_force {
    uint32_t struct_size;
    windrow_vec3 force;  /* [N] */
    windrow_vec3 moment; /* [N m] about its position */
    float pressure;      /* [Pa] */
    int32_t in_box;      /* 0: no part of it was in the box; all else is 0 */
} windrow_obstacle_force;
WINDROW_C_API windrow_result windrow_obstacle_force_init(windrow_obstacle_force* force, uint32_t struct_size);
WINDROW_C_API windrow_result windrow_wind_force_on(const windrow_wind* wind, windrow_obstacle_id id,
                                                   windrow_obstacle_force* force);

#ifdef __cplusplus
}
#endif

#endif
