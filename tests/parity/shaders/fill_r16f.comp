#version 450
#extension GL_GOOGLE_include_directive : require
#define FORMAT r16f
#include "fill.glsl"
