#version 460
#extension GL_GOOGLE_include_directive : require
#define WINDROW_READ_CELL vec4
#define WINDROW_READ(u) (u)
#include "fluid/read.glsl"
