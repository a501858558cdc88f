// What the sheet of clouds leaves of the sun, about the eye: cloud_map.glsl reads it.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame.glsl"

layout(location = 0) in vec2 ndc;
layout(location = 0) out float left;

void main() {
    vec2 uv = 0.5 * ndc + 0.5;
    left = windrow_cloud_left(frame.clouds, frame.cloud_map.xy + uv / frame.cloud_map.z);
}
