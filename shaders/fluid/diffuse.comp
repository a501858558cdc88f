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
#include "fluid/given.glsl"
#include "fluid/viscosity.glsl"

vec3 beside(ivec3 cell, int axis, int step) {
    const ivec3 first = ivec3(0, tick.cells.x + WINDROW_HALO, tick.cells.x + tick.cells.y + 2 * WINDROW_HALO);
    const WindrowRule rule = rules[first[axis] + cell[axis] + step + WINDROW_HALO_LOW];
    if (rule.beyond_open_side != 0)
        return still_wind();
    ivec3 from = cell;
    from[axis] = rule.source;
    return rule.scale.xyz * solved_part(from, cell_index(from)) + rule.offset.xyz;
}

void main() {
    const ivec3 cell = ivec3(gl_GlobalInvocationID);
    if (!inside(cell, tick.cells))
        return;
    const int at = cell_index(cell);
    const float ratio = diffusion_ratio();
    vec3 v = solved_part(cell, at);
    if (ratio > 0.0f && !is_implicit()) {
        const vec3 sum = ((beside(cell, 0, -1) + beside(cell, 0, 1)) + (beside(cell, 1, -1) + beside(cell, 1, 1))) +
                         (beside(cell, 2, -1) + beside(cell, 2, 1));
        precise const vec3 rest = sum - 6.0f * v;
        v += ratio * rest; // 0 to the bit where v is uniform, since it is not contracted
    }
    diffused[at] = vec4(v, 0.0f);
}
