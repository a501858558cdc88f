// Solid things in the sun: Lambert's law, shadow, what is around, fog.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shading.glsl"
#include "../numerics/motion_vector.glsl"

layout(location = 0) centroid in vec3 position;
layout(location = 1) centroid in vec3 normal;
layout(location = 2) centroid in vec3 albedo;
layout(location = 3) centroid in vec3 clip_now;
layout(location = 4) centroid in vec3 clip_before;
layout(location = 0) out vec4 colour;
layout(location = 1) out vec2 motion;

void main() {
    vec3 n = normalize(normal);
    n = dot(n, frame.eye.xyz - position) < 0.0 ? -n : n;
    vec3 to_sun = frame.sky.sun.xyz;
    float facing = max(dot(n, to_sun), 0.0);
    vec3 radiance = albedo * (0.318309886 * frame.sunlight.rgb * facing * sun_fraction(position, n) +
                              windrow_around(n, frame.skylight.rgb, frame.groundlight.rgb));
    colour = vec4(fogged(radiance, position), 1.0);
    motion = windrow_motion_vector(clip_now, clip_before);
}
