#version 460
#extension GL_GOOGLE_include_directive : require
#define WINDROW_TEXEL rgba16f
#include "ground_pass.glsl"
