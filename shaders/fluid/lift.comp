// A box with rows of its own that has risen: what a field holds now, to `arrived`. Its air keeps its height; cubic in the row, linear
// beside the first and the last, as lift_field of fluid/window.h. Two dispatches a field: into `arrived`, and back.
#version 460
#extension GL_GOOGLE_include_directive : require
#define WINDROW_READS_TILE 7
#define WINDROW_PUSH WindrowLiftPush
#define WINDROW_BETWEEN_TICKS
#include "fluid/pass.glsl"
#include "numerics/transport.glsl"

layout(std430, set = 0, binding = 2) buffer Velocity { vec4 velocity[]; };
layout(std430, set = 0, binding = 3) buffer History { vec4 history[]; };
layout(std430, set = 0, binding = 4) buffer SourceFlow { vec4 source_flow[]; };
layout(std430, set = 0, binding = 5) buffer Before { vec4 before[]; };
layout(std430, set = 0, binding = 6) buffer Arrived { vec4 arrived[]; };

vec4 value_in(ivec3 cell, int row) {
    cell.y = row;
    const int at = cell_index(cell);
    if (push.field == WINDROW_LIFT_NOW)
        return velocity[now(at)];
    if (push.field == WINDROW_LIFT_AGO)
        return velocity[ago(at)];
    if (push.field == WINDROW_LIFT_HISTORY)
        return history[at];
    return push.field == WINDROW_LIFT_SOURCE_FLOW ? source_flow[at] : before[at];
}

void main() {
    const ivec3 cell = ivec3(gl_GlobalInvocationID);
    if (!inside(cell, tick.cells))
        return;
    const int at = cell_index(cell), last = tick.cells.y - 1;
    if (push.back != 0) {
        const vec4 risen = arrived[at];
        if (push.field == WINDROW_LIFT_NOW)
            velocity[now(at)] = risen;
        else if (push.field == WINDROW_LIFT_AGO)
            velocity[ago(at)] = risen;
        else if (push.field == WINDROW_LIFT_HISTORY)
            history[at] = risen;
        else if (push.field == WINDROW_LIFT_SOURCE_FLOW)
            source_flow[at] = risen;
        else
            before[at] = risen;
        return;
    }
    const float height = row_height(cell.y) + push.rise;
    vec4 value = vec4(0.0f);
    if (!(height > 0.0f && height < box_size().y)) {
        if (push.value == WINDROW_PLACE_AMBIENT)
            value.xyz = around_at(cell, 0.0f, wind_at(cell, elapsed(), is_on(WINDROW_GUSTS)));
        else if (push.field != WINDROW_LIFT_HISTORY && push.field != WINDROW_LIFT_SOURCE_FLOW)
            value.xyz = around_at(cell, 0.0f, vec3(0.0f));
        arrived[at] = value;
        return;
    }
    int below = 0, above = last;
    while (above - below > 1) {
        const int middle = (below + above) / 2;
        if (row_height(middle) <= height)
            below = middle;
        else
            above = middle;
    }
    const float t = clamp((height - row_height(below)) / (row_height(above) - row_height(below)), 0.0f, 1.0f);
    const vec4 here = value_in(cell, below), next = value_in(cell, below + 1) - here;
    value = here + t * next;
    if (below >= 1 && below + 2 <= last) {
        const vec4 behind = value_in(cell, below - 1) - here, beyond = value_in(cell, below + 2) - here;
        const vec3 weights = windrow_cubic_weights(t);
        value = here + weights.x * behind + weights.y * next + weights.z * beyond;
    }
    arrived[at] = value;
}
