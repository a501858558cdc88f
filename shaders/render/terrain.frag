// Near the eye soil between the roots; afar the meadow's own mean colour, since blades end before the terrain does.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "plant_look.glsl"
#include "shading.glsl"
#include "terrain.glsl"
#include "../numerics/motion_vector.glsl"

layout(std140, set = 2, binding = 0) uniform Look { PlantLook look; };

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 clip_now;
layout(location = 3) in vec3 clip_before;
layout(location = 0) out vec4 colour;
layout(location = 1) out vec2 motion;

const vec3 k_soil = vec3(0.055, 0.040, 0.024);

void main() {
    vec2 place = position.xz - frame.terrain.xy;
    float dryness = smoothstep(0.35, 0.8, windrow_dryness(place));
    float grain = windrow_place_noise(place / 0.045) * 0.6 + windrow_place_noise(place / 0.013) * 0.4;
    float distance = length(position - frame.eye.xyz);
    vec3 n = normalize(normal);
    vec3 to_sun = frame.sky.sun.xyz;

    // Afar one looks across tips and sees no soil.
    float grown = smoothstep(0.25, 1.0, distance / look.size.y);
    vec3 tips = mix(mix(look.root.rgb, look.tip.rgb, 0.72), look.dry.rgb, 0.5 * dryness);
    float patches = windrow_place_noise(place / 0.5) + windrow_place_noise(place / 2.3 + 11.0) + 1.4 * windrow_place_noise(place / 31.0 + 5.0);
    tips *= mix(0.6, 1.1, patches / 3.4);
    vec3 soil = mix(k_soil * mix(0.55, 1.25, grain), look.root.rgb, 0.45);
    vec3 albedo = mix(soil, tips, grown);

    float lit = sun_share(position, n);
    float facing = mix(max(dot(n, to_sun), 0.0), windrow_half_lambert(dot(n, to_sun)), grown);
    float open = mix(0.5, 0.85, grown);
    vec3 radiance = albedo * (0.318309886 * frame.sunlight.rgb * (facing * lit * mix(0.7, 0.9, grown)) +
                              open * windrow_around(n, frame.skylight.rgb, frame.groundlight.rgb));
    colour = vec4(fogged(radiance, position), 1.0);
    motion = windrow_motion_vector(clip_now, clip_before);
}
