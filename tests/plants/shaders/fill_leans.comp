// A host's own pass: gives each slot of the ground the lean of a wind that depends on its place.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "numerics/ground_texels.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, set = 0, binding = 0) writeonly buffer Leans { vec2 leans[]; };
layout(push_constant) uniform Push { WindrowGroundPlace next; };

void main() {
    ivec2 slot = ivec2(gl_GlobalInvocationID.xy);
    int n = int(next.corner.w);
    if (slot.x >= n || slot.y >= n)
        return;
    ivec2 texel = windrow_ground_in_slot(slot, ivec2(next.slot.xy), n);
    leans[slot.y * n + slot.x] = 0.02 * (next.corner.xy + next.corner.z * (vec2(texel) + 0.5)); // [m] from the anchor
}
