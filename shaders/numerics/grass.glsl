// Where blades of a field stand, which of them a view needs, and with how many vertices: one text for the passes that make and cull
// them, the vertex stage that draws them, and C++.
//
//   place      p = (c + 1/2 + j (r - 1/2)) / density            c the cell (a blade place each), r two chances, j the jitter 0 to 1
//   chances    windrow_plant_hash of the cell and a stream: a function of the cell's number alone, so that order and threads
//              do not matter. Stream 0 is the blade's own key (yaw, stiffness, length, own bend), 1 its place, 2 its looks.
//   kept       a ball around the root, of the longest blade's length and half its width times this one's size, reaches into the frustum:
//              no bend leaves it
//   level      by the distance d of the eye from the root: near (15 vertices) for d < split, far (7) for d < cut, none beyond
//   row        near rows slide along the blade toward the far rows while d goes from morph to split: h = h_near + m (h_far - h_near),
//              so that both strips are one at d = split, vertex by vertex
//   fade       length and width shrink to 0 while d goes from fade to cut: nothing pops there either
//
// Distances and places are [m]; places from the field's corner.
// Based on: sizes of tiles and vertex counts as in Wohllaib 2021, Procedural grass in Ghost of Tsushima (GDC); Hoppe 1996,
// Progressive meshes (geomorphs: vertices that slide to where their coarser mesh has them).
#ifndef WINDROW_GRASS_GLSL
#define WINDROW_GRASS_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

#include "blade.glsl"
#include "plant_hash.glsl"

#define WINDROW_GRASS_NEAR 0
#define WINDROW_GRASS_FAR 1
#define WINDROW_GRASS_NONE 2
#define WINDROW_GRASS_NEAR_ROWS 7
#define WINDROW_GRASS_FAR_ROWS 3

// The same layout as grass::Block (examples/grass/grass_block.h), which fills it. Usable in a std140 block.
struct WindrowGrass {
    vec4 corner;   // xyz [m] the field's corner from the frame's anchor; w [m] longest blade and half the widest: radius of the ball
    vec4 eye;      // xyz [m] from the field's corner; w [rad] least width of a drawn blade
    vec4 eye_before; // xyz a frame ago, w 0
    vec4 reach;    // [m] x morph, y split, z fade, w cut
    vec4 ground;   // x [1/m] blade places a metre, y jitter; z [m] cut of the shadow's view, w 0
    ivec4 cells;   // xy cells of the field along x and z, z cells along a chunk's side, w seed
    ivec4 corners; // xy of the heights along x and z, zw of the mask
    vec4 spacing;  // [m] xy of the heights, zw of the mask
    vec4 planes[12]; // of the colour's view and of the shadow's: dot(xyz, p) + w >= 0 inside, p from the field's corner; xyz unit vectors
    WindrowBlade blade;
};

// The key of a cell's blade: distinct cells, distinct keys. The stream takes bits that no cell's number has.
WINDROW_FN uvec2 windrow_grass_key(ivec2 cell, uint seed, uint stream) {
    uvec2 key = uvec2(cell) ^ (uvec2(seed * 0x9e3779b9u, seed * 0x85ebca6bu) & 0x0fffffffu);
    key.y ^= stream << 28u;
    return key;
}

// [m] Where a cell's blade stands.
WINDROW_FN vec2 windrow_grass_place(ivec2 cell, float density, float jitter, uint seed) {
    uvec2 hash = windrow_plant_hash(windrow_grass_key(cell, seed, 1u));
    vec2 chance = vec2(windrow_share(hash.x), windrow_share(hash.y)) - 0.5f;
    return (vec2(cell) + 0.5f + jitter * chance) / density;
}

// Size of a blade over its class by the mask's alpha: none at 0 and below, linear up to 1.
WINDROW_FN float windrow_grass_size(float alpha) {
    return clamp(alpha, 0.0f, 1.0f);
}

// Whether a ball lies wholly on the outer side of a plane.
WINDROW_FN bool windrow_beyond_plane(vec4 plane, vec3 centre, float radius) {
    return dot(vec3(plane), centre) + plane.w < -radius;
}

// 0 at `from` and nearer, 1 at `to` and farther; from < to.
WINDROW_FN float windrow_grass_ramp(float distance, float from, float to) {
    return clamp((distance - from) / (to - from), 0.0f, 1.0f);
}

// The level of a blade by the square of its distance [m2].
WINDROW_FN int windrow_grass_level(float square, vec4 reach) {
    if (!(square < reach.w * reach.w))
        return WINDROW_GRASS_NONE;
    return square < reach.y * reach.y ? WINDROW_GRASS_NEAR : WINDROW_GRASS_FAR;
}

// Height on the blade and side, -1, 0 or 1, of a vertex of a strip: rows of two from the root, then the tip. `morph` 0 to 1.
WINDROW_FN vec2 windrow_grass_row(int vertex, int level, float morph) {
    int rows = level == WINDROW_GRASS_NEAR ? WINDROW_GRASS_NEAR_ROWS : WINDROW_GRASS_FAR_ROWS;
    if (vertex >= 2 * rows)
        return vec2(1.0f, 0.0f);
    int row = vertex / 2;
    float side = (vertex & 1) == 0 ? -1.0f : 1.0f;
    float h = float(row) / float(rows);
    if (level == WINDROW_GRASS_NEAR) {
        float coarse = float(min(row / 2, WINDROW_GRASS_FAR_ROWS - 1)) / float(WINDROW_GRASS_FAR_ROWS);
        h = h * (1.0f - morph) + coarse * morph; // the coarse one to the bit at 1
    }
    return vec2(h, side);
}

// A blade of the class at a size and a distance: shorter and narrower by its size and by the fade, never narrower than the least width.
// The Cauchy number goes with the third power of the length at one thickness: short blades stand stiffer.
WINDROW_FN WindrowBlade windrow_grass_class(WindrowGrass grass, float size, float distance) {
    float kept = size * (1.0f - windrow_grass_ramp(distance, grass.reach.z, grass.reach.w));
    WindrowBlade blade = grass.blade;
    blade.size.x *= kept;
    blade.size.z = max(blade.size.z, 0.5f * grass.eye.w * distance) * kept;
    blade.drag.load.x *= kept * kept * kept;
    return blade;
}

#endif
