// Update of the volume sources' flow, u_S = -grad phi, in the wind of this tick and of the last: the trajectories extrapolate
// u - u_old, which must not jump. Then the guard and the reduction, which need the new flow.
#version 460
#extension GL_GOOGLE_include_directive : require
#define WINDROW_READS_TILE 7
#include "fluid/pass.glsl"
#include "fluid/stencil.glsl"

layout(std430, set = 0, binding = 2) readonly buffer Potential { float potential[]; };
layout(std430, set = 0, binding = 3) buffer SourceFlow { vec4 source_flow[]; };
layout(std430, set = 0, binding = 4) buffer Velocity { vec4 velocity[]; };
layout(std430, set = 0, binding = 5) buffer VelocityOld { vec4 velocity_old[]; };
layout(std430, set = 0, binding = 6) writeonly buffer History { vec4 history[]; };
#define WINDROW_MOTORS 8
#include "fluid/free_air.glsl"
#include "fluid/guard.glsl"

shared uint group_largest;

void main() {
    const ivec3 cell = ivec3(gl_GlobalInvocationID);
    if (gl_LocalInvocationIndex == 0)
        group_largest = 0;
    barrier();
    if (inside(cell, tick.cells)) {
        const int at = cell_index(cell);
        vec3 flow = vec3(0.0f);
        if (is_on(WINDROW_EXPANDS))
            for (int axis = 0; axis < 3; ++axis) {
                float below, above;
                const int low = cell_index(neighbour(cell, axis, -1, tick.potential_low, tick.potential_high, below));
                const int high = cell_index(neighbour(cell, axis, 1, tick.potential_low, tick.potential_high, above));
                flow[axis] = -0.5f * (above * potential[high] - below * potential[low]);
                flow[axis] -= 0.5f * (beyond(cell, axis, 1) - beyond(cell, axis, -1));
            }
        const vec4 change = vec4(flow - source_flow[at].xyz, 0.0f);
        source_flow[at] = vec4(flow, 0.0f);
        velocity[at] += change;
        if (!is_on(WINDROW_FRESH))
            velocity_old[at] += change;
        if (broken(velocity[at]))
            repair(cell, at);
        atomicMax(group_largest, floatBitsToUint(largest_component(velocity[at].xyz)));
    }
    barrier();
    if (gl_LocalInvocationIndex == 0)
        atomicMax(control.fastest_component, group_largest);
}
