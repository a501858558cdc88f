// Grass in the sun: what changes over the width of a blade. What changes along it comes from its rows.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame.glsl"
#include "grass_light.glsl"
#include "../numerics/motion_vector.glsl"

layout(std140, set = 2, binding = 0) uniform Look { PlantLook look; };

// Centroid: where a pixel's middle lies beside a thin blade, values from beyond its edge would sparkle.
layout(location = 0) centroid in vec4 leaf;
layout(location = 1) centroid in vec4 through;
layout(location = 2) centroid in vec4 normal;
layout(location = 3) centroid in vec4 across;
layout(location = 4) centroid in vec4 fog;
layout(location = 5) centroid in vec4 to_eye;
layout(location = 6) centroid in vec3 clip_now;
layout(location = 7) centroid in vec3 clip_before;
layout(location = 8) centroid in vec3 canopy;
layout(location = 0) out vec4 colour;
layout(location = 1) out vec2 motion;

void main() {
    vec3 sight = normalize(to_eye.xyz);
    vec3 n = normal.xyz + clamp(3.0 * leaf.w, -1.0, 1.0) * across.xyz;
    n = normalize(mix(normalize(n), canopy, through.w));
    vec3 radiance = grass_radiance(look, leaf.rgb, through.rgb, n, frame.sky.sun.xyz, sight, frame.sunlight.rgb * normal.w,
                                   frame.skylight.rgb * across.w, frame.groundlight.rgb * across.w, to_eye.w);
    colour = vec4(mix(fog.rgb, radiance, fog.w), 1.0);
    motion = windrow_motion_vector(clip_now, clip_before);
}
