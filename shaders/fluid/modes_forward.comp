// First stage of a direct solve: the right-hand side, made here, to modes of x and z.
//
//   projection        rhs = (differences of w) / 2        (phi / h, so that no h appears; w is without the sources' flow)
//   volume sources    rhs = -h S, less phi beyond open boundaries
//   obstacles         the divergence with closed faces, plus what they hold of the last step's phi; in corrections the residual
#version 460
#extension GL_GOOGLE_include_directive : require
#define WINDROW_READS_TILE 9
#include "fluid/pass.glsl"
#include "fluid/hat.glsl"

layout(std430, set = 0, binding = 2) readonly buffer Tables { float tables[]; };
layout(std430, set = 0, binding = 3) readonly buffer Arrived { vec4 arrived[]; };
layout(std430, set = 0, binding = 4) readonly buffer Expansion { float expansion[]; };
layout(std430, set = 0, binding = 5) writeonly buffer Hat { float hat[]; };

#include "fluid/right_side.glsl"

void store(ivec3 mode, float value) { hat[hat_index(mode)] = value; }

#include "fluid/modes.glsl"
