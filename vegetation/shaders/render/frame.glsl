// What every shader of the renderer is told of a frame: set 0. The same layout as render::ViewBlock
// (vegetation/render/frame_block.h). Positions are [m] from the anchor of the frame, y up; light is in units of the picture,
// before exposure.
#ifndef WINDROW_RENDER_FRAME_GLSL
#define WINDROW_RENDER_FRAME_GLSL

#include "../numerics/cloud_layer.glsl"
#include "../numerics/sky.glsl"

layout(std140, set = 0, binding = 0) uniform RenderFrame {
    mat4 view_projection;
    mat4 view_projection_before; // of the last frame
    mat4 from_clip;              // inverse of view_projection
    mat4 shadow[2];              // to the clip space of the near and the far shadow
    vec4 eye;                    // xyz; w exposure
    vec4 eye_before;             // xyz of the last frame; w [rad] half of the least width of what is drawn
    WindrowSky sky;
    vec4 sunlight;      // rgb irradiance across the beam at the ground; w [1/m] the fog's density at height 0
    vec4 skylight;      // rgb irradiance of a level face from the sky; w [1/m] how fast the fog thins upward
    vec4 groundlight;   // rgb irradiance of a face that looks down; w [m] height 0 of the fog, from the anchor
    vec4 shadow_texel;  // x, y [m] of the near and the far shadow; z its share of the map's height; w reach of the near one [m]
    vec4 terrain;       // x, y place of the corner sample along x and z; z [m] between samples; w [m] added to its heights
    ivec4 terrain_size; // x columns, y rows; z what grass shows in place of its colours (grass_view.glsl)
    vec4 pixel;         // xy clip space over w, a pixel of the picture; z 1: hard shadows; w 0
    WindrowClouds clouds;
    vec4 cloud_map; // xy cell of the clouds' noise at its corner; z maps a cell; w maps a texel, 1 where there is none
    // clang-format off
} frame;
// clang-format on

layout(set = 0, binding = 3) uniform sampler2D cloud_map;        // cloud_map.glsl
layout(set = 0, binding = 1) uniform sampler2DShadow shadow_map; // near and far side by side

// Heights [m], row by row along x.
layout(std430, set = 0, binding = 2) readonly buffer RenderTerrain { float terrain_heights[]; };

#endif
