/* Uniform blocks of std140 layout, as the shaders of shaders/coupling read them. fluid/textures.h and fluid/ambient.h document each
   field. Their layout is that of the shaders of the same version. */
#ifndef WINDROW_C_API_SHADER_BLOCKS_H
#define WINDROW_C_API_SHADER_BLOCKS_H

#include "base.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Position of the textures. */
typedef struct windrow_window_block {
    windrow_vec3 origin;
    float cell_size;
    windrow_vec3 cells;
    float factor;
    windrow_vec3 previous_origin;
    float rows;
    windrow_vec3 ambient;
    float height;
    windrow_vec3 low_boundaries;
    float wall_per_length;
    windrow_vec3 high_boundaries;
    float wall_per_log;
    windrow_vec3 blend_centre;
    float blend_width;
    windrow_vec3 blend_reach;
    float wall_lowest;
    windrow_vec3 previous_blend_centre;
    float wall_fall;
} windrow_window_block;

typedef struct windrow_axis_block {
    float texture_scale, texture_offset, inner_scale, inner_offset, edge_scale, low_edge, high_edge, smoothness;
} windrow_axis_block;
typedef struct windrow_place_block {
    windrow_axis_block x, y, z;
} windrow_place_block;

/* The ambient wind beside its tile. */
typedef struct windrow_ambient_block {
    windrow_vec3 mean;
    float gust_strength;
    float roughness_length;
    float reference_height;
    float anchor_height;
    float felt_strength;
    windrow_vec3 gust_texel;
    float gust_texels;
    windrow_vec3 gust_fraction;
    float longest_gust;
    windrow_vec3 gust_axes;
    float felt_limit;
    windrow_vec3 detail_texel;
    float detail_texels;
    windrow_vec3 detail_fraction;
    float detail_amount;
} windrow_ambient_block;

enum { WINDROW_MAX_ROWS = 128 };
/* The whole uniform buffer of windrow_wind.glsl: 1072 bytes. */
typedef struct windrow_frame_block {
    windrow_window_block window;
    windrow_place_block place;
    windrow_place_block previous_place;
    windrow_ambient_block ambient;
    windrow_ambient_block previous_ambient;
    float heights[128];
} windrow_frame_block;

/* --- Plants -------------------------------------------------------------------------------------------------------------- */

typedef struct windrow_drag_block {
    windrow_vec4 load;
} windrow_drag_block;
typedef struct windrow_blade_block {
    windrow_vec4 size, form, own;
    windrow_drag_block drag;
} windrow_blade_block;
typedef struct windrow_shell_block {
    windrow_vec4 form, push, sag;
    windrow_drag_block drag;
} windrow_shell_block;
typedef struct windrow_tree_block {
    windrow_drag_block trunk, branch, leaf;
} windrow_tree_block;
typedef struct windrow_spring_block {
    windrow_vec4 place, velocity;
} windrow_spring_block;
typedef struct windrow_swing_block {
    windrow_spring_block spring, smoothing;
    windrow_vec4 parts;
} windrow_swing_block;
typedef struct windrow_flutter_block {
    windrow_vec4 motion, now, before;
} windrow_flutter_block;
typedef struct windrow_pose_block {
    windrow_vec4 place, rotation;
} windrow_pose_block;
typedef struct windrow_ground_place_block {
    windrow_vec4 corner, blend_zone, slot;
} windrow_ground_place_block;
typedef struct windrow_ground_block {
    windrow_ground_place_block now, before;
} windrow_ground_block;

#ifdef __cplusplus
}
#endif

#endif
