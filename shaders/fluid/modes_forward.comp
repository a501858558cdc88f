// First stage of a direct solve: the right-hand side, made here, to modes of x and z.
//
//   projection        rhs = (differences of w) / 2        (phi / h, so that no h appears; w is without the sources' flow)
//   volume sources    rhs = -h S, less phi beyond open boundaries
#version 460
#extension GL_GOOGLE_include_directive : require
#include "fluid/pass.glsl"
#include "fluid/hat.glsl"

layout(std430, set = 0, binding = 2) readonly buffer Tables { float tables[]; };
layout(std430, set = 0, binding = 3) readonly buffer Arrived { vec4 arrived[]; };
layout(std430, set = 0, binding = 4) readonly buffer Expansion { float expansion[]; };
layout(std430, set = 0, binding = 5) writeonly buffer Hat { float hat[]; };

#define WINDROW_MOTORS 6
#include "fluid/free_air.glsl"
#define WINDROW_FIELD(at) arrived[at]
#include "fluid/divergence.glsl"

const int k_of_sources = 1; // push.part: 0 the projection of w, 1 the flow of the volume sources

float load(ivec3 cell) {
    if (push.part == k_of_sources) {
        float rhs = 0.0f;
        if (is_on(WINDROW_EXPANDS)) {
            rhs = -tick.cell_size * expansion[cell_index(cell)];
            for (int axis = 0; axis < 3; ++axis)
                rhs -= beyond(cell, axis, -1) + beyond(cell, axis, 1);
        }
        return rhs;
    }
    return 0.5f * differences(cell);
}

void store(ivec3 mode, float value) { hat[hat_index(mode)] = value; }

#include "fluid/modes.glsl"
