// Closed rooms, one after another. One work group.
//
//   new rooms          that hold the wind although it never blew there become still
//   volume sources     what they blow in a room is taken up evenly by its air
//   energy             of a room does not grow in a sub-step, unless a motor or a moving wall can work in it
//
// As fluid/cpu/cells_obstacles.cpp.
#version 460
#extension GL_GOOGLE_include_directive : require
#define WINDROW_READS_TILE 2
#define WINDROW_PUSH WindrowRoomsPush
#include "fluid/pass.glsl"
#define WINDROW_SOLIDS 3
#include "fluid/solids.glsl"

layout(std430, set = 0, binding = 4) buffer Velocity { vec4 velocity[]; };
layout(std430, set = 0, binding = 5) writeonly buffer History { vec4 history[]; };
layout(std430, set = 0, binding = 6) readonly buffer Force { vec4 force[]; };
layout(std430, set = 0, binding = 7) readonly buffer Drives { vec4 drives[]; };
layout(std430, set = 0, binding = 8) buffer Expansion { float expansion[]; };

#include "fluid/total.glsl"

ivec3 room_cell(int n) { return solid_cell(solid_words[solids.room_cells + n]); }

// Slot of the air before the tick's plan is made.
int slot_before() { return (control.plan.first_slot + control.plan.substeps) & 1; }
int in_slot(int at, int slot) { return at + slot * tick.cells.x * tick.cells.y * tick.cells.z; }

void still(int first, int end, bool came_in) {
    const int local = int(gl_LocalInvocationIndex), slot = slot_before();
    vec2 apart = vec2(0.0f);
    if (!came_in && is_on(WINDROW_FRESH))
        for (int n = first + local; n < end; n += k_group) {
            const ivec3 cell = room_cell(n);
            const vec3 wind = wind_at(cell, -control.plan.carried_time, is_on(WINDROW_GUSTS));
            apart.x += length(velocity[in_slot(cell_index(cell), slot)].xyz - wind) > 1e-5f * length(wind) ? 1.0f : 0.0f;
        }
    if (!came_in && (!is_on(WINDROW_FRESH) || total(apart).x > 0.0f))
        return;
    for (int n = first + local; n < end; n += k_group) {
        const int at = cell_index(room_cell(n));
        velocity[in_slot(at, 0)] = velocity[in_slot(at, 1)] = history[at] = vec4(0.0f);
    }
}

void seal(int first, int end) {
    const int local = int(gl_LocalInvocationIndex);
    vec2 sum = vec2(0.0f);
    for (int n = first + local; n < end; n += k_group)
        sum += row_volume(room_cell(n).y) * vec2(expansion[cell_index(room_cell(n))], 1.0f);
    sum = total(sum);
    const float mean = sum.x / sum.y;
    for (int n = first + local; n < end; n += k_group)
        expansion[cell_index(room_cell(n))] -= mean;
}

bool is_worked_on(int at) {
    if (is_on(WINDROW_DRIVES) && drives[at].w > 0.0f)
        return true;
    if (is_on(WINDROW_PUSHES) && force[at].xyz != vec3(0.0f))
        return true;
    if (is_on(WINDROW_EXPANDS) && expansion[at] != 0.0f)
        return true;
    return false;
}

// The new velocity of a cell. A rehearsal has left u_old = 2 u - u' in its place, as gradient.comp says.
vec3 stepped(int at) {
    const vec3 kept = velocity[ago(at)].xyz;
    return is_fresh() ? 2.0f * velocity[now(at)].xyz - kept : kept;
}

void bound(int first, int end) {
    const int local = int(gl_LocalInvocationIndex);
    vec2 energy = vec2(0.0f), work = vec2(0.0f);
    for (int n = first + local; n < end; n += k_group) {
        const ivec3 cell = room_cell(n);
        const int at = cell_index(cell);
        const vec3 had = velocity[now(at)].xyz, has = stepped(at);
        energy += row_volume(cell.y) * vec2(dot(had, had), dot(has, has));
        work.x += is_worked_on(at) ? 1.0f : 0.0f;
    }
    work = total(work);
    energy = total(energy);
    if (work.x > 0.0f || !(energy.y > energy.x))
        return;
    const float part = sqrt(energy.x / energy.y);
    for (int n = first + local; n < end; n += k_group) {
        const int at = cell_index(room_cell(n));
        const vec3 u = part * stepped(at);
        velocity[ago(at)] = vec4(is_fresh() ? 2.0f * velocity[now(at)].xyz - u : u, 0.0f);
    }
}

void main() {
    int first = 0;
    for (int room = 0; room < solids.room_count; ++room) {
        const int end = solid_words[solids.rooms + 2 * room];
        const int bits = solid_words[solids.rooms + 2 * room + 1];
        if (push.work == WINDROW_STILL_NEW_ROOMS)
            still(first, end, (bits & WINDROW_ROOM_CAME_IN) != 0);
        else if (push.work == WINDROW_SEAL_SOURCES)
            seal(first, end);
        else if ((bits & WINDROW_ROOM_WALLS_MOVE) == 0)
            bound(first, end);
        first = end;
    }
}
