#version 460
#extension GL_GOOGLE_include_directive : require
#define NONUNIFORM
#include "bindless_wind.glsl"
