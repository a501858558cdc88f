#version 460
#extension GL_GOOGLE_include_directive : require
#define WINDROW_VECTORS rgba32f
#include "fluid/output.glsl"
