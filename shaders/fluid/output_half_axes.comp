#version 460
#extension GL_GOOGLE_include_directive : require
#define WINDROW_AXES r16f
#define WINDROW_TEXEL(u) clamp(u, -65504.0f, 65504.0f)
#include "fluid/output.glsl"
