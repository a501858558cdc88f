/*
 * Plants on the CPU: how blades, shells and trees bend in a wind, for one and for many (coupling/blade.h, shell.h, tree.h).
 *
 * Arrays of windrow_vec4 have one entry a plant or a vertex. A call that rejects touches no array. `parallel_for` may be null.
 */
#ifndef WINDROW_C_API_PLANTS_H
#define WINDROW_C_API_PLANTS_H

#include "base.h"
#include "shader_blocks.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Mechanical properties of a stalk, uniform along its length. */
typedef struct windrow_drag {
    uint32_t struct_size;
    float length;   /* [m] */
    float width;    /* [m] across the wind, leaves included */
    float rigidity; /* [N m^2] E I */
    float drag_coefficient;
    float air_density; /* [kg/m^3] */
    float vogel_exponent;
    float vogel_speed; /* [m/s] */
    float max_bend;    /* [rad] */
} windrow_drag;
WINDROW_C_API windrow_result windrow_drag_init(windrow_drag* drag, uint32_t struct_size);

typedef int32_t windrow_plant;
enum {
    WINDROW_PLANT_GRASS = 0,
    WINDROW_PLANT_WHEAT = 1,
    WINDROW_PLANT_REED = 2,
    WINDROW_PLANT_LEAF = 3,
    WINDROW_PLANT_TWIG = 4,
    WINDROW_PLANT_BRANCH = 5,
    WINDROW_PLANT_SMALL_TRUNK = 6,
    WINDROW_PLANT_LARGE_TRUNK = 7
};
/* The predefined class of a plant. */
WINDROW_C_API windrow_result windrow_drag_of(windrow_plant plant, windrow_drag* drag);
WINDROW_C_API windrow_result windrow_drag_validate(const windrow_drag* drag);
WINDROW_C_API windrow_result windrow_drag_block_of(const windrow_drag* drag, windrow_drag_block* block);
/* The Cauchy number at a speed [m/s] across the stalk. */
WINDROW_C_API windrow_result windrow_cauchy_number(const windrow_drag* drag, double speed, double* number);
/* [rad] Lean of the tip in a steady wind [m/s]. */
WINDROW_C_API windrow_result windrow_bend_angle(const windrow_drag* drag, float speed, float* angle);
/* [N m^2] Of sections of Young's modulus `young` [Pa]; lengths in m. */
WINDROW_C_API float windrow_rectangle_rigidity(float young, float width, float thickness);
WINDROW_C_API float windrow_folded_rigidity(float young, float width, float thickness, float depth);
WINDROW_C_API float windrow_rod_rigidity(float young, float diameter);
WINDROW_C_API float windrow_tube_rigidity(float young, float outer_diameter, float inner_diameter);

/* Identifier of a plant, the seed of its random numbers. */
typedef windrow_uvec2 windrow_plant_key;
WINDROW_C_API windrow_plant_key windrow_place_key(float x, float z);
/* [rad] */
WINDROW_C_API float windrow_plant_yaw(windrow_plant_key key);
WINDROW_C_API float windrow_plant_stiffness(windrow_plant_key key, float spread);
typedef struct windrow_plant_vertex {
    windrow_vec3 position; /* [m] from the plant's root */
    windrow_vec3 normal;   /* unit vector, as the next */
    windrow_vec3 tangent;
} windrow_plant_vertex;

/* --- Blades -------------------------------------------------------------------------------------------------------------- */

typedef struct windrow_blade_settings {
    uint32_t struct_size;
    uint32_t reserved;         /* 0 */
    const windrow_drag* stalk; /* null: meadow grass */
    float length_spread;
    float width; /* [m] drawn */
    float tip_width;
    float taper;
    float along_wind;
    float stiffness_spread;
    float rest_bend;        /* [rad] */
    float rest_bend_spread; /* [rad] */
    float rest_curve;
    float view_bend;     /* [rad] */
    float twist;         /* of the tip over its bend, 0 to 2 */
    uint32_t reserved_2; /* 0 */
} windrow_blade_settings;
WINDROW_C_API windrow_result windrow_blade_settings_init(windrow_blade_settings* settings, uint32_t struct_size);

typedef struct windrow_blades windrow_blades;
WINDROW_C_API windrow_result windrow_blades_create(const windrow_blade_settings* settings, windrow_blades** blades);
WINDROW_C_API void windrow_blades_destroy(windrow_blades* blades);
WINDROW_C_API windrow_result windrow_blades_block(const windrow_blades* blades, windrow_blade_block* block);
/* [m] Length of one blade. */
WINDROW_C_API float windrow_blades_length(const windrow_blades* blades, windrow_plant_key key);
/* [rad] Bend that a wind [m/s] holds. */
WINDROW_C_API windrow_vec3 windrow_blades_load(const windrow_blades* blades, windrow_plant_key key, windrow_vec3 wind);
/* A vertex at height h, 0 to 1, and side -1 to 1; `view` is the unit vector from the eye to the blade. */
WINDROW_C_API windrow_result windrow_blades_vertex(const windrow_blades* blades, windrow_plant_key key, windrow_vec3 load,
                                                   float h, float side, windrow_vec3 view, windrow_plant_vertex* vertex);
WINDROW_C_API windrow_result windrow_blades_loads(const windrow_blades* blades, uint64_t count, const windrow_plant_key* keys,
                                                  const windrow_vec4* winds, windrow_vec4* loads,
                                                  const windrow_parallel_for* parallel_for);
/* `heights` of the rows; positions and normals have count * rows * 2 entries: blade by blade, row by row, left then right. Normals may
   be null. */
WINDROW_C_API windrow_result windrow_blades_vertices(const windrow_blades* blades, uint64_t count, const windrow_plant_key* keys,
                                                     const windrow_vec4* roots, const windrow_vec4* loads, uint64_t rows,
                                                     const float* heights, windrow_vec3 view, windrow_vec4* positions,
                                                     windrow_vec4* normals, const windrow_parallel_for* parallel_for);

/* --- Shells of fur and grass --------------------------------------------------------------------------------------------- */

typedef struct windrow_shell_settings {
    uint32_t struct_size;
    int32_t shells;
    int32_t reaches_tip;
    float length; /* [m] */
    float spacing;
    float bias;
    float push; /* [m] */
    float push_exponent;
    float droop; /* [m] */
    float droop_shape;
    float sag; /* [rad] */
    windrow_vec3 down;
    const windrow_drag* strand; /* null: a bundle of hairs; its length is not read */
} windrow_shell_settings;
WINDROW_C_API windrow_result windrow_shell_settings_init(windrow_shell_settings* settings, uint32_t struct_size);

typedef struct windrow_shells windrow_shells;
WINDROW_C_API windrow_result windrow_shells_create(const windrow_shell_settings* settings, windrow_shells** shells);
WINDROW_C_API void windrow_shells_destroy(windrow_shells* shells);
WINDROW_C_API windrow_result windrow_shells_block(const windrow_shells* shells, windrow_shell_block* block);
/* 0 to 1, of shell 0 to N - 1. */
WINDROW_C_API float windrow_shells_height(const windrow_shells* shells, int32_t shell);
/* [rad] Bend of a strand on a unit normal, with `map` of its length, that a wind [m/s] holds. */
WINDROW_C_API windrow_vec3 windrow_shells_load(const windrow_shells* shells, windrow_vec3 normal, float map, windrow_vec3 wind);
/* [m] A vertex of the skin on the layer of height h. */
WINDROW_C_API windrow_vec3 windrow_shells_bent(const windrow_shells* shells, windrow_vec3 position, windrow_vec3 normal, float h,
                                               float map, windrow_vec3 load);
WINDROW_C_API windrow_vec3 windrow_shells_translated(const windrow_shells* shells, windrow_vec3 position, windrow_vec3 normal,
                                                     float h, float map, windrow_vec3 direction);
/* A mesh's vertices; w of `positions` is the map. */
typedef struct windrow_skin {
    uint64_t count;
    const windrow_vec4* positions; /* [m] */
    const windrow_vec4* normals;   /* unit vectors */
} windrow_skin;
/* One layer of a whole mesh. */
WINDROW_C_API windrow_result windrow_shells_loads_many(const windrow_shells* shells, const windrow_skin* skin,
                                                       const windrow_vec4* winds, windrow_vec4* loads,
                                                       const windrow_parallel_for* parallel_for);
WINDROW_C_API windrow_result windrow_shells_bent_many(const windrow_shells* shells, const windrow_skin* skin, float h,
                                                      const windrow_vec4* loads, windrow_vec4* positions,
                                                      const windrow_parallel_for* parallel_for);
WINDROW_C_API windrow_result windrow_shells_translated_many(const windrow_shells* shells, const windrow_skin* skin, float h,
                                                            const windrow_vec4* directions, windrow_vec4* positions,
                                                            const windrow_parallel_for* parallel_for);

/* --- Trees --------------------------------------------------------------------------------------------------------------- */

/* Null: of a small tree in leaf. */
typedef struct windrow_tree_classes {
    uint32_t struct_size;
    uint32_t reserved; /* 0 */
    const windrow_drag* trunk;
    const windrow_drag* branch;
    const windrow_drag* leaf;
} windrow_tree_classes;
WINDROW_C_API windrow_result windrow_tree_classes_init(windrow_tree_classes* classes, uint32_t struct_size);

/* A straight part of a tree at rest, relative to the trunk's base. Stiffness 0: no part. */
typedef struct windrow_tree_part {
    windrow_vec3 root; /* [m] */
    windrow_vec3 axis; /* unit vector */
    float length;      /* [m] */
    float stiffness;   /* factor on the class's */
} windrow_tree_part;
#define WINDROW_NO_PART 0xffffffffu
/* Indices of the parts that bear a vertex, or WINDROW_NO_PART. */
typedef struct windrow_tree_bearers {
    uint32_t trunk, branch, leaf;
} windrow_tree_bearers;

typedef struct windrow_tree windrow_tree;
WINDROW_C_API windrow_result windrow_tree_create(const windrow_tree_classes* classes, windrow_tree** tree);
WINDROW_C_API void windrow_tree_destroy(windrow_tree* tree);
WINDROW_C_API windrow_result windrow_tree_block_of(const windrow_tree* tree, windrow_tree_block* block);
/* Null: no part. */
WINDROW_C_API windrow_result windrow_tree_vertex(const windrow_tree* tree, const windrow_tree_part* trunk,
                                                 const windrow_tree_part* branch, const windrow_tree_part* leaf,
                                                 windrow_vec3 wind, const windrow_plant_vertex* rest, windrow_plant_vertex* bent);
/* `winds` [m/s] has one entry a part; the other arrays one a vertex. */
WINDROW_C_API windrow_result windrow_tree_vertices(const windrow_tree* tree, uint64_t part_count, const windrow_tree_part* parts,
                                                   const windrow_vec4* winds, uint64_t count, const windrow_vec4* rest_positions,
                                                   const windrow_vec4* rest_normals, const windrow_tree_bearers* bearers,
                                                   windrow_vec4* positions, windrow_vec4* normals,
                                                   const windrow_parallel_for* parallel_for);

#ifdef __cplusplus
}
#endif

#endif
