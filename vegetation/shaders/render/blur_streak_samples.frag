// The streak of each pixel, of four samples.
#version 460
#extension GL_GOOGLE_include_directive : require

layout(set = 1, binding = 1) uniform sampler2DMS depth_map;

float depth_at(ivec2 pixel) {
    return min(min(texelFetch(depth_map, pixel, 0).r, texelFetch(depth_map, pixel, 1).r),
               min(texelFetch(depth_map, pixel, 2).r, texelFetch(depth_map, pixel, 3).r));
}

#include "blur_streak.glsl"
