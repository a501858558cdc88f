// Patches of a body's posed skin in cells of space, for strands that stay outside of it: set 3. After coat.glsl.
//
// A patch is a place on a triangle, with the triangle's own normal. Patches of a cell form a list; cells share lists by a hash, and
// whoever walks a list looks at distances anyway. The order of a list depends on the device's threads, nothing that is read from
// it does.
#ifndef WINDROW_SHELLS_COAT_PATCHES_GLSL
#define WINDROW_SHELLS_COAT_PATCHES_GLSL

#include "../numerics/coat_room.glsl"
#include "../numerics/space_hash.glsl"

// Where a patch is on the skin: vegetation/fur/coat_room.h has the same.
struct CoatPatchRoot {
    uvec3 corners; // vertices of the triangle
    float radius;  // [m] in the mesh's space
    vec2 weights;  // of the second and the third corner
    vec2 unused;
};
struct CoatPatch {
    vec4 place;  // xyz [m] from the anchor; w [m] radius
    vec4 normal; // xyz; w bits of the number of the next patch of the list, 1 more than its own; 0: none
};

layout(std430, set = 3, binding = 0) readonly buffer CoatPatchRoots { CoatPatchRoot patch_roots[]; };
layout(std430, set = 3, binding = 1) buffer CoatPatches { CoatPatch patches[]; };
layout(std430, set = 3, binding = 2) buffer CoatCells { uint cells[]; };
layout(std430, set = 3, binding = 3) readonly buffer CoatNarrow {
    uint narrow[];
}; // vertices whose strands have skin before them

layout(push_constant) uniform Room {
    int is_first;     // 1: nothing was before
    uint patch_count; // of the whole body
    uint last_cell;   // lists, less 1: a power of two
    uint narrow_count;
    // Fractions of the way from the last frame's lean and length to what the pose leaves: down to less, and back up; 1: no frame before.
    float takes;
    float gives;
};

// [m] No strand reaches farther than the cells around its own, with the patch that it may meet.
float cell_size() { return 1.4 * coat.shells.form.x; }
ivec3 cell_at(vec3 place) { return ivec3(floor(place / cell_size())); }
uint list_of(ivec3 cell) { return windrow_space_hash(0u, cell).x & last_cell; }

#endif
