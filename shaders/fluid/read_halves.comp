#version 460
#extension GL_GOOGLE_include_directive : require
#define WINDROW_READ_CELL uvec2
#define WINDROW_READ(u) halves(u)

// Finite, as in a texture.
uvec2 halves(vec4 u) {
    u = clamp(u, -65504.0f, 65504.0f);
    return uvec2(packHalf2x16(u.xy), packHalf2x16(u.zw));
}

#include "fluid/read.glsl"
