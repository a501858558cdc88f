// Implicit diffusion of one component (push.part): last stage, modes to cells. Where the sub-step is short enough for the
// explicit pass, that one's result stays.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "fluid/pass.glsl"
#include "fluid/hat.glsl"
#include "fluid/viscosity.glsl"

layout(std430, set = 0, binding = 2) readonly buffer Tables { float tables[]; };
layout(std430, set = 0, binding = 3) readonly buffer Hat { float hat[]; };
layout(std430, set = 0, binding = 4) buffer Diffused { vec4 diffused[]; };

float load(ivec3 mode) { return hat[hat_index(mode)]; }

void store(ivec3 cell, float value) {
    if (is_implicit())
        diffused[cell_index(cell)][push.part] = value + still_wind()[push.part];
}

#include "fluid/modes.glsl"
