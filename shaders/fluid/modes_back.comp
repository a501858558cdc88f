// Last stage of a direct solve: modes of x and z back to cells.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "fluid/pass.glsl"
#include "fluid/hat.glsl"

layout(std430, set = 0, binding = 2) readonly buffer Tables { float tables[]; };
layout(std430, set = 0, binding = 3) readonly buffer Hat { float hat[]; };
layout(std430, set = 0, binding = 4) writeonly buffer Potential { float potential[]; };

float load(ivec3 mode) { return hat[hat_index(mode)]; }

void store(ivec3 cell, float value) { potential[cell_index(cell)] = value; }

#include "fluid/modes.glsl"
