// Where blades of a field stand, which of them a view needs, and with how many vertices: one text for the passes that make and
// cull them, the vertex stage that draws them, and C++.
//
//   place      p = (c + 1/2 + j (r - 1/2)) / density            c the cell, a blade place each; r two chances, j the jitter
//   chances    windrow_plant_hash of the cell and a stream: a function of the cell's number alone, so that order and threads
//              do not matter. Stream 0 is the blade's own key (yaw, stiffness, length, own bend), 1 its place, 2 its looks, 3 is
//              the clumps', 4 whether it is left out afar.
//   kept       a ball around the root, of the longest blade's length and half its width times this one's size, reaches into the
//              frustum: no bend leaves it
//   level      by the distance d of the eye from the root: near (15 vertices) for d < split, far (5 or 7) for d < cut, none beyond
//   row        near rows slide along the blade toward the far rows while d goes from morph to split: h = h_near + m (h_far -
//              h_near), so that both strips are one at d = split, vertex by vertex
//   fade       length and width shrink to 0 while d goes from fade to cut: nothing pops there either
//   thinning   a blade of chance c (0 to 1) stands while c < s(d) = (1 + b) min(d_0 / d, 1)^p and shrinks away before: its size
//              is q = min((s - c) / w, 1), w = s b / (1 + b). All stand at d_0 and nearer. The area that is left is the integral
//              of q^2 over c,
//                  E(s) = s / (1 + b) + w / 3 (1 - max((s - 1) / w, 0)^3),   E(1 + b) = 1,
//              and blades are (1 / E)^k as wide: with k = 1 what they cover from above stays what it was; a low eye, before which
//              blades stand behind each other, is content with less.
//   growth     clumps and patches make blades smaller than the class, never larger
//
// Distances and places are [m]; places from the field's corner.
// Based on: sizes of tiles and vertex counts as in Wohllaib 2021, Procedural grass in Ghost of Tsushima (GDC); Hoppe 1996,
// Progressive meshes (geomorphs: vertices that slide to where their coarser mesh has them).
#ifndef WINDROW_GRASS_GLSL
#define WINDROW_GRASS_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

#include "../../../shaders/numerics/blade.glsl"
#include "clump.glsl"
#include "../../../shaders/numerics/place_noise.glsl"
#include "../../../shaders/numerics/plant_hash.glsl"

#define WINDROW_GRASS_NEAR 0
#define WINDROW_GRASS_FAR 1
#define WINDROW_GRASS_NONE 2
#define WINDROW_GRASS_NEAR_ROWS 7
#define WINDROW_GRASS_SHRINK 0.35f // b: share of the distance's share over which a blade shrinks away

// The same layout as grass::Block (vegetation/grass/grass_block.h), which fills it. Usable in a std140 block.
struct WindrowGrass {
    // xyz [m] the field's corner from the frame's anchor; w [m] longest blade and half the widest: radius of the ball
    vec4 corner;
    vec4 eye;        // xyz [m] from the field's corner; w [rad] least width of a drawn blade
    vec4 eye_before; // xyz a frame ago, w 0
    vec4 reach;      // [m] x morph, y split, z fade, w cut
    vec4 ground;   // x [1/m] blade places a metre, y jitter; z [m] cut of the shadow's view, w rows of two of a far blade, 2 or 3
    ivec4 cells;   // xy cells of the field along x and z, z cells along a chunk's side, w seed
    ivec4 corners; // xy of the heights along x and z, zw of the mask
    vec4 spacing;  // [m] xy of the heights, zw of the mask
    vec4 thin;     // x [m] d_0, y p, z how much of what is lost blades are wider by: an exponent on 1 / E
    vec4 clump;    // x [1/m] clumps a metre; shares: y less height, z one way to face, w outward
    vec4 patches;  // x [1/m] patches a metre, y share of less height, zw 0
    // of the colour's view and of the shadow's: dot(xyz, p) + w >= 0 inside, p from the field's corner; xyz unit vectors
    vec4 planes[12];
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
    vec2 chance = vec2(windrow_fraction(hash.x), windrow_fraction(hash.y)) - 0.5f;
    return (vec2(cell) + 0.5f + jitter * chance) / density;
}

// Size of a blade over its class by the mask's alpha: none at 0 and below, linear up to 1.
WINDROW_FN float windrow_grass_size(float alpha) { return clamp(alpha, 0.0f, 1.0f); }

// The clump that a place [m] belongs to.
WINDROW_FN WindrowClump windrow_grass_clump(WindrowGrass grass, vec2 place) {
    return windrow_clump(place * grass.clump.x, windrow_grass_key(ivec2(0), uint(grass.cells.w), 3u));
}

// Size over the mask's by clump and patch, at most 1.
WINDROW_FN float windrow_grass_growth(WindrowGrass grass, vec2 place) {
    float grown = 1.0f;
    if (grass.clump.y > 0.0f) {
        WindrowClump clump = windrow_grass_clump(grass, place);
        grown -= grass.clump.y * windrow_fraction(clump.chance.x * 2654435761u);
    }
    if (grass.patches.y > 0.0f)
        grown *= 1.0f - grass.patches.y * windrow_place_noise(place * grass.patches.x);
    return grown;
}

// The hash of a blade that faces, in part, as its clump does: its other traits stay chances of its own. One of 256 ways, and
// between them the hash's own bits: its length is drawn from all bits, and an arctangent's last ones are each device's own.
WINDROW_FN uvec2 windrow_grass_facing(WindrowGrass grass, uvec2 hash, WindrowClump clump) {
    if (!(grass.clump.z > 0.0f) && !(grass.clump.w > 0.0f))
        return hash;
    vec2 own = windrow_yaw_vector(windrow_plant_yaw(hash));
    vec2 shared_way = windrow_yaw_vector(windrow_plant_yaw(clump.chance));
    vec2 toward = own * (1.0f - grass.clump.z) + shared_way * grass.clump.z + clump.offset * (2.0f * grass.clump.w);
    float turn = atan(toward.y, toward.x) * 0.15915494f;
    turn -= floor(turn);
    return uvec2((uint(min(turn * 256.0f, 255.0f)) << 24u) | (hash.x & 0xffffffu), hash.y);
}

// Share of the blades at a distance [m], times 1 + b: s(d).
WINDROW_FN float windrow_grass_fraction(vec4 thin, float distance) {
    return (1.0f + WINDROW_GRASS_SHRINK) * pow(min(thin.x / max(distance, 1e-6f), 1.0f), thin.y);
}

// Size of a blade of chance `c` where the share is s: 0 does not stand.
WINDROW_FN float windrow_grass_presence(float c, float s) {
    float width = s * (WINDROW_GRASS_SHRINK / (1.0f + WINDROW_GRASS_SHRINK));
    return clamp((s - c) / width, 0.0f, 1.0f);
}

// E(s): what share of the area is left before blades are widened.
WINDROW_FN float windrow_grass_cover(float s) {
    float width = s * (WINDROW_GRASS_SHRINK / (1.0f + WINDROW_GRASS_SHRINK));
    float beyond = max((s - 1.0f) / width, 0.0f);
    return s / (1.0f + WINDROW_GRASS_SHRINK) + width / 3.0f * (1.0f - beyond * beyond * beyond);
}

// How much wider those are that are left: 1 / E where thin.z is 1.
WINDROW_FN float windrow_grass_wider(vec4 thin, float s) { return pow(windrow_grass_cover(s), -thin.z); }

// A cell's chance to be left out afar.
WINDROW_FN float windrow_grass_chance(ivec2 cell, uint seed) {
    return windrow_fraction(windrow_plant_hash(windrow_grass_key(cell, seed, 4u)).x);
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

// Height on the blade and side, -1, 0 or 1, of a vertex of a strip: rows of two from the root, then the tip. A far blade has
// `far_rows` of them, 2 or 3. `morph` 0 to 1.
WINDROW_FN vec2 windrow_grass_row(int vertex, int level, int far_rows, float morph) {
    int rows = level == WINDROW_GRASS_NEAR ? WINDROW_GRASS_NEAR_ROWS : far_rows;
    if (vertex >= 2 * rows)
        return vec2(1.0f, 0.0f);
    int row = vertex / 2;
    float side = (vertex & 1) == 0 ? -1.0f : 1.0f;
    float h = float(row) / float(rows);
    if (level == WINDROW_GRASS_NEAR) {
        int onto = row / ((WINDROW_GRASS_NEAR_ROWS + 1) / far_rows); // the far row that it becomes
        float coarse = float(min(onto, far_rows - 1)) / float(far_rows);
        h = h * (1.0f - morph) + coarse * morph; // the coarse one to the bit at 1
    }
    return vec2(h, side);
}

// A blade of the class at a size and a distance: shorter and narrower by its size and by the fade, never narrower than the least
// width. The Cauchy number goes with the third power of the length at one thickness: short blades stand stiffer.
WINDROW_FN WindrowBlade windrow_grass_class(WindrowGrass grass, float size, float distance) {
    float kept = size * (1.0f - windrow_grass_ramp(distance, grass.reach.z, grass.reach.w));
    WindrowBlade blade = grass.blade;
    blade.size.x *= kept;
    blade.size.z = max(blade.size.z, 0.5f * grass.eye.w * distance) * kept;
    blade.drag.load.x *= kept * kept * kept;
    return blade;
}

// The same where blades thin out: `chance` is windrow_grass_chance.
WINDROW_FN WindrowBlade windrow_grass_thinned(WindrowGrass grass, float size, float distance, float chance) {
    if (!(grass.thin.y > 0.0f))
        return windrow_grass_class(grass, size, distance);
    float s = windrow_grass_fraction(grass.thin, distance);
    float kept = windrow_grass_presence(chance, s);
    grass.blade.size.z *= windrow_grass_wider(grass.thin, s);
    return windrow_grass_class(grass, size * kept, distance);
}

#endif
