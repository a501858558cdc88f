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
/* Made by ./dev schema from Drag. */
typedef struct windrow_drag {
    uint32_t struct_size;
    /* [m] 1e-4 to 200, default 0.3. Length of the stalk; 0.3 is meadow grass. In a scene it is that of the class. The bend
       grows with its cube. */
    float length;
    /* [m] 1e-6 to 100, default 0.004. Width across the wind, leaves included. A blade of grass has 0.004. */
    float width;
    /* [N m2] 1e-12 to 1e12, default 4.2e-5. E I. 4.2e-5 is a blade creased to a V, folded_rigidity(5e8, 0.004, 2.5e-4, 0.001). */
    float rigidity;
    /* 0 to 10, default 1.95. A flat plate has 1.95 (Luhar & Nepf 2011), a round stem 1.1, a crown 0.3; 0: no wind bends it. */
    float drag_coefficient;
    /* [kg/m3] 0 to 2000, default 1.2. 1.2 is air at 20 C. */
    float air_density;
    /* -2 to 0, default 0. Loss of drag as leaves close up: speed to this power above vogel_speed. 0: only the loss by the
       bend, which is -2/3. Crowns have -0.7 (Vogel 1989). */
    float vogel_exponent;
    /* [m/s] 0.001 to 1000, default 5. Speed above which leaves turn and close up. */
    float vogel_speed;
    /* [rad] 0 to 2.5, default 1.5707964. Upper bound of the tip's bend. No steady wind exceeds pi/2, a spring that overshoots
       may; shells stay within pi/2. */
    float max_bend;
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

/* Made by ./dev schema from BladeSettings. */
typedef struct windrow_blade_settings {
    uint32_t struct_size;
    /* 0 */
    uint32_t reserved;
    /* Properties of the stalk that the class does not set. The defaults are those of meadow grass. Null: the defaults. */
    const windrow_drag* stalk;
    /* 0 to 0.9, default 0.3. Fraction by which lengths vary. A blade bends by its own length: in a light wind as its cube,
       0.34 to 2.2 times as far as the class at 0.3. */
    float length_spread;
    /* [m] 0 to 10, default 0.006. Width of the drawn strip at its root. 0.006 is a blade of 4 mm, drawn wider since only a few
       are drawn. */
    float width;
    /* 0 to 1, default 0.1. The tip's width over the root's. */
    float tip_width;
    /* A number above 0, at most 10, default 2. Exponent of the width over height: width (1 - (1 - tip_width) h^taper). 2 is
       wide for long and pointed at the end. */
    float taper;
    /* 0 to 1, default 1. Fraction of the load that bends the blade along the wind; the rest bends it about its own wide axis
       only. 1 is for stems and twisted blades. */
    float along_wind;
    /* 0 to 0.9, default 0.3. Fraction by which stiffness varies, so that blades move differently. */
    float stiffness_spread;
    /* [rad] -3 to 3, default 0.5. Bend of the tip at rest, toward the face. 0 is straight. */
    float rest_bend;
    /* [rad] 0 to 3, default 0.3. Spread of the rest bend. */
    float rest_bend_spread;
    /* 0 to 1, default 0.5. Shape of the rest bend: 0 a uniform arc, 1 all at the tip. */
    float rest_curve;
    /* [rad] 0 to 3, default 0. Added to the own bend when seen from straight above; 0.5 covers ground that would show between
       upright blades. */
    float view_bend;
    /* 0 to 2, default 0.3. Turn of the tip toward a wind that blows against its corner, over its bend, by wind, walkers or a
       spring. 0: none, as for stems; so a scene has it for classes of stems. A strip has 3/4 of its width over its length
       times the ratio of its stiffnesses, bending over twisting: 0.3 for 4 mm on 0.3 m and a ratio of 30. Stems of tulips and
       daffodils have 8 and 13 (Etnier & Vogel 2000, Am. J. Bot. 87, 29); that of a channelled blade is ours. */
    float twist;
    /* 0 */
    uint32_t reserved_2;
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

/* Made by ./dev schema from ShellSettings. */
typedef struct windrow_shell_settings {
    uint32_t struct_size;
    /* 2 to 4096, default 32. Number of layers. Of a mesh from a file, the default is that of the material's fur line. */
    int32_t shells;
    /* 0 or 1, default 1. Whether the outermost layer is at the tip, layer i at i / (N - 1), so that the look does not depend
       on N; else layer i is at i / N. */
    int32_t reaches_tip;
    /* [m] 1e-6 to 100, default 0.03. Length of the longest strands; 0.03 is long fur. Of a mesh from a file, the default is
       that of the material's fur line. */
    float length;
    /* A number above 0, at most 10, default 1. Heights are (i / d)^spacing: above 1 layers gather at the skin. */
    float spacing;
    /* 0 to 1, default 0. Fraction of the length by which all layers are lifted: a little lifts shell 0 off a skin that is
       drawn too. */
    float bias;
    /* [m] -100 to 100, default 0.015. Displacement of the tip for a direction of length 1, in the translated form. */
    float push;
    /* A number above 0, at most 10, default 2. The push grows as height^this: at 2 roots stay upright and tips lean. */
    float push_exponent;
    /* [m] 0 to 100, default 0. Droop of the tip, in the translated form. */
    float droop;
    /* 0.001 to 1000, default 3. p of the droop (p^h - 1) / (p - 1): above 1 it bends toward the tip, 1 is linear. */
    float droop_shape;
    /* [rad] 0 to 1.5707964, default 0.3. Sag of the tip of a horizontal strand, in the bent form. Strands that a map shortens
       sag by its cube. */
    float sag;
    /* A finite vector that is not 0, default (0, -1, 0). Direction of gravity, of any length above 0. */
    windrow_vec3 down;
    /* Strand of the bent form; its length is that of the layers. Null: the defaults. */
    const windrow_drag* strand;
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
/* [m] A vertex of the skin on the layer of height h. The skin is taken as level: on a curved body strands that lie flat in a strong wind
   reach 6 to 8 % of their length into it (at 20 m/s). Draw the body before its layers, or raise `bias`. */
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
/* Made by ./dev schema from TreeClasses. */
typedef struct windrow_tree_classes {
    uint32_t struct_size;
    /* 0 */
    uint32_t reserved;
    /* The trunk. Null: the defaults. */
    const windrow_drag* trunk;
    /* Each branch. Null: the defaults. */
    const windrow_drag* branch;
    /* Each leaf. Null: the defaults. */
    const windrow_drag* leaf;
} windrow_tree_classes;
WINDROW_C_API windrow_result windrow_tree_classes_init(windrow_tree_classes* classes, uint32_t struct_size);

/* A straight part of a tree at rest, relative to the trunk's base. Stiffness 0: no part. */
/* Made by ./dev schema from TreePart. */
typedef struct windrow_tree_part {
    /* [m] Each component -1e6 to 1e6, default (0, 0, 0). Point at which it is held: on its bearer's axis, or beside it on the
       bark. */
    windrow_vec3 root;
    /* A length of 0.999 to 1.001, default (0, 1, 0). Unit vector along it. */
    windrow_vec3 axis;
    /* [m] 1e-4 to 200, default 1. The class's stiffness does not depend on it: a short part needs a higher `stiffness`. */
    float length;
    /* 1e-6 to 1e6, default 0. Factor on the class's stiffness: 1 is the class's own. 0, outside of the range, is for a part
       that does not exist. */
    float stiffness;
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
