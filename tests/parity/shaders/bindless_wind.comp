#version 460
#extension GL_GOOGLE_include_directive : require
#define WINDROW_EXACT
#include "bindless_wind.glsl"
