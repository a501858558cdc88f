// Addition of a wind to the air and its history: the current ambient wind, or a change of the mean wind.
#version 460
#extension GL_GOOGLE_include_directive : require
#define WINDROW_READS_TILE 4
#define WINDROW_PUSH WindrowAdjustPush
#define WINDROW_BETWEEN_TICKS
#include "fluid/pass.glsl"

layout(std430, set = 0, binding = 2) buffer Velocity { vec4 velocity[]; };
layout(std430, set = 0, binding = 3) buffer Before { vec4 before[]; };
#define WINDROW_SOLIDS 5
#include "fluid/solids.glsl"

void main() {
    const ivec3 cell = ivec3(gl_GlobalInvocationID);
    if (!inside(cell, tick.cells))
        return;
    const ivec3 placed = cell + tick.shift; // where it was as the obstacles were placed
    if (has_rooms() && all(greaterThanEqual(placed, ivec3(0))) && inside(placed, tick.cells) &&
        record_is(solid_record(placed), WINDROW_ROOM)) // no wind blows there
        return;
    const int at = cell_index(cell);
    vec3 wind;
    if (push.of_mean != 0) {
        wind = push.change;
        if (is_on(WINDROW_PROFILE))
            wind *= windrow_profile(tick.wind.anchor_height + row_height(cell.y), tick.wind.roughness_length,
                                    tick.wind.reference_height);
    } else {
        wind = wind_at(cell, elapsed(), is_on(WINDROW_GUSTS));
    }
    const vec4 change = vec4(push.factor * wind, 0.0f);
    if (push.to_air != 0) {
        velocity[now(at)] += change;
        if (!is_on(WINDROW_FRESH))
            velocity[ago(at)] += change;
    }
    if (push.to_before != 0)
        before[at] += change;
}
