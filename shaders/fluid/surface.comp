// After each direct solve around obstacles, on their surface cells. Behind the first one several work groups, of which the last
// adds up what all have found; behind the others one, which meets itself several times.
//
// With L the Laplacian of the empty box and B the part of it that passes through closed faces, (L - B) phi = div w. The first solve
// is L phi = div w + B phi_guess, whose residual B (phi - phi_guess) is 0 away from the surface. Then conjugate gradients with L as
// the preconditioner: z = L^-1 r, d = z + beta d, phi += alpha d. A d = L d - B d is found on the surface, since L z = r.
// As fluid/cpu/pressure.cpp, solve_around, and based on the same.
#version 460
#extension GL_GOOGLE_include_directive : require
#define WINDROW_READS_TILE 10
#define WINDROW_PUSH WindrowSurfacePush
#include "fluid/pass.glsl"
#define WINDROW_SOLIDS 2
#include "fluid/solids.glsl"

layout(std430, set = 0, binding = 3) readonly buffer Arrived { vec4 arrived[]; };
layout(std430, set = 0, binding = 4) readonly buffer Expansion { float expansion[]; };
layout(std430, set = 0, binding = 5) readonly buffer Potential { float potential[]; };
layout(std430, set = 0, binding = 6) readonly buffer Correction { float correction[]; };
layout(std430, set = 0, binding = 7) readonly buffer Direction { float direction[]; };
#define WINDROW_AROUND 8
#define WINDROW_AROUND_ACCESS coherent
#include "fluid/around.glsl"
#include "fluid/closed_divergence.glsl"
#define WINDROW_MOTORS 9
#include "fluid/free_air.glsl"
#define WINDROW_FIELD(at) arrived[at]
#include "fluid/divergence.glsl"

#include "fluid/total.glsl"

const int k_residual = 0, k_applied = 1, k_along = 2;
int word(int surface, int which) { return WINDROW_SURFACE_WORDS * surface + which; }

ivec3 surface_cell(int s) { return solid_cell(solid_words[solids.surface + 2 * s + 1]); }

float right_hand_side(int record, ivec3 cell) {
    if (push.part == 0)
        return closed_divergence(record, cell, 0.5f * differences(cell) + (k_outer ? outer_right_side(cell) : 0.0f));
    float rhs = is_on(WINDROW_EXPANDS) && !record_is(record, WINDROW_SHUT) ? -tick.cell_size * expansion[cell_index(cell)] : 0.0f;
    if (k_own_rows && is_on(WINDROW_EXPANDS) && !record_is(record, WINDROW_SHUT))
        return rhs - all_beyond(cell);
    for (int axis = 0; axis < 3 && is_on(WINDROW_EXPANDS) && !record_is(record, WINDROW_SHUT); ++axis)
        rhs -= beyond(cell, axis, -1) + beyond(cell, axis, 1);
    return rhs;
}

float guess() { return push.part == 0 ? guess_scale() : 0.0f; }

// Takes from the residual what no potential can take: the constant in each sealed part, which is rounding. Returns its square.
float balance(int local) {
    float taken = 0.0f;
    int first = 0;
    for (int part = 0; part < solids.part_count; ++part) {
        const int end = solid_words[solids.parts + 2 * part + 1];
        vec2 sum = vec2(0.0f);
        for (int n = first + local; n < end; n += k_group) {
            const int s = solid_words[solids.part_surface + n];
            sum += row_volume(surface_cell(s).y) * vec2(around_words[word(s, k_residual)], 1.0f);
        }
        sum = total(sum);
        const float mean = sum.x / sum.y;
        for (int n = first + local; n < end; n += k_group)
            around_words[word(solid_words[solids.part_surface + n], k_residual)] -= mean;
        taken += mean * sum.x;
        first = end;
    }
    memoryBarrierBuffer();
    barrier();
    return taken;
}

shared bool is_last;

// Over the first solve: r = B (phi - phi_guess), and what it is relative to. phi is the potential alone.
void begin(int local) {
    const int group = int(gl_WorkGroupID.x),
              groups = clamp((solids.surface_count + k_group - 1) / k_group, 1, int(gl_NumWorkGroups.x));
    if (group >= groups)
        return;
    const float scale = guess();
    vec2 squares = vec2(0.0f);
    for (int s = group * k_group + local; s < solids.surface_count; s += groups * k_group) {
        const int record = solid_words[solids.surface + 2 * s];
        const ivec3 cell = surface_cell(s);
        float residual = 0.0f;
        for (int face = 0; face < 6; ++face) {
            const int n = solid_words[record + 1 + face];
            if (n < 0)
                continue;
            const SolidFace between = solid_face(n);
            float slope = windrow_closed_slope(between.closed, potential[cell_index(solid_cell(between.cell[0]))],
                                               potential[cell_index(solid_cell(between.cell[1]))]);
            if (scale > 0.0f)
                slope -= scale * around_words[solids.history + n];
            slope *= exchange(cell, face / 2, face % 2);
            residual += face % 2 == 1 ? slope : -slope;
        }
        // In shut cells no value matters, and none is solved for: their part of A is that of a box without an opening, in whose
        // constants the search would get lost.
        const bool shut = record_is(record, WINDROW_SHUT);
        around_words[word(s, k_residual)] = shut ? 0.0f : residual;
        if (!shut) {
            const float wanted = right_hand_side(record, cell);
            squares += row_volume(cell.y) * vec2(wanted * wanted, residual * residual);
        }
    }
    memoryBarrierBuffer(); // the last group reads the residual of all
    squares = total(squares);
    if (local == 0) {
        around.wanted_parts[group] = squares.x;
        around.left_parts[group] = squares.y;
        memoryBarrierBuffer();
        is_last = atomicAdd(around.groups_done, 1u) == uint(groups) - 1u;
        memoryBarrierBuffer();
    }
    barrier();
    if (!is_last)
        return;
    memoryBarrierBuffer();
    squares = total(local < groups ? vec2(around.wanted_parts[local], around.left_parts[local]) : vec2(0.0f));
    const float taken = solids.part_count > 0 ? balance(local) : 0.0f;
    if (local == 0) {
        around.wanted = sqrt(squares.x);
        around.left = sqrt(max(squares.y - taken, 0.0f));
        around.solved = 1;
        around.stopped = 0;
        around.corrections = 0;
        around.groups_done = 0;
    }
}

// One step along the correction that the solve gave.
void improve(int local) {
    const bool first = push.solve == 1;
    float part = 0.0f;
    for (int s = local; s < solids.surface_count; s += k_group) {
        const ivec3 cell = surface_cell(s);
        part += row_volume(cell.y) * around_words[word(s, k_residual)] * correction[cell_index(cell)];
    }
    const float squares = total(vec2(part, 0.0f)).x;
    const bool goes_on = around.stopped == 0 && around.left > 1e-6f * around.wanted;
    const float beta = first || !goes_on ? 0.0f : squares / around.squares;
    for (int s = local; s < solids.surface_count; s += k_group) {
        const float along = correction[cell_index(surface_cell(s))], residual = around_words[word(s, k_residual)];
        around_words[word(s, k_along)] = beta == 0.0f ? along : along + beta * around_words[word(s, k_along)];
        around_words[word(s, k_applied)] = beta == 0.0f ? residual : residual + beta * around_words[word(s, k_applied)];
    }
    memoryBarrierBuffer();
    barrier();
    part = 0.0f;
    for (int s = local; s < solids.surface_count; s += k_group) {
        const int record = solid_words[solids.surface + 2 * s];
        const ivec3 cell = surface_cell(s);
        float applied = around_words[word(s, k_applied)];
        for (int face = 0; face < 6; ++face) {
            const int n = solid_words[record + 1 + face];
            if (n < 0)
                continue;
            const SolidFace between = solid_face(n);
            const float slope = exchange(cell, face / 2, face % 2) *
                                windrow_closed_slope(between.closed, around_words[word(between.surface[0], k_along)],
                                                     around_words[word(between.surface[1], k_along)]);
            applied += face % 2 == 1 ? -slope : slope;
        }
        if (record_is(record, WINDROW_SHUT))
            applied = 0.0f;
        around_words[word(s, 3)] = applied;
        part += row_volume(cell.y) * around_words[word(s, k_along)] * applied;
    }
    const float bent = total(vec2(part, 0.0f)).x;
    const bool steps = goes_on && bent < 0.0f;
    const float alpha = steps ? squares / bent : 0.0f;
    vec2 left = vec2(0.0f);
    for (int s = local; s < solids.surface_count; s += k_group) {
        const float residual = around_words[word(s, k_residual)] - alpha * around_words[word(s, 3)];
        around_words[word(s, k_residual)] = residual;
        left.x += row_volume(surface_cell(s).y) * residual * residual;
    }
    left = total(left);
    if (solids.part_count > 0) {
        memoryBarrierBuffer();
        barrier();
        left.x = max(left.x - balance(local), 0.0f);
    }
    if (local == 0) { // all have read them, since total() ends with a barrier
        around.corrections = push.solve;
        around.beta = beta;
        around.alpha = alpha;
        around.squares = squares;
        around.left = sqrt(left.x);
        around.solved += steps ? 1 : 0;
        around.stopped = steps ? 0 : 1;
    }
}

void main() {
    const int local = int(gl_LocalInvocationIndex);
    if (push.solve == 0)
        begin(local);
    else
        improve(local);
}
