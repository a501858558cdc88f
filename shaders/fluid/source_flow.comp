// Update of the volume sources' flow, u_S = -grad phi, in the wind of this tick and of the last: the trajectories extrapolate
// u - u_old, which must not jump. Then the guard and the reduction, which need the new flow.
#version 460
#extension GL_GOOGLE_include_directive : require
#define WINDROW_READS_TILE 6
#define WINDROW_BETWEEN_TICKS
#include "fluid/pass.glsl"
#include "fluid/stencil.glsl"

layout(std430, set = 0, binding = 2) readonly buffer Potential { float potential[]; };
layout(std430, set = 0, binding = 3) buffer SourceFlow { vec4 source_flow[]; };
layout(std430, set = 0, binding = 4) buffer Velocity { vec4 velocity[]; };
layout(std430, set = 0, binding = 5) writeonly buffer History { vec4 history[]; };
layout(std430, set = 0, binding = 8) readonly buffer Correction { float correction[]; };
layout(std430, set = 0, binding = 9) readonly buffer Direction { float direction[]; };
#define WINDROW_SOLIDS 10
#include "fluid/solids.glsl"
#define WINDROW_AROUND 11
#define WINDROW_AROUND_ACCESS readonly
#include "fluid/around.glsl"
#include "fluid/closed_slope.glsl"
#define WINDROW_MOTORS 7
#include "fluid/free_air.glsl"
#include "fluid/guard.glsl"

shared uint group_largest;
shared uint group_in_rows;

void main() {
    const ivec3 cell = ivec3(gl_GlobalInvocationID);
    if (gl_LocalInvocationIndex == 0)
        group_largest = group_in_rows = 0;
    barrier();
    if (inside(cell, tick.cells)) {
        const int at = cell_index(cell);
        vec3 flow = vec3(0.0f);
        const int record = has_obstacles() ? solid_record(cell) : -1;
        if (is_on(WINDROW_EXPANDS) && !record_is(record, WINDROW_INSIDE))
            for (int axis = 0; axis < 3; ++axis) {
                float below, above;
                const int low = cell_index(neighbour(cell, axis, -1, tick.potential_low, tick.potential_high, below));
                const int high = cell_index(neighbour(cell, axis, 1, tick.potential_low, tick.potential_high, above));
                flow[axis] = -0.5f * (above * phi_at(high) - below * phi_at(low));
                flow[axis] -= 0.5f * (beyond(cell, axis, 1) - beyond(cell, axis, -1));
                if (k_own_rows && axis == 1)
                    flow[axis] *= row_scale(cell.y);
            }
        if (is_on(WINDROW_EXPANDS) && record >= 0 && !record_is(record, WINDROW_INSIDE)) {
            vec3 over_high_faces;
            flow += closed_slopes(record, cell, over_high_faces);
        }
        const vec4 change = vec4(flow - source_flow[at].xyz, 0.0f);
        source_flow[at] = vec4(flow, 0.0f);
        vec4 u = velocity[now(at)] + change;
        velocity[now(at)] = u;
        if (!is_on(WINDROW_FRESH))
            velocity[ago(at)] += change;
        if (broken(u)) {
            repair(cell, at, elapsed());
            u = velocity[now(at)];
        }
        atomicMax(group_largest, floatBitsToUint(largest_component(u.xyz)));
        if (k_own_rows)
            atomicMax(group_in_rows, floatBitsToUint(largest_component(in_rows(u.xyz, cell.y))));
    }
    barrier();
    if (gl_LocalInvocationIndex == 0)
        atomicMax(control.fastest_component, group_largest);
    if (k_own_rows && gl_LocalInvocationIndex == 0)
        atomicMax(control.fastest_in_rows, group_in_rows);
}
