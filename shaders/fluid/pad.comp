// Padded fields of an advection, with their halo:
//
//   R = ambient + g (carried - ambient) - s q + change at departure      V = (1 + s) u - s u_old
//
// A halo cell takes the value of a cell inside, mirrored or wrapped by the product of its axes' rules, or the ambient wind. With
// gusts it has A too: the ambient wind, beyond a wall that of the outermost cell, and in w the second difference of its profile.
// Where another wind is around the box, that one is beyond its open boundaries (outer.glsl).
#version 460
#extension GL_GOOGLE_include_directive : require
#define WINDROW_READS_TILE 10
#define WINDROW_MAY_PLAN
#include "fluid/pass.glsl"
#include "fluid/planning.glsl"
#include "numerics/lee.glsl"

layout(std430, set = 0, binding = 2) readonly buffer Velocity { vec4 velocity[]; };
layout(std430, set = 0, binding = 3) readonly buffer History { vec4 history[]; };
layout(std430, set = 0, binding = 4) readonly buffer Force { vec4 force[]; };
layout(std430, set = 0, binding = 5) readonly buffer Drives { vec4 drives[]; };
layout(std430, set = 0, binding = 6) readonly buffer SourceFlow { vec4 source_flow[]; };
layout(std430, set = 0, binding = 7) readonly buffer Diffused { vec4 diffused[]; };
layout(std430, set = 0, binding = 8) readonly buffer Rules { WindrowRule rules[]; };
layout(std430, set = 0, binding = 9) writeonly buffer Padded { vec4 padded[]; }; // R of all cells, then V, then A
layout(std430, set = 0, binding = 12) readonly buffer Drag { float drag[]; };
#define WINDROW_SOLIDS 11
#include "fluid/prescribed.glsl"
#include "fluid/ghosts.glsl"
#include "fluid/hold.glsl"

// The mean wind's factor in a row of the padded field.
float profile_of_row(int row, int first) {
    const WindrowRule rule = rules[first + row];
    const int j = rule.beyond_open_side != 0 ? row - WINDROW_HALO_LOW : rule.source;
    return windrow_profile(tick.wind.anchor_height + row_height(j), tick.wind.roughness_length, tick.wind.reference_height);
}

float bend_of_row(int row, int first, int rows) {
    if (!is_on(WINDROW_PROFILE) || tick.period.y != 0.0f || row == 0 || row + 1 == rows)
        return 0.0f;
    return profile_of_row(row - 1, first) - 2.0f * profile_of_row(row, first) + profile_of_row(row + 1, first);
}

// [m/s] At the step's start.
vec3 wind_of(int at) {
    vec3 u = velocity[now(at)].xyz;
    if (is_on(WINDROW_STABLE_FLUIDS) && is_on(WINDROW_PUSHES))
        u += WINDROW_OF_PLAN.substep_duration * force[at].xyz;
    return u;
}

// The lee after the step: fluid/cpu/cells_mixing.cpp, deepen_lee.
float lee_of(ivec3 cell) {
    const int at = cell_index(cell);
    const float lee = velocity[now(at)].w, along = drag_of(cell, at);
    if (!(lee > 0.0f) && !(along > 0.0f))
        return 0.0f;
    const vec3 u = wind_of(at);
    const ivec3 over = cell + ivec3(0, 1, 0), under = cell - ivec3(0, 1, 0);
    vec2 high = u.xz, low = u.xz;
    float top = row_height(cell.y), bottom = top;
    if (over.y < tick.cells.y && !record_is(record_at(over), WINDROW_INSIDE)) {
        high = wind_of(cell_index(over)).xz;
        top = row_height(over.y);
    }
    if (under.y < 0 && tick.velocity_low.y < 0.0f) { // over a floor the air is at rest
        low = vec2(0.0f);
        bottom = 0.0f;
    } else if (under.y >= 0 && !record_is(record_at(under), WINDROW_INSIDE)) {
        low = wind_of(cell_index(under)).xz;
        bottom = row_height(under.y);
    }
    const float per_height = top > bottom ? WINDROW_OF_PLAN.substep_duration / (top - bottom) : 0.0f;
    return windrow_lee(lee, per_height * length(high - low), along * WINDROW_OF_PLAN.substep_duration * length(u));
}

// What the advection takes of a cell of air: carried, then its history and change at departure together, and V.
struct Departing {
    vec3 carried, held, trace;
};

vec3 relaxed(vec3 carried, ivec3 cell, int record) {
    if (!is_on(WINDROW_RELAXES))
        return carried;
    const vec3 around = record_is(record, WINDROW_ROOM) ? vec3(0.0f) : around_at(cell, elapsed(), solved_ambient(cell));
    return around + (1.0f / (1.0f + WINDROW_OF_PLAN.substep_duration / tick.relaxation_time)) * (carried - around);
}

Departing departing(ivec3 cell, int record) {
    const int source = cell_index(cell);
    Departing air;
    air.carried = is_on(WINDROW_DIFFUSES | WINDROW_ROUGH) ? diffused[source].xyz : solved_part(cell, source);
    air.held = vec3(0.0f);
    vec3 u = velocity[now(source)].xyz;
    if (is_on(WINDROW_STABLE_FLUIDS)) {
        if (is_on(WINDROW_PUSHES))
            u += WINDROW_OF_PLAN.substep_duration * force[source].xyz;
    } else {
        if (!is_fresh()) {
            u += past().scale * (u - velocity[ago(source)].xyz);
            air.held -= past().scale * history[source].xyz;
        }
        if (is_on(WINDROW_PUSHES))
            air.held += (0.5f * WINDROW_OF_PLAN.substep_duration) * force[source].xyz;
        if (anything_holds()) {
            const vec3 whole = relaxed(air.carried, cell, record) + prescribed_part(cell, source, elapsed());
            air.held += windrow_held_departing(whole, hold_of(cell, source)) - whole;
        }
    }
    air.trace = u;
    return air;
}

void main() {
    const ivec3 size = tick.cells + WINDROW_HALO;
    const ivec3 place = ivec3(gl_GlobalInvocationID);
    if (!inside(place, size))
        return;
    find_plan(place == ivec3(0));
    const int at = (place.z * size.y + place.y) * size.x + place.x;
    const int trace_at = at + size.x * size.y * size.z, wind_from = trace_at + size.x * size.y * size.z;
    // Where each axis' rules begin: those of transport stand behind those of viscosity.
    const ivec3 first = ivec3(0, size.x, size.x + size.y) + (size.x + size.y + size.z);
    const ivec3 here = place - WINDROW_HALO_LOW;
    ivec3 cell, slipped = here;
    vec3 scale = vec3(1.0f), offset = vec3(0.0f), history_scale = vec3(1.0f);
    bool ambient = false, identity = true;
    for (int axis = 0; axis < 3; ++axis) {
        const WindrowRule rule = rules[first[axis] + place[axis]];
        cell[axis] = rule.source;
        ambient = ambient || rule.beyond_open_side != 0;
        if (rule.identity != 0)
            continue;
        identity = false;
        slipped[axis] = rule.beyond_open_side != 0 ? here[axis] : rule.source;
        scale = rule.scale.xyz * scale;
        offset = rule.scale.xyz * offset + rule.offset.xyz;
        history_scale = rule.history_scale.xyz * history_scale;
    }
    if (is_on(WINDROW_GUSTS))
        padded[wind_from] = vec4(wind_at(slipped, elapsed(), true), bend_of_row(place.y, first.y, size.y));
    if (ambient) {
        const vec3 mean = solved_ambient(here);
        padded[at] = vec4(k_outer ? outer_carried(here, mean) : mean, 0.0f);
        vec3 wind = around_at(here, end_of_substep(), wind_at(here, elapsed(), is_on(WINDROW_GUSTS)));
        if (k_own_rows)
            wind.y *= row_scale(clamp(here.y, 0, tick.cells.y - 1));
        padded[trace_at] = vec4(wind, 0.0f);
        return;
    }
    const int record = record_at(cell);
    Departing air;
    air.carried = air.held = air.trace = vec3(0.0f);
    float lee = 0.0f;
    for (int n = 0; n < max(term_count(record), 1); ++n) {
        const AirTerm term = term_of(cell, record, n);
        const Departing source = departing(term.cell, record_at(term.cell));
        air.carried += term.weight * windrow_slipped(source.carried, term.normal, wall_of(term, record));
        air.held += term.weight * windrow_slipped(source.held, term.normal, 0.0f);
        air.trace += term.weight * windrow_slipped(source.trace, term.normal, term.wall);
        if (has_lee())
            lee += term.weight * lee_of(term.cell);
    }
    vec3 carried = relaxed(air.carried, cell, record), u = air.trace;
    if (!identity) {
        carried = scale * carried + offset;
        u = scale * u + offset;
    }
    if (!is_on(WINDROW_STABLE_FLUIDS))
        carried += history_scale * air.held;
    if (k_own_rows) // along it a trajectory counts rows
        u.y *= row_scale(cell.y);
    if (is_on(WINDROW_RELAXES))
        lee *= 1.0f / (1.0f + WINDROW_OF_PLAN.substep_duration / tick.relaxation_time);
    padded[at] = vec4(carried, lee);
    padded[trace_at] = vec4(u, 0.0f);
}
