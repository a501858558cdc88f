// The visible blades of a field in the wind.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "field_blades.glsl"
