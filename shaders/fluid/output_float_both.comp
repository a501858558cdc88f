#version 460
#extension GL_GOOGLE_include_directive : require
#define WINDROW_VECTORS rgba32f
#define WINDROW_AXES r32f
#include "fluid/output.glsl"
