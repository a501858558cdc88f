// The wind as a colour: red x, green y, blue z; a grey of 0.5 is still air, and 8 m/s is the end of the range.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "coupling/windrow_wind.glsl"

layout(location = 0) in vec3 place; // [m] from the anchor
layout(location = 0) out vec4 colour;

void main() { colour = vec4(0.5 + windrow_velocity(place) / 16.0, 1.0); }
