// field_blades.glsl for blades that the wind bends at once.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "field_blades.glsl"
