// Explicit diffusion of the perturbation velocity, one pass: v + r L v, r = viscosity dt / h^2; nothing below r = 1e-4, nor where
// it must be implicit (fluid/cpu/diffusion.cpp).
#version 460
#extension GL_GOOGLE_include_directive : require
#define WINDROW_READS_TILE 7
#include "fluid/pass.glsl"

layout(std430, set = 0, binding = 2) readonly buffer Velocity { vec4 velocity[]; };
layout(std430, set = 0, binding = 3) readonly buffer Force { vec4 force[]; };
layout(std430, set = 0, binding = 4) readonly buffer SourceFlow { vec4 source_flow[]; };
layout(std430, set = 0, binding = 5) readonly buffer Rules { WindrowRule rules[]; };
layout(std430, set = 0, binding = 6) writeonly buffer Diffused { vec4 diffused[]; };
#define WINDROW_SOLIDS 8
#include "fluid/prescribed.glsl"
#include "fluid/ghosts.glsl"
#include "fluid/viscosity.glsl"

vec3 beside(ivec3 cell, int axis, int step) {
    const ivec3 first = ivec3(0, tick.cells.x + WINDROW_HALO, tick.cells.x + tick.cells.y + 2 * WINDROW_HALO);
    const WindrowRule rule = rules[first[axis] + cell[axis] + step + WINDROW_HALO_LOW];
    if (rule.beyond_open_side != 0)
        return still_wind();
    ivec3 from = cell;
    from[axis] = rule.source;
    return rule.scale.xyz * solved_cell(from, record_at(from)) + rule.offset.xyz;
}

// What closed faces change: they have no flux, or that of a wall to which the air sticks.
vec3 closed_flux(ivec3 cell, int record, vec3 here) {
    vec3 sum = vec3(0.0f);
    const vec3 wind = is_on(WINDROW_GUSTS) && !record_is(record, WINDROW_SHELTERED) ? wind_at(cell, elapsed(), true) : vec3(0.0f);
    for (int axis = 0; axis < 3; ++axis)
        for (int end = 0; end < 2; ++end) {
            const int n = record_face(record, axis, end);
            if (n < 0)
                continue;
            const SolidFace face = solid_face(n);
            const ivec3 other = solid_cell(face.cell[end]);
            const vec3 place = face_middle(solid_cell(face.cell[0]), axis);
            const vec3 next = solved_cell(other, solid_record(other));
            sum += exchange(cell, axis, end) * windrow_wall_flux(face.facing[1 - end], face.closed, face_is_no_slip(face), axis,
                                                                 here, next, body_velocity(face.body, place) - wind);
        }
    return sum;
}

// v of a cell of air with the drag of the walls beside it, before an implicit pass, which is that of the empty box.
vec3 dragged_air(ivec3 cell, int record, float ratio) {
    vec3 v = solved_part(cell, cell_index(cell));
    if (record < 0)
        return v;
    const vec3 wind = is_on(WINDROW_GUSTS) && !record_is(record, WINDROW_SHELTERED) ? wind_at(cell, elapsed(), true) : vec3(0.0f);
    for (int n = 0; n < 6; ++n) { // in the order of the faces
        const int axis = n < 3 ? 2 - n : n - 3, number = record_face(record, axis, n / 3);
        if (number < 0)
            continue;
        const SolidFace face = solid_face(number);
        const vec3 place = face_middle(solid_cell(face.cell[0]), axis);
        const float way = 2.0f * ratio * exchange(cell, axis, n / 3) * face.facing[1 - n / 3];
        v = windrow_wall_dragged(way, face_is_no_slip(face), axis, v, body_velocity(face.body, place) - wind);
    }
    return v;
}

// Cells inside take the air's values, so that they exchange nothing with it.
vec3 dragged_cell(ivec3 cell, int record, float ratio) {
    vec3 sum = vec3(0.0f);
    for (int n = 0; n < max(term_count(record), 1); ++n) {
        const AirTerm term = term_of(cell, record, n);
        sum += term.weight * dragged_air(term.cell, record_at(term.cell), ratio);
    }
    return sum;
}

void main() {
    const ivec3 cell = ivec3(gl_GlobalInvocationID);
    if (!inside(cell, tick.cells))
        return;
    const int at = cell_index(cell);
    const float ratio = diffusion_ratio();
    const int record = record_at(cell);
    vec3 v = is_implicit() ? dragged_cell(cell, record, ratio) : solved_cell(cell, record);
    if (ratio > 0.0f && !is_implicit()) {
        vec3 around[6];
        for (int n = 0; n < 6; ++n)
            around[n] = beside(cell, n / 2, 2 * (n % 2) - 1);
        const vec3 sum = ((around[0] + around[1]) + (around[2] + around[3])) + (around[4] + around[5]);
        precise vec3 rest = sum - 6.0f * v;
        if (k_own_rows) {
            const vec3 level = ((around[0] + around[1]) + (around[4] + around[5])) - 4.0f * v;
            rest = level + (exchange(cell, 1, 0) * (around[2] - v) + exchange(cell, 1, 1) * (around[3] - v));
        }
        const vec3 walls = record < 0 ? vec3(0.0f) : closed_flux(cell, record, v);
        v += ratio * rest; // 0 to the bit where v is uniform, since it is not contracted
        v += ratio * walls;
    }
    diffused[at] = vec4(v, 0.0f);
}
