#version 460
#extension GL_GOOGLE_include_directive : require
#define WINDROW_EXACT
#include "sample_wind.glsl"
