// The second axis of a transform whose planes do not fit in shared memory: modes to modes, in place.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "fluid/pass.glsl"
#include "fluid/hat.glsl"

layout(std430, set = 0, binding = 2) readonly buffer Tables { float tables[]; };
layout(std430, set = 0, binding = 3) buffer Hat { float hat[]; };

float load(ivec3 mode) { return hat[hat_index(mode)]; }

void store(ivec3 mode, float value) { hat[hat_index(mode)] = value; }

#include "fluid/modes.glsl"
