// A layer's fragment: the strand that it meets, in its light, or nothing.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shell_colour.glsl"
