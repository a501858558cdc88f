// The wind in a shader: the box's wind, faded over the blend zone to the ambient wind. For any stage.
//
//     #extension GL_GOOGLE_include_directive : require
//     #define WINDROW_SET 2                          // yours; default 0
//     #include "coupling/windrow_wind.glsl"
//     vec3 u = windrow_velocity(p);                  // [m/s] at p [m] from the anchor
//     vec3 before = windrow_velocity_previous(p);    // a frame ago, for motion vectors
//     vec3 felt = windrow_apparent(u, p, v);         // relative to an object that moves at v [m/s]
//
// Set WINDROW_SET (0 unless defined), bindings from WINDROW_BINDING (0 unless defined):
//   + 0        uniform buffer    windrow::FrameBlock (fluid/textures.h), copied as it is; at an offset that is a multiple of
//                                the device's minUniformBufferOffsetAlignment
//   + 1, 2, 3  sampler3D         textures of this frame: x, y, z
//   + 4, 5, 6  sampler3D         textures of the frame before
//   + 7        storage buffer    the gust tile, 128 x 16 x 128 vec4 (GustTile::texels); any buffer of 16 bytes where there are no
//                                gusts
// Any sampler does: texels are fetched and blended by hand, since texture units weigh with 8 fractional bits.
#ifndef WINDROW_WIND_GLSL
#define WINDROW_WIND_GLSL

#ifndef WINDROW_SET
#define WINDROW_SET 0
#endif
#ifndef WINDROW_BINDING
#define WINDROW_BINDING 0
#endif

layout(std430, set = WINDROW_SET, binding = WINDROW_BINDING + 7) readonly buffer WindrowTile { vec4 windrow_tile_texels[]; };
#define WINDROW_TILE int
vec3 windrow_tile_texel(int tile, ivec3 texel) { return windrow_tile_texels[(texel.z * 16 + texel.y) * 128 + texel.x].xyz; }

#include "../numerics/ambient.glsl"
#include "../numerics/window.glsl"

// The same layout as windrow::WindowBlock (fluid/textures.h), which says more of each field.
struct WindrowWindow {
    vec3 origin;
    float cell_size;
    vec3 cells;
    float factor;
    vec3 previous_origin, ambient, low_boundaries, high_boundaries;
    vec3 blend_centre;
    float blend_width;
    vec3 blend_reach, previous_blend_centre;
};

layout(std140, set = WINDROW_SET, binding = WINDROW_BINDING) uniform WindrowFrame {
    WindrowWindow windrow_window;
    WindrowAmbient windrow_ambient_now;
    WindrowAmbient windrow_ambient_before;
};
layout(set = WINDROW_SET, binding = WINDROW_BINDING + 1) uniform sampler3D windrow_x;
layout(set = WINDROW_SET, binding = WINDROW_BINDING + 2) uniform sampler3D windrow_y;
layout(set = WINDROW_SET, binding = WINDROW_BINDING + 3) uniform sampler3D windrow_z;
layout(set = WINDROW_SET, binding = WINDROW_BINDING + 4) uniform sampler3D windrow_x_before;
layout(set = WINDROW_SET, binding = WINDROW_BINDING + 5) uniform sampler3D windrow_y_before;
layout(set = WINDROW_SET, binding = WINDROW_BINDING + 6) uniform sampler3D windrow_z_before;

// Share of the box's wind at p, with the box's corner and the point that its rim follows, all [m] from the anchor.
float windrow_box_fraction(vec3 p, vec3 origin, vec3 blend_centre) {
    vec3 local = (p - origin) / windrow_window.cell_size;
    float share = 1.0;
    for (int axis = 0; axis < 3; ++axis) {
        if (windrow_window.blend_reach[axis] > 0.0)
            share *= windrow_blend_fraction(p[axis] - blend_centre[axis], windrow_window.blend_reach[axis],
                                            windrow_window.blend_width);
        share *= windrow_axis_fraction(local[axis], windrow_window.cells[axis], windrow_window.low_boundaries[axis],
                                       windrow_window.high_boundaries[axis]);
    }
    return share;
}

// The texels around p: the low and the high one of each axis, and how far between them it lies.
void windrow_texels_around(vec3 p, vec3 origin, out ivec3 low, out ivec3 high, out vec3 between) {
    vec3 local = (p - origin) / windrow_window.cell_size;
    for (int axis = 0; axis < 3; ++axis) {
        float cells = windrow_window.cells[axis];
        bool wraps = windrow_window.low_boundaries[axis] == 2.0;
        float at = windrow_axis_sample(local[axis], cells, windrow_window.low_boundaries[axis]) - 0.5;
        float below = floor(at);
        between[axis] = at - below;
        int last = int(cells) - 1;
        low[axis] = int(below);
        high[axis] = low[axis] + 1;
        if (wraps) {
            low[axis] = low[axis] < 0 ? last : low[axis];
            high[axis] = high[axis] > last ? 0 : high[axis];
        }
        low[axis] = clamp(low[axis], 0, last);
        high[axis] = clamp(high[axis], 0, last);
    }
}

// One component, trilinear.
float windrow_component(sampler3D texels, ivec3 low, ivec3 high, vec3 between) {
    float ll = mix(texelFetch(texels, low, 0).x, texelFetch(texels, ivec3(high.x, low.y, low.z), 0).x, between.x);
    float hl = mix(texelFetch(texels, ivec3(low.x, high.y, low.z), 0).x, texelFetch(texels, ivec3(high.x, high.y, low.z), 0).x,
                   between.x);
    float lh = mix(texelFetch(texels, ivec3(low.x, low.y, high.z), 0).x, texelFetch(texels, ivec3(high.x, low.y, high.z), 0).x,
                   between.x);
    float hh = mix(texelFetch(texels, ivec3(low.x, high.y, high.z), 0).x, texelFetch(texels, high, 0).x, between.x);
    return mix(mix(ll, hl, between.y), mix(lh, hh, between.y), between.z);
}

// One frame's wind at p: its textures within its box, its ambient wind around it.
vec3 windrow_frame_velocity(sampler3D x, sampler3D y, sampler3D z, WindrowAmbient ambient, vec3 origin, vec3 blend_centre,
                            vec3 p) {
    float share = windrow_box_fraction(p, origin, blend_centre);
    if (!(share > 0.0))
        return windrow_ambient(0, ambient, p);
    ivec3 low, high;
    vec3 between;
    windrow_texels_around(p, origin, low, high, between);
    vec3 inside = vec3(windrow_component(x, low, high, between), windrow_component(y, low, high, between),
                       windrow_component(z, low, high, between));
    return share < 1.0 ? mix(windrow_ambient(0, ambient, p), inside, share) : inside;
}

// [m/s] The wind at p [m] from the anchor.
vec3 windrow_velocity(vec3 p) {
    return windrow_frame_velocity(windrow_x, windrow_y, windrow_z, windrow_ambient_now, windrow_window.origin,
                                  windrow_window.blend_centre, p);
}

// [m/s] The same a frame ago, at the same place.
vec3 windrow_velocity_previous(vec3 p) {
    return windrow_frame_velocity(windrow_x_before, windrow_y_before, windrow_z_before, windrow_ambient_before,
                                  windrow_window.previous_origin, windrow_window.previous_blend_centre, p);
}

// [m/s] What a thing at p that moves at `velocity` [m/s] feels of a wind u: with detail, strength and limit as FrameBlock says.
vec3 windrow_apparent(vec3 u, vec3 p, vec3 velocity) { return windrow_felt(0, windrow_ambient_now, u - velocity, p); }

#endif
