// Implicit diffusion of one component (push.part), (L - 1/r) v' = -v/r - what no-slip walls add, with v taken about the ambient
// wind: first stage, right-hand side to modes. Method and order: fluid/cpu/diffusion.cpp.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "fluid/pass.glsl"
#include "fluid/hat.glsl"
#include "fluid/viscosity.glsl"

layout(std430, set = 0, binding = 2) readonly buffer Tables { float tables[]; };
layout(std430, set = 0, binding = 3) readonly buffer Diffused { vec4 diffused[]; };
layout(std430, set = 0, binding = 4) readonly buffer Rules { WindrowRule rules[]; };
layout(std430, set = 0, binding = 5) writeonly buffer Hat { float hat[]; };

// What the ghost beyond a side adds at an outermost cell: the part that does not depend on v.
float wall_fraction(int axis, int place) {
    const ivec3 first = ivec3(0, tick.cells.x + WINDROW_HALO, tick.cells.x + tick.cells.y + 2 * WINDROW_HALO);
    const WindrowRule rule = rules[first[axis] + place + WINDROW_HALO_LOW];
    const bool carries = axis != push.part && rule.beyond_open_side == 0 && rule.scale[push.part] < 0.0f;
    return carries ? rule.offset[push.part] - 2.0f * still_wind()[push.part] : 0.0f;
}

float load(ivec3 cell) {
    float rhs = -(diffused[cell_index(cell)][push.part] - still_wind()[push.part]) / diffusion_ratio();
    for (int axis = 0; axis < 3; ++axis) {
        if (cell[axis] == 0)
            rhs -= exchange(cell, axis, 0) * wall_fraction(axis, -1);
        if (cell[axis] == tick.cells[axis] - 1)
            rhs -= exchange(cell, axis, 1) * wall_fraction(axis, tick.cells[axis]);
    }
    return rhs;
}

void store(ivec3 mode, float value) { hat[hat_index(mode)] = value; }

#include "fluid/modes.glsl"
