// The wind in a shader: the box's wind, faded over the blend zone to the ambient wind. For any stage.
//
//     #extension GL_GOOGLE_include_directive : require
//     #define WINDROW_SET 2                          // yours; default 0
//     #include "coupling/windrow_wind.glsl"
//     vec3 u = windrow_velocity(p);                  // [m/s] at p [m] from the anchor
//     vec3 before = windrow_velocity_previous(p);    // a frame ago, for motion vectors
//     vec3 felt = windrow_apparent(u, p, v);         // relative to an object that moves at v [m/s]
//
// Set WINDROW_SET (0 unless defined), bindings from WINDROW_BINDING (0 unless defined); fluid/vulkan/textures.h makes the layout and
// the writes of the set:
//   + 0    uniform buffer    windrow::FrameBlock (fluid/textures.h), copied as it is; at an offset that is a multiple of the
//                            device's minUniformBufferOffsetAlignment
//   + 1    sampler3D         texture of this frame: x, y, z in one (TextureSet::vectors)
//   + 2    sampler3D         texture of the frame before
//   + 3    storage buffer    the gust tile, 128 x 16 x 128 vec4 (GustTile::texels); any buffer of 16 bytes where there are no gusts
// With WINDROW_ES, for GLSL ES 3.00 (WebGL 2), there are no sets and bindings: the host finds them by name. The block is WindrowBlock,
// the textures are windrow_vectors and windrow_vectors_before, and the tile is windrow_tile_texels, a sampler3D of 128 x 16 x 128 texels
// of floats; any texture of 1 x 1 x 1 where there are no gusts. State `precision highp float; precision highp sampler3D;` before.
// With WINDROW_THREE_TEXTURES (TextureSet::axes) + 1, 2, 3 are x, y, z of this frame, + 4, 5, 6 of the frame before, + 7 the tile.
//
// Other bindings, bindless textures, and WINDROW_EXACT for float weights in place of the texture unit's: windrow_sampling.glsl,
// which also says what the sampler must be.
#ifndef WINDROW_WIND_GLSL
#define WINDROW_WIND_GLSL

#ifndef WINDROW_SET
#define WINDROW_SET 0
#endif
#ifndef WINDROW_BINDING
#define WINDROW_BINDING 0
#endif

#ifdef WINDROW_ES
uniform sampler3D windrow_vectors, windrow_vectors_before, windrow_tile_texels;
#define WINDROW_NOW windrow_vectors
#define WINDROW_BEFORE windrow_vectors_before
#elif defined(WINDROW_THREE_TEXTURES)
#define WINDROW_TILE_BINDING (WINDROW_BINDING + 7)
layout(set = WINDROW_SET, binding = WINDROW_BINDING + 1) uniform sampler3D windrow_x;
layout(set = WINDROW_SET, binding = WINDROW_BINDING + 2) uniform sampler3D windrow_y;
layout(set = WINDROW_SET, binding = WINDROW_BINDING + 3) uniform sampler3D windrow_z;
layout(set = WINDROW_SET, binding = WINDROW_BINDING + 4) uniform sampler3D windrow_x_before;
layout(set = WINDROW_SET, binding = WINDROW_BINDING + 5) uniform sampler3D windrow_y_before;
layout(set = WINDROW_SET, binding = WINDROW_BINDING + 6) uniform sampler3D windrow_z_before;
// 0 this frame, 1 the one before; constant where it is called.
#define WINDROW_TEXTURES int
#define WINDROW_NOW 0
#define WINDROW_BEFORE 1
#ifdef WINDROW_EXACT
vec4 windrow_texel(int frame, ivec3 texel) {
    if (frame == WINDROW_NOW)
        return vec4(texelFetch(windrow_x, texel, 0).x, texelFetch(windrow_y, texel, 0).x, texelFetch(windrow_z, texel, 0).x,
                    0.0f);
    return vec4(texelFetch(windrow_x_before, texel, 0).x, texelFetch(windrow_y_before, texel, 0).x,
                texelFetch(windrow_z_before, texel, 0).x, 0.0f);
}
#else
vec4 windrow_texture(int frame, vec3 place) {
    if (frame == WINDROW_NOW)
        return vec4(textureLod(windrow_x, place, 0.0).x, textureLod(windrow_y, place, 0.0).x, textureLod(windrow_z, place, 0.0).x,
                    0.0f);
    return vec4(textureLod(windrow_x_before, place, 0.0).x, textureLod(windrow_y_before, place, 0.0).x,
                textureLod(windrow_z_before, place, 0.0).x, 0.0f);
}
#endif
#else
#define WINDROW_TILE_BINDING (WINDROW_BINDING + 3)
layout(set = WINDROW_SET, binding = WINDROW_BINDING + 1) uniform sampler3D windrow_vectors;
layout(set = WINDROW_SET, binding = WINDROW_BINDING + 2) uniform sampler3D windrow_vectors_before;
#define WINDROW_NOW windrow_vectors
#define WINDROW_BEFORE windrow_vectors_before
#endif

#define WINDROW_TILE int
#ifdef WINDROW_ES
vec3 windrow_tile_texel(int tile, ivec3 texel) { return texelFetch(windrow_tile_texels, texel, 0).xyz; }
#else
layout(std430, set = WINDROW_SET, binding = WINDROW_TILE_BINDING) readonly buffer WindrowTile { vec4 windrow_tile_texels[]; };
vec3 windrow_tile_texel(int tile, ivec3 texel) { return windrow_tile_texels[(texel.z * 16 + texel.y) * 128 + texel.x].xyz; }
#endif

#include "windrow_sampling.glsl"

#ifdef WINDROW_ES
layout(std140) uniform WindrowBlock {
#else
layout(std140, set = WINDROW_SET, binding = WINDROW_BINDING) uniform WindrowBlock {
#endif
    WindrowFrame windrow_frame;
    vec4 windrow_rows[WINDROW_ROW_BLOCKS];
};
float windrow_row_height(WINDROW_TEXTURES textures, int row) { return windrow_rows[row >> 2][row & 3]; }

// [m/s] The wind at p [m] from the anchor.
vec3 windrow_velocity(vec3 p) { return windrow_velocity_at(WINDROW_NOW, 0, windrow_frame, p); }

// [m/s] The same a frame ago, at the same place.
vec3 windrow_velocity_previous(vec3 p) { return windrow_velocity_previous_at(WINDROW_BEFORE, 0, windrow_frame, p); }

// [m/s] What a thing at p that moves at `velocity` [m/s] feels of a wind u: with detail, strength and limit as FrameBlock says.
vec3 windrow_apparent(vec3 u, vec3 p, vec3 velocity) { return windrow_felt(0, windrow_frame.ambient, u - velocity, p); }
vec3 windrow_apparent_previous(vec3 u, vec3 p, vec3 velocity) {
    return windrow_felt(0, windrow_frame.previous_ambient, u - velocity, p);
}

#endif
