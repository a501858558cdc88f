// The wind at a point, from textures and a block that the caller passes: no binding, any set layout, any stage. For hosts with
// fixed bindings windrow_wind.glsl has them; HLSL has windrow_wind.hlsl. One text for all.
//
//     layout(set = 0, binding = 0) uniform sampler3D volumes[];                       // bindless: yours
//     struct Wind { WindrowFrame frame; vec4 rows[WINDROW_ROW_BLOCKS]; };             // windrow::FrameBlock; below the include
//     layout(std430, set = 0, binding = 1) readonly buffer Winds { Wind winds[]; };
//     float windrow_row_height(uint volume, int row) { return winds[...].rows[row >> 2][row & 3]; }
//
//     #define WINDROW_TEXTURES uint                                                   // what stands for a frame's textures
//     vec4 windrow_texture(uint volume, vec3 place) { return textureLod(volumes[nonuniformEXT(volume)], place, 0.0); }
//     #define WINDROW_TILE uint                                                       // what stands for a gust tile
//     vec3 windrow_tile_texel(uint tile, ivec3 texel) { ... }                         // numerics/ambient.glsl
//     #include "coupling/windrow_sampling.glsl"
//
//     vec3 u = windrow_velocity_at(volume, tile, winds[i].frame, p);                        // [m/s] at p [m] from the block's anchor
//
// Textures hold the wind as it is sampled: filled beside surfaces, so that a blade's foot finds the air along them. Over rough ground
// x, y, z are the wind over its share by the law of the wall and the fourth component is the height [m]; these functions multiply by
// the share at p. Three textures of one component have no place for it: there the wind is without the law.
//
// Weights between texels, by a define before this text:
//   (none)            the texture unit's: one fetch of a four-component texture, three of three scalar ones. The sampler is linear,
//                     repeats along periodic axes and clamps to the edge along others (vulkan::sampler_info, fluid/vulkan/textures.h).
//                     A unit with b bits between texels (subTexelPrecisionBits, 8 as a rule) is off by 3/2^(b+1) of the largest
//                     difference among the eight texels, at most. Needs windrow_texture.
//   WINDROW_EXACT     float weights, by eight fetches of a four-component texture, 24 of three; any sampler does. For tests, and
//                     for R32F and RGBA32F where the device does not filter them. Needs windrow_texel.
#ifndef WINDROW_SAMPLING_GLSL
#define WINDROW_SAMPLING_GLSL

#ifndef WINDROW_TEXTURES
#define WINDROW_TEXTURES sampler3D // four components
#ifdef WINDROW_EXACT
// One texel; each index lies within the box.
vec4 windrow_texel(WINDROW_TEXTURES textures, ivec3 texel) { return texelFetch(textures, texel, 0); }
#else
// Filtered, at a place that is 0 to 1 along each axis of the box.
vec4 windrow_texture(WINDROW_TEXTURES textures, vec3 place) { return textureLod(textures, place, 0.0f); }
#endif
#endif

#include "../numerics/ambient.glsl"
#include "../numerics/wall_law.glsl"
#include "../numerics/window.glsl"

// The same layout as windrow::WindowBlock (fluid/textures.h), which says more of each field.
struct WindrowWindow {
    vec3 origin;
    float cell_size;
    vec3 cells;
    float factor;
    vec3 previous_origin;
    float rows;
    vec3 ambient;
    float height;
    vec3 low_boundaries;
    float wall_per_length;
    vec3 high_boundaries;
    float wall_per_log;
    vec3 blend_centre;
    float blend_width;
    vec3 blend_reach;
    float wall_lowest;
    vec3 previous_blend_centre;
    float wall_fall;
};

// The same layout as windrow::AxisBlock: factors of a coordinate p [m] from the anchor.
struct WindrowAxis {
    float texture_scale, texture_offset, inner_scale, inner_offset, edge_scale, low_edge, high_edge, smoothness;
};
struct WindrowPlace {
    WindrowAxis x, y, z;
};

// The same layout as windrow::FrameBlock without its rows, in a uniform block (std140) and in a buffer (std430) alike: 560 bytes,
// then WINDROW_ROW_BLOCKS vec4 of rows.
#define WINDROW_ROW_BLOCKS 32
struct WindrowFrame {
    WindrowWindow window;
    WindrowPlace place, previous_place;
    WindrowAmbient ambient, previous_ambient;
};

float windrow_axis_share(WindrowAxis axis, float p) {
    return windrow_edge_share(axis.low_edge + axis.edge_scale * p, axis.high_edge - axis.edge_scale * p, axis.smoothness);
}

// [m] Height of a row's centre over the box's low boundary, FrameBlock::heights: yours, below this text, where you declare the
// block. It is called where window.rows is above 0.
#ifndef WINDROW_EQUAL_ROWS // define it where no wind has rows of its own
float windrow_row_height(WINDROW_TEXTURES textures, int row);

// A height over the low boundary in rows: j + 1/2 at the centre of row j, linear between centres.
float windrow_row_place(WINDROW_TEXTURES textures, int rows, float height) {
    int low = 0, high = rows - 1;
    while (high - low > 1) {
        int middle = (low + high) >> 1;
        if (windrow_row_height(textures, middle) <= height)
            low = middle;
        else
            high = middle;
    }
    float below = windrow_row_height(textures, low), above = windrow_row_height(textures, high);
    return float(low) + 0.5f + (height - below) / (above - below);
}
#endif

#if defined(WINDROW_THREE_TEXTURES) || defined(WINDROW_SMOOTH_GROUND) // define the second where no wind has a roughness
vec3 windrow_lowered(WindrowWindow window, vec4 air, float over_floor) { return air.xyz; }
#else
// Of what a texture holds, by the law of the wall.
vec3 windrow_lowered(WindrowWindow window, vec4 air, float over_floor) {
    float height = windrow_wall_height(air.w, over_floor, window.wall_lowest, window.wall_fall);
    return windrow_wall_share(height, window.wall_per_length, window.wall_per_log) * air.xyz;
}
#endif

// The textures at p, trilinear; `origin` [m] is the box's low corner.
#ifdef WINDROW_EXACT
vec4 windrow_texel_blend(vec4 a, vec4 b, float t) { return a + t * (b - a); }

vec3 windrow_box_velocity(WINDROW_TEXTURES textures, WindrowWindow window, WindrowPlace place, vec3 origin, vec3 p) {
    vec3 kinds = window.low_boundaries, local = (p - origin) / window.cell_size;
#ifndef WINDROW_EQUAL_ROWS
    if (window.rows > 0.0f)
        local.y = windrow_row_place(textures, int(window.rows), p.y - origin.y);
#endif
    vec3 at = vec3(windrow_axis_sample(local.x, window.cells.x, kinds.x), windrow_axis_sample(local.y, window.cells.y, kinds.y),
                   windrow_axis_sample(local.z, window.cells.z, kinds.z)) -
              0.5f;
    vec3 below = floor(at), t = at - below;
    ivec3 cells = ivec3(window.cells), under = ivec3(below);
    ivec3 low = ivec3(windrow_axis_texel(under.x, cells.x, kinds.x), windrow_axis_texel(under.y, cells.y, kinds.y),
                      windrow_axis_texel(under.z, cells.z, kinds.z));
    ivec3 high = ivec3(windrow_axis_texel(under.x + 1, cells.x, kinds.x), windrow_axis_texel(under.y + 1, cells.y, kinds.y),
                       windrow_axis_texel(under.z + 1, cells.z, kinds.z));
    vec4 ll = windrow_texel_blend(windrow_texel(textures, low), windrow_texel(textures, ivec3(high.x, low.y, low.z)), t.x);
    vec4 hl = windrow_texel_blend(windrow_texel(textures, ivec3(low.x, high.y, low.z)),
                                  windrow_texel(textures, ivec3(high.x, high.y, low.z)), t.x);
    vec4 lh = windrow_texel_blend(windrow_texel(textures, ivec3(low.x, low.y, high.z)),
                                  windrow_texel(textures, ivec3(high.x, low.y, high.z)), t.x);
    vec4 hh = windrow_texel_blend(windrow_texel(textures, ivec3(low.x, high.y, high.z)), windrow_texel(textures, high), t.x);
    vec4 air = windrow_texel_blend(windrow_texel_blend(ll, hl, t.y), windrow_texel_blend(lh, hh, t.y), t.z);
    return windrow_lowered(window, air, p.y - origin.y);
}
#else
vec3 windrow_box_velocity(WINDROW_TEXTURES textures, WindrowWindow window, WindrowPlace place, vec3 origin, vec3 p) {
    vec3 at = vec3(place.x.texture_scale * p.x + place.x.texture_offset, place.y.texture_scale * p.y + place.y.texture_offset,
                   place.z.texture_scale * p.z + place.z.texture_offset);
    float over_floor = window.height * at.y;
#ifndef WINDROW_EQUAL_ROWS
    if (window.rows > 0.0f)
        at.y = windrow_row_place(textures, int(window.rows), over_floor) / window.rows;
#endif
    return windrow_lowered(window, windrow_texture(textures, at), over_floor); // the sampler wraps and clamps
}
#endif

// One frame's wind at p: its textures within its box, its ambient wind around it, which is only evaluated where it has a share.
vec3 windrow_blended_velocity(WINDROW_TEXTURES textures, WINDROW_TILE tile, WindrowWindow window, WindrowPlace place, vec3 origin,
                              WindrowAmbient ambient, vec3 p) {
    vec3 inner = vec3(place.x.inner_scale * p.x + place.x.inner_offset, place.y.inner_scale * p.y + place.y.inner_offset,
                      place.z.inner_scale * p.z + place.z.inner_offset);
    vec3 wind = windrow_box_velocity(textures, window, place, origin, p);
    if (!(max(max(abs(inner.x), abs(inner.y)), abs(inner.z)) <= 1.0f)) {
        float share = windrow_axis_share(place.x, p.x) * windrow_axis_share(place.y, p.y) * windrow_axis_share(place.z, p.z);
        vec3 outside = windrow_ambient(tile, ambient, p);
        wind = outside + share * (wind - outside);
    }
    return wind;
}

// [m/s] The wind at p [m] from the anchor of the block, of this frame's textures.
vec3 windrow_velocity_at(WINDROW_TEXTURES textures, WINDROW_TILE tile, WindrowFrame frame, vec3 p) {
    return windrow_blended_velocity(textures, tile, frame.window, frame.place, frame.window.origin, frame.ambient, p);
}

// [m/s] The same a frame ago, at the same place, of the textures of the frame before.
vec3 windrow_velocity_previous_at(WINDROW_TEXTURES textures, WINDROW_TILE tile, WindrowFrame frame, vec3 p) {
    return windrow_blended_velocity(textures, tile, frame.window, frame.previous_place, frame.window.previous_origin,
                                    frame.previous_ambient, p);
}

#endif
