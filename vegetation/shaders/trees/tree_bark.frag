// Bark: furrows along the stem or marks across it, in sun and shade.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "../render/shading.glsl"
#include "../numerics/motion_vector.glsl"
#include "shaders/numerics/place_noise.glsl"
#include "tree_parts.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 wood;
layout(location = 3) in vec4 open;
layout(location = 4) in vec3 clip_now;
layout(location = 5) in vec3 clip_before;
layout(location = 0) out vec4 colour;
layout(location = 1) out vec2 motion;

void main() {
    vec3 n = normalize(normal);
    vec3 to_sun = frame.sky.sun.xyz;
    // Half way around, in metres of bark: ridges are as wide on a limb as on the trunk.
    vec2 bark = vec2(wood.x * 3.14159265 * max(wood.z, 0.02), wood.y) + 20.0 * wood.w;
    float seen = clamp(1.2 - 12.0 * (fwidth(bark.x) + 0.25 * fwidth(bark.y)), 0.0, 1.0); // finer than a pixel: even
    float warp = 0.05 * windrow_place_noise(bark * vec2(9.0, 2.5));
    float ridges = windrow_place_noise(vec2((bark.x + warp) * 26.0, bark.y * 4.0));
    ridges = 0.65 * ridges + 0.35 * windrow_place_noise(bark * vec2(70.0, 16.0) + 9.0);
    float furrows = smoothstep(0.3, 0.55, ridges);
    // Marks across: short dark lines, and black where limbs and the root leave.
    float marks =
        windrow_place_noise(vec2(bark.x * 9.0, bark.y * 42.0)) * (0.55 + 0.45 * windrow_place_noise(bark * vec2(3.0, 1.1)));
    float lines = 1.0 - smoothstep(0.5, 0.6, marks);
    lines *= smoothstep(0.02, 0.06, wood.z); // twigs have no white bark yet
    lines *= mix(smoothstep(0.15, 1.3, wood.y + 0.8 * windrow_place_noise(bark * 6.0)), 1.0, step(wood.z, 0.05));
    float ridge = mix(0.65, mix(furrows, lines, kind.bark.w), seen);
    ridge = mix(ridge, lines, kind.bark.w * (1.0 - seen) * 0.7);
    vec3 albedo = mix(kind.furrow.rgb, kind.bark.rgb, ridge) * (1.0 + 0.15 * wood.w);

    float through_crown = clamp(open.w + dot(open.xyz, to_sun), 0.0, 1.0);
    float lit = sun_fraction(position, n) * mix(0.4, 1.0, through_crown);
    float sky = clamp(open.w + 0.6 * open.y, 0.08, 1.0);
    vec3 radiance = albedo * (0.318309886 * frame.sunlight.rgb * (max(dot(n, to_sun), 0.0) * lit) +
                              sky * windrow_around(n, frame.skylight.rgb, frame.groundlight.rgb));
    colour = vec4(fogged(radiance, position), 1.0);
    motion = windrow_motion_vector(clip_now, clip_before);
}
