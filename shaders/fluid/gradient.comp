// Last pass of a sub-step:
//
//   u' = w - grad phi + background wind, in the slot of u_old,   q' by history.glsl
//
// and a rehearsal: u_old = 2 u - u'. That of a tick's last sub-step also guards u' and finds the largest speed, for a next tick that
// begins without `sources`; its first one then keeps the air before it.
#version 460
#extension GL_GOOGLE_include_directive : require
#define WINDROW_READS_TILE 7
#include "fluid/pass.glsl"
#include "fluid/stencil.glsl"
#include "numerics/substeps.glsl"

layout(std430, set = 0, binding = 2) readonly buffer Potential { float potential[]; };
layout(std430, set = 0, binding = 3) readonly buffer Arrived { vec4 arrived[]; };
layout(std430, set = 0, binding = 4) buffer SourceFlow { vec4 source_flow[]; };
layout(std430, set = 0, binding = 5) buffer Velocity { vec4 velocity[]; };
layout(std430, set = 0, binding = 6) buffer History { vec4 history[]; };
layout(std430, set = 0, binding = 12) writeonly buffer Before { vec4 before[]; };
layout(std430, set = 0, binding = 8) readonly buffer Correction { float correction[]; };
layout(std430, set = 0, binding = 9) readonly buffer Direction { float direction[]; };
#define WINDROW_SOLIDS 10
#include "fluid/solids.glsl"
#define WINDROW_AROUND 11
#define WINDROW_AROUND_ACCESS
#include "fluid/around.glsl"
#include "fluid/closed_slope.glsl"
#include "fluid/guard.glsl"

shared uint group_largest;
shared uint group_in_rows;
shared uint group_apart;

// The history of B phi at closed faces, as that of the gradient: each face by its low cell.
void keep_terms(int record, vec3 above, float weight, float kept) {
    for (int axis = 0; axis < 3; ++axis) {
        const int n = record_face(record, axis, 1);
        if (n < 0)
            continue;
        const float term = weight * above[axis];
        around_words[solids.history + n] = kept != 0.0f ? term + kept * around_words[solids.history + n] : term;
    }
}

bool is_last() { return !is_fresh() && push.substep + 1 == WINDROW_OF_PLAN.substeps; }

void step_cell(ivec3 cell) {
    const int at = cell_index(cell);
    if (is_on(WINDROW_COUNTED) && is_on(WINDROW_KEEPS) && push.substep == 0)
        before[at] = velocity[now(at)];
    vec3 slope = vec3(0.0f);
    if (is_on(WINDROW_PROJECTS))
        for (int axis = 0; axis < 3; ++axis) {
            float below, above;
            const int low = cell_index(neighbour(cell, axis, -1, tick.potential_low, tick.potential_high, below));
            const int high = cell_index(neighbour(cell, axis, 1, tick.potential_low, tick.potential_high, above));
            slope[axis] = 0.5f * (above * phi_at(high) - below * phi_at(low));
        }
    if (k_own_rows)
        slope.y *= row_scale(cell.y);
    const int record = has_obstacles() ? solid_record(cell) : -1;
    vec3 above = vec3(0.0f);
    if (record >= 0 && is_on(WINDROW_PROJECTS))
        slope -= closed_slopes(record, cell, above);
    if (k_outer && is_on(WINDROW_PROJECTS))
        slope += outer_gradient(cell);
    vec3 u = arrived[at].xyz - slope;
    float weight = 1.0f, kept = 0.0f;
    if (!is_on(WINDROW_STABLE_FLUIDS)) {
        const WindrowPast p = past();
        weight = p.weight;
        kept = p.kept;
        vec3 q = weight * slope;
        if (kept != 0.0f)
            q += kept * history[at].xyz;
        if (record_is(record, WINDROW_INSIDE)) // no past where a body leaves a cell
            q = vec3(0.0f);
        history[at] = vec4(q, 0.0f);
    }
    if (record >= 0 && is_on(WINDROW_PROJECTS))
        keep_terms(record, above, weight, kept);
    if (is_on(WINDROW_HAS_SOURCE_FLOW))
        u += source_flow[at].xyz;
    if (record_is(record, WINDROW_INSIDE) && is_on(WINDROW_PROJECTS)) {
        u = is_on(WINDROW_BODIES_MOVE) ? body_velocity(record_body(record), centre_of(cell)) : vec3(0.0f);
        if (is_on(WINDROW_HAS_SOURCE_FLOW))
            u += source_flow[at].xyz;
    } else if (is_on(WINDROW_GUSTS) && !record_is(record, WINDROW_SHELTERED)) {
        u += wind_at(cell, elapsed() + WINDROW_OF_PLAN.substep_duration, true);
    }
    if (is_fresh()) {
        if (record_is(record, WINDROW_INSIDE)) // deeper than a read's ghosts: the body's own, in both, as on the CPU
            velocity[now(at)] = vec4(u, 0.0f);
        velocity[ago(at)] = vec4(2.0f * velocity[now(at)].xyz - u, 0.0f);
        return;
    }
    // What forces and pressure made of it since is cut too (limit.comp).
    if (is_on(WINDROW_ADVECTS) && is_last()) {
        const float most = windrow_fastest_carried(tick.max_cfl, tick.max_substeps, tick.cell_size, tick.duration),
                    largest = largest_component(u);
        if (largest > windrow_speed_rounding * most) {
            u *= most / largest;
            if (is_on(WINDROW_HAS_SOURCE_FLOW))
                source_flow[at] *= most / largest;
            atomicAdd(control.limited_cells, 1u);
        }
    }
    const float lee = has_lee() && !record_is(record, WINDROW_INSIDE) ? arrived[at].w : 0.0f;
    velocity[ago(at)] = vec4(u, lee); // which the next sub-step begins with
    if (record_is(record, WINDROW_INSIDE) && !is_on(WINDROW_STABLE_FLUIDS))
        velocity[now(at)] = vec4(u, 0.0f);
    if (!is_last())
        return;
    if (broken(vec4(u, lee))) {
        repair(cell, at, elapsed() + WINDROW_OF_PLAN.substep_duration);
        u = velocity[ago(at)].xyz;
    }
    atomicMax(group_largest, floatBitsToUint(largest_component(u)));
    if (k_own_rows)
        atomicMax(group_in_rows, floatBitsToUint(largest_component(in_rows(u, cell.y))));
    if (is_on(WINDROW_MAY_REST) && !record_is(record, WINDROW_INSIDE)) {
        const vec3 around = record_is(record, WINDROW_ROOM)
                                ? vec3(0.0f)
                                : around_at(cell, end_of_substep(), wind_at(cell, end_of_substep(), is_on(WINDROW_GUSTS)));
        atomicMax(group_apart, floatBitsToUint(largest_component(u - around)));
    }
}

void main() {
    const ivec3 cell = ivec3(gl_GlobalInvocationID);
    if (gl_LocalInvocationIndex == 0)
        group_largest = group_in_rows = group_apart = 0;
    barrier();
    if (inside(cell, tick.cells))
        step_cell(cell);
    barrier();
    if (cell == ivec3(0) && is_last()) {
        control.last_duration = WINDROW_OF_PLAN.substep_duration;
        control.next_slot = (WINDROW_OF_PLAN.first_slot + WINDROW_OF_PLAN.substeps) & 1;
        control.last_undiffused = WINDROW_OF_PLAN.undiffused_time;
        control.behind = WINDROW_OF_PLAN.carried_time;
        control.largest_speed = control.farthest_from_ambient = 0u; // show finds them
    }
    if (gl_LocalInvocationIndex == 0 && is_last()) {
        atomicMax(control.left_fastest, group_largest);
        if (k_own_rows)
            atomicMax(control.left_in_rows, group_in_rows);
        atomicMax(control.left_apart, is_on(WINDROW_MAY_REST) ? group_apart : floatBitsToUint(3e38f)); // air that is acted on
    }
}
