// Before obstacles are placed again: cells inside them take the air that a read from outside finds there, now and a sub-step ago, and
// its history, as Cells::uncover of the CPU. The tables are those of the last placement, since which the box has moved by `shift`:
// where that has left some of that air behind, the cell stays as it is.
#version 460
#extension GL_GOOGLE_include_directive : require
#define WINDROW_PUSH WindrowUncoverPush
#define WINDROW_BETWEEN_TICKS
#include "fluid/pass.glsl"
#include "numerics/slip.glsl"
#define WINDROW_SOLIDS 2
#include "fluid/solids.glsl"

layout(std430, set = 0, binding = 3) buffer Velocity { vec4 velocity[]; };
layout(std430, set = 0, binding = 4) buffer History { vec4 history[]; };

bool is_in_box(ivec3 cell) { return all(greaterThanEqual(cell, ivec3(0))) && inside(cell, tick.cells); }

void main() {
    const ivec3 then = ivec3(gl_GlobalInvocationID), cell = then - push.shift;
    if (!inside(then, tick.cells) || !is_in_box(cell))
        return;
    const int record = solid_record(then);
    const int slot = (WINDROW_OF_PLAN.first_slot + (push.substep < 0 ? WINDROW_OF_PLAN.substeps : push.substep)) & 1;
    const int field = tick.cells.x * tick.cells.y * tick.cells.z;
    vec3 now_there = vec3(0.0f), ago_there = vec3(0.0f), held = vec3(0.0f);
    float lee = 0.0f;
    if (term_count(record) == 0)
        return;
    for (int n = 0; n < term_count(record); ++n) {
        const AirTerm term = air_term(solid_words[record + 7] + n);
        if (!is_in_box(term.cell - push.shift))
            return;
        const int from = cell_index(term.cell - push.shift);
        now_there += term.weight * windrow_slipped(velocity[from + slot * field].xyz, term.normal, term.wall);
        lee += term.weight * velocity[from + slot * field].w;
        ago_there += term.weight * windrow_slipped(velocity[from + (1 - slot) * field].xyz, term.normal, term.wall);
        held += term.weight * windrow_slipped(history[from].xyz, term.normal, 0.0f);
    }
    const int at = cell_index(cell);
    velocity[at + slot * field] = vec4(now_there, lee);
    if (push.past == 0)
        return;
    velocity[at + (1 - slot) * field] = vec4(ago_there, 0.0f);
    history[at] = vec4(held, 0.0f);
}
