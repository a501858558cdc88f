// field_blades.glsl for blades that swing.
#version 460
#extension GL_GOOGLE_include_directive : require
#define FIELD_SWINGS
#include "field_blades.glsl"
