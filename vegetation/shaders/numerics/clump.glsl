// Clumps of a meadow: each place belongs to the nearest of scattered middles, and what grows there shares what the clump's
// chances say.
//
//   middles    m = c + 1/2 + 0.8 (r - 1/2)            c a cell of the clumps' own grid, r two chances
//   nearest    argmin over the 3 x 3 cells around the place: 0.8 of jitter keeps any nearer middle within them
//
// Places count in cells from the field's corner. Based on: Worley 1996, A cellular texture basis function; the use for grass:
// Wohllaib 2021, Procedural grass in Ghost of Tsushima (GDC).
#ifndef WINDROW_CLUMP_GLSL
#define WINDROW_CLUMP_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

#include "../../../shaders/numerics/plant_hash.glsl"

struct WindrowClump {
    vec2 offset;  // of the place from the clump's middle, in cells
    uvec2 chance; // the clump's own words
};

// `at` from 0 up; `key` tells one field's clumps from another's.
WINDROW_FN WindrowClump windrow_clump(vec2 at, uvec2 key) {
    ivec2 here = ivec2(floor(at));
    WindrowClump found;
    found.offset = vec2(0.0f);
    found.chance = uvec2(0u);
    float least = 1e9f;
    for (int z = 0; z <= 2; ++z)
        for (int x = 0; x <= 2; ++x) {
            ivec2 cell = here + ivec2(x, z); // one more than the cell itself: from 0 up
            uvec2 chance = windrow_plant_hash(uvec2(cell) ^ key);
            vec2 middle = vec2(cell) - 0.5f + 0.8f * (vec2(windrow_fraction(chance.x), windrow_fraction(chance.y)) - 0.5f);
            vec2 offset = at - middle;
            float square = dot(offset, offset);
            if (square < least) {
                least = square;
                found.offset = offset;
                found.chance = chance;
            }
        }
    return found;
}

#endif
