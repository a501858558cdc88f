// Grass in the sun: its light comes from its rows (field_blade.vert).
#version 460
#extension GL_GOOGLE_include_directive : require
#include "blade_light.glsl"
#include "frame.glsl"
#include "../numerics/motion_vector.glsl"

// Centroid: where a pixel's middle lies beside a thin blade, values from beyond its edge would sparkle.
layout(location = 0) centroid in vec3 leaf;
layout(location = 1) centroid in vec3 lit;
layout(location = 2) in vec3 clip_before; // at the pixel's middle, which is where it is now
layout(location = 0) out vec4 colour;
layout(location = 1) out vec2 motion;

void main() {
    colour = vec4(blade_radiance(leaf, lit.xy, lit.z), 1.0);
    motion = windrow_motion_vector(vec3(gl_FragCoord.xy * frame.pixel.xy - 1.0, 1.0), clip_before);
}
