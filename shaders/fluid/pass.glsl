// Common head of the passes over cells: the blocks, and the cell of this invocation. Define WINDROW_BETWEEN_TICKS before it for a
// pass outside of sub-steps, and WINDROW_MAY_PLAN for one that may be the first of a sub-step (planning.glsl).
//
// Set 0: binding 0 the step, binding 1 the control; a pass names the rest.
#ifndef WINDROW_PASS_GLSL
#define WINDROW_PASS_GLSL

layout(local_size_x_id = 0, local_size_y_id = 1, local_size_z_id = 2) in;

#ifdef WINDROW_READS_TILE
layout(std430, set = 0, binding = WINDROW_READS_TILE) readonly buffer Tile { vec4 tile_texels[]; };
#define WINDROW_TILE int
vec3 windrow_tile_texel(int tile, ivec3 texel) { return tile_texels[(texel.z * 16 + texel.y) * 128 + texel.x].xyz; }
#else
#define WINDROW_TILE int
vec3 windrow_tile_texel(int tile, ivec3 texel) { return vec3(0.0f); }
#endif

#include "numerics/ambient.glsl"
#include "numerics/history.glsl"
#include "fluid/blocks.glsl"

layout(std430, set = 0, binding = 0) readonly buffer Step {
    WindrowStep tick;
    WindrowRow rows[]; // of a padded field, where the box has rows of its own
};
layout(std430, set = 0, binding = 1) buffer Control { WindrowControl control; };
#ifndef WINDROW_PUSH
#define WINDROW_PUSH WindrowStagePush
#endif
layout(push_constant) uniform Push { WINDROW_PUSH push; };

bool is_on(int bit) { return (tick.flags & bit) != 0; }

#ifdef WINDROW_MAY_PLAN
WindrowPlan own_plan;
#define WINDROW_OF_PLAN own_plan
#else
#define WINDROW_OF_PLAN control.plan
#endif

// Passes are made anew with the first obstacle, so that without one they hold no code for them.
layout(constant_id = 7) const bool k_obstacles = false;
bool has_obstacles() { return k_obstacles && is_on(WINDROW_OBSTACLES); }
bool has_rooms() { return k_obstacles && is_on(WINDROW_ROOMS); }

// Rows of unequal thickness (fluid/rows.h); passes of a box without hold no code for them.
layout(constant_id = 8) const bool k_own_rows = false;
float row_height(int j) { return k_own_rows ? rows[j + WINDROW_HALO_LOW].height : tick.cell_size * (float(j) + 0.5f); }
// Cell size over a row's thickness, and over the distance between the rows beside the face below row `face`.
float row_scale(int j) { return k_own_rows ? rows[j + WINDROW_HALO_LOW].scale : 1.0f; }
float row_link(int face) { return k_own_rows ? rows[face + WINDROW_HALO_LOW].link : 1.0f; }
vec3 in_rows(vec3 u, int j) { return vec3(u.x, row_scale(j) * u.y, u.z); }
// Volume of a cell in cubes of its size.
float row_volume(int j) { return 1.0f / row_scale(j); }
// What L takes from a difference over a face of a cell, at the low (0) or high (1) end of an axis.
float exchange(ivec3 cell, int axis, int end) { return axis == 1 ? row_scale(cell.y) * row_link(cell.y + end) : 1.0f; }
// Plants shorten the mixing length behind them (numerics/lee.glsl): the velocity's fourth component says how much.
bool has_lee() { return is_on(WINDROW_ROUGH) && (is_on(WINDROW_DRAG) || tick.canopy_drag > 0.0f); }
// [m] From the low corner.
vec3 centre_of(ivec3 cell) {
    vec3 centre = tick.cell_size * (vec3(cell) + 0.5f);
    if (k_own_rows)
        centre.y = row_height(cell.y);
    return centre;
}
// [m] Of the middle of a cell's face at the high end of an axis.
vec3 face_middle(ivec3 cell, int axis) {
    vec3 place = vec3(cell) + 0.5f;
    place[axis] += 0.5f;
    vec3 middle = tick.cell_size * place;
    if (k_own_rows)
        middle.y = axis == 1 ? 0.5f * (row_height(cell.y) + row_height(cell.y + 1)) : row_height(cell.y);
    return middle;
}
// [m] Of the box.
vec3 box_size() {
    vec3 size = tick.cell_size * vec3(tick.cells);
    if (k_own_rows)
        size.y = 0.5f * (row_height(tick.cells.y - 1) + row_height(tick.cells.y));
    return size;
}

// Index of a cell in an array of the box's cells in order.
int linear_index(ivec3 cell) { return (cell.z * tick.cells.y + cell.y) * tick.cells.x + cell.x; }

// Index of a cell in a field.
int cell_index(ivec3 cell) {
    const ivec3 place = cell + tick.torus;
    return linear_index(place - tick.cells * ivec3(greaterThanEqual(place, tick.cells)));
}

bool inside(ivec3 cell, ivec3 cells) { return all(lessThan(cell, cells)); }

#ifndef WINDROW_BETWEEN_TICKS
// The first sub-step of a flow is rehearsed: a step without history makes the history of the real one (fluid/cpu/step.cpp).
bool is_fresh() { return push.substep < 0; }
int substep() { return max(push.substep, 0); }

bool has_past() {
    return !is_fresh() &&
           !(push.substep == 0 && is_on(WINDROW_FRESH) && !windrow_rehearses(WINDROW_OF_PLAN.cfl, WINDROW_OF_PLAN.substeps));
}

// What a sub-step takes from the one before it.
WindrowPast past() {
    if (!has_past())
        return windrow_past(0.0f);
    return windrow_past(
        push.substep == 0 && !is_on(WINDROW_FRESH) ? WINDROW_OF_PLAN.substep_duration / WINDROW_OF_PLAN.previous_duration : 1.0f);
}

// [s] From the tick's start to this sub-step's.
float elapsed() { return WINDROW_OF_PLAN.begin + float(substep()) * WINDROW_OF_PLAN.substep_duration; }

int slot_now() { return (WINDROW_OF_PLAN.first_slot + substep()) & 1; }
#else
// [s] From the tick's start to the time of the air.
float elapsed() { return -WINDROW_OF_PLAN.carried_time; }

int slot_now() { return (WINDROW_OF_PLAN.first_slot + WINDROW_OF_PLAN.substeps) & 1; }
#endif

// Index of a cell's velocity, now and a sub-step ago; `at` is its cell_index.
int now(int at) { return at + slot_now() * (tick.cells.x * tick.cells.y * tick.cells.z); }
int ago(int at) { return at + (1 - slot_now()) * (tick.cells.x * tick.cells.y * tick.cells.z); }

// The ambient wind around the box at a cell's centre, `elapsed` [s] after the tick's start: the mean alone, or with its gusts.
vec3 wind_at(ivec3 cell, float elapsed, bool gusts) {
    WindrowAmbient wind = tick.wind;
    if (!gusts)
        wind.gust_strength = 0.0f;
    else
        wind.gust_fraction.xyz -= elapsed * tick.gust_speed;
    if (!is_on(WINDROW_PROFILE) && !gusts)
        return tick.ambient;
    return windrow_ambient(0, wind, centre_of(cell));
}

// What is solved for meets beyond open boundaries: still air while the gusts are prescribed.
vec3 solved_ambient(ivec3 cell) { return is_on(WINDROW_GUSTS) ? vec3(0.0f) : wind_at(cell, 0.0f, false); }

#ifdef WINDROW_READS_TILE
#include "fluid/outer.glsl"
#endif

float largest_component(vec3 u) {
    vec3 a = abs(u);
    return max(max(a.x, a.y), a.z);
}

// A bit a tick, the newest lowest: nothing acted, the air was within the sleep speed of the ambient wind, and is not behind.
uint still_ticks() {
    return control.left_still << 1 | uint(uintBitsToFloat(control.left_apart) < tick.sleep_speed && control.behind == 0.0f);
}

#endif
