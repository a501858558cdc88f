// The clear sky without the sun's disk, a texel for several pixels: sky.frag reads it.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "sky_light.glsl"

layout(location = 0) in vec2 ndc;
layout(location = 0) out vec4 light;

void main() { light = vec4(min(windrow_sky_radiance(frame.sky, sky_direction(ndc)), vec3(6e4)), 1.0); } // what half floats hold
