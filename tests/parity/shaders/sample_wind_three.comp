#version 460
#extension GL_GOOGLE_include_directive : require
#define WINDROW_THREE_TEXTURES
#include "sample_wind.glsl"
