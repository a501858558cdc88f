// A lattice of places at which the wind is shown: set 2. The same layout as render::WindArrows::Block
// (vegetation/render/wind_arrows.h).
#ifndef WINDROW_RENDER_WIND_LATTICE_GLSL
#define WINDROW_RENDER_WIND_LATTICE_GLSL

#define WINDROW_SET 1
#include "shaders/coupling/windrow_wind.glsl"
#include "terrain.glsl"

layout(std140, set = 2, binding = 0) uniform WindLattice {
    vec4 corner; // xz [m] from the anchor, y lowest [m] above the ground, w [m] spacing
    ivec4 count; // along x, y, z
    vec4 look;   // x [m/s] at the top of the scale, y [s] of an arrow
    // clang-format off
} lattice;
// clang-format on

// [m] Height of the ground under a place, between its samples.
float terrain_height(vec2 place) {
    vec2 at = clamp((place - frame.terrain.xy) / frame.terrain.z, vec2(0.0), vec2(frame.terrain_size.xy - 1));
    ivec2 cell = ivec2(min(floor(at), vec2(frame.terrain_size.xy - 2)));
    vec2 s = at - vec2(cell);
    return mix(mix(terrain_sample(cell), terrain_sample(cell + ivec2(1, 0)), s.x),
               mix(terrain_sample(cell + ivec2(0, 1)), terrain_sample(cell + ivec2(1, 1)), s.x), s.y);
}

// [m] from the anchor.
vec3 lattice_place(int number) {
    ivec3 at = ivec3(number % lattice.count.x, (number / lattice.count.x) % lattice.count.y,
                     number / (lattice.count.x * lattice.count.y));
    vec2 level = lattice.corner.xz + lattice.corner.w * vec2(at.xz);
    return vec3(level.x, terrain_height(level) + lattice.corner.y + lattice.corner.w * float(at.y), level.y);
}

#endif
