#version 460
#extension GL_GOOGLE_include_directive : require
#define WINDROW_EQUAL_ROWS
#include "sample.glsl"
