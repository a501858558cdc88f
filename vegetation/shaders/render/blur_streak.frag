// The streak of each pixel, of one sample.
#version 460
#extension GL_GOOGLE_include_directive : require

layout(set = 1, binding = 1) uniform sampler2D depth_map;

float depth_at(ivec2 pixel) { return texelFetch(depth_map, pixel, 0).r; }

#include "blur_streak.glsl"
