// The streak of each pixel, of several samples.
#version 460
#extension GL_GOOGLE_include_directive : require

layout(constant_id = 0) const int samples = 4;
layout(set = 1, binding = 1) uniform sampler2DMS depth_map;

float depth_at(ivec2 pixel) {
    float nearest = texelFetch(depth_map, pixel, 0).r;
    for (int n = 1; n < samples; ++n)
        nearest = min(nearest, texelFetch(depth_map, pixel, n).r);
    return nearest;
}

#include "blur_streak.glsl"
