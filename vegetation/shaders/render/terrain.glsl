// The terrain: a grid of heights.
#ifndef WINDROW_RENDER_TERRAIN_GLSL
#define WINDROW_RENDER_TERRAIN_GLSL

#include "frame.glsl"
#include "shaders/numerics/place_noise.glsl"

float terrain_sample(ivec2 at) {
    ivec2 held = clamp(at, ivec2(0), frame.terrain_size.xy - 1);
    return terrain_heights[held.y * frame.terrain_size.x + held.x] + frame.terrain.w;
}

vec3 terrain_point(ivec2 at) {
    vec2 level = frame.terrain.xy + frame.terrain.z * vec2(at);
    return vec3(level.x, terrain_sample(at), level.y);
}

// By central differences, one-sided at the rim.
vec3 terrain_normal(ivec2 at) {
    ivec2 low = max(at - 1, ivec2(0)), high = min(at + 1, frame.terrain_size.xy - 1);
    float along_x = (terrain_sample(ivec2(high.x, at.y)) - terrain_sample(ivec2(low.x, at.y))) /
                    (frame.terrain.z * float(max(high.x - low.x, 1)));
    float along_z = (terrain_sample(ivec2(at.x, high.y)) - terrain_sample(ivec2(at.x, low.y))) /
                    (frame.terrain.z * float(max(high.y - low.y, 1)));
    return normalize(vec3(-along_x, 1.0, -along_z));
}

#endif
