// Lays down the visible blades that someone treads on, or has trodden on: after field_blades.comp. What is trodden on does not
// follow the wind.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shaders/numerics/ground_texels.glsl"
#include "field_lists.glsl"

// The bindings of coupling/windrow_ground.glsl, but for the block: Mesa 22.3's llvmpipe ends with a fault where a pass with this
// push constant reads it as a uniform block.
layout(std430, set = 2, binding = 3) readonly buffer GroundPlaces { WindrowGroundPlace ground_now, ground_before; };
layout(set = 2, binding = 4) uniform sampler3D ground_texels;
layout(set = 2, binding = 5) uniform sampler3D ground_texels_before;

void main() {
    uint list = gl_WorkGroupID.x;
    uvec2 counts = counts_of(list);
    uint base = field_bases[4u * slot_of(list) + 2u * (list % 2u)];
    uint end = room_of(base, counts.x + counts.y);
    for (uint n = gl_WorkGroupID.y * gl_WorkGroupSize.x + gl_LocalInvocationIndex; n < end;
         n += gl_NumWorkGroups.y * gl_WorkGroupSize.x) {
        vec3 root = field_blades[base + n].root.xyz;
        vec4 bend = field_blades[base + n].bend;
        vec4 now = windrow_ground_at(ground_texels, ground_now, root);
        vec4 before = windrow_ground_at(ground_texels_before, ground_before, root);
        field_blades[base + n].bend = vec4(bend.xy * (1.0 - now.z) + now.xy, bend.zw * (1.0 - before.z) + before.xy);
    }
}
