// Last stage of a direct solve: modes of x and z back to cells.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "fluid/pass.glsl"
#include "fluid/hat.glsl"

layout(std430, set = 0, binding = 2) readonly buffer Tables { float tables[]; };
layout(std430, set = 0, binding = 3) readonly buffer Hat { float hat[]; };
#include "fluid/solution.glsl"

float load(ivec3 mode) { return hat[hat_index(mode)]; }

#include "fluid/modes.glsl"
