// Puts the patches of a body's skin where the frame's pose has them, each into the list of its cell.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "coat.glsl"
#include "coat_patches.glsl"

layout(local_size_x = 64) in;

void main() {
    uint n = gl_GlobalInvocationID.x;
    if (n >= patch_count)
        return;
    CoatPatchRoot root = patch_roots[n];
    uint first = uint(coat.counts.y);
    vec3 a = skins[first + root.corners.x].position.xyz;
    vec3 along = skins[first + root.corners.y].position.xyz - a, aside = skins[first + root.corners.z].position.xyz - a;
    vec3 across = cross(along, aside);
    float area = length(across);
    vec3 place = a + root.weights.x * along + root.weights.y * aside;
    uint next = 0u;
    if (area > 1e-20) // a triangle that its bones have pressed flat has no side
        next = atomicExchange(cells[list_of(cell_at(place))], n + 1u);
    patches[n] = CoatPatch(vec4(place, root.radius * coat.levels.y), vec4(across / max(area, 1e-20), uintBitsToFloat(next)));
}
