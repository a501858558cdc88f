// Limit of speeds, and of the target speeds of drives, to the Courant limit of the sub-steps. The flow of the volume sources is
// scaled by the same factor as the wind that contains it.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "fluid/pass.glsl"

layout(std430, set = 0, binding = 2) buffer Velocity { vec4 velocity[]; };
layout(std430, set = 0, binding = 3) buffer SourceFlow { vec4 source_flow[]; };
layout(std430, set = 0, binding = 4) buffer Drives { vec4 drives[]; };

void main() {
    const ivec3 cell = ivec3(gl_GlobalInvocationID);
    if (!inside(cell, tick.cells))
        return;
    const int at = cell_index(cell);
    const float most = WINDROW_OF_PLAN.max_speed;
    if (is_on(WINDROW_DRIVES)) {
        const vec4 drive = drives[at];
        const float wanted = largest_component(drive.xyz);
        if (wanted > most * drive.w)
            drives[at] = vec4((most * drive.w / wanted) * drive.xyz, drive.w);
    }
    const vec4 u = velocity[now(at)];
    const float largest = largest_component(u.xyz);
    if (largest <= most)
        return;
    velocity[now(at)] = u * (most / largest);
    if (is_on(WINDROW_HAS_SOURCE_FLOW))
        source_flow[at] *= most / largest;
    atomicAdd(control.limited_cells, 1u);
}
