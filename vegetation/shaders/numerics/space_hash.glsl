// Chance that belongs to a cell of a lattice in space: its layers are planes of windrow_plant_hash, far apart.
//
//   key      (x + l A, y + l B), l = z + seed C, in 32 bits      A the golden ratio's multiple, B and C odd and without short
//                                                                multiples
//
// Two cells share a key only where they lie more than 4e4 cells apart.
#ifndef WINDROW_SPACE_HASH_GLSL
#define WINDROW_SPACE_HASH_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

#include "../../../shaders/numerics/plant_hash.glsl"

WINDROW_FN uvec2 windrow_space_hash(uint seed, ivec3 cell) {
    uint layer = uint(cell.z) + seed * 0x632be5abu;
    return windrow_plant_hash(uvec2(uint(cell.x) + layer * 0x9e3779b9u, uint(cell.y) + layer * 0x85ebca6bu));
}

#endif
