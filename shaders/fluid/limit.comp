// Cuts speeds to what the sub-steps can carry. The sources' flow is cut by the same share as the wind that it is part of.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "fluid/pass.glsl"

layout(std430, set = 0, binding = 2) buffer Velocity { vec4 velocity[]; };
layout(std430, set = 0, binding = 3) buffer SourceFlow { vec4 source_flow[]; };

void main() {
    const ivec3 cell = ivec3(gl_GlobalInvocationID);
    if (!inside(cell, tick.cells.xyz))
        return;
    const int at = cell_index(cell);
    const vec4 u = velocity[at];
    const float largest = largest_component(u.xyz), most = control.substep.z;
    if (largest <= most)
        return;
    velocity[at] = u * (most / largest);
    if (is_on(WINDROW_LETS_AIR_IN))
        source_flow[at] *= most / largest;
    atomicAdd(control.found.w, 1u);
    atomicAdd(control.measured.w, 1u);
}
