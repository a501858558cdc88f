#version 460
#extension GL_GOOGLE_include_directive : require
#define WINDROW_VECTORS rgba16f
#define WINDROW_AXES r16f
#include "fluid/output.glsl"
