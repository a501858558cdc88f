// Random numbers of a place: the same plant has the same yaw and stiffness in every frame, on every machine, to the bit.
//
//   hash    a bijection of pairs of 32-bit words: two plants with different keys never have the same pair of words
//   share   word >> 8, times 2^-24: 0 to 1, 1 left out; exact
//
// The key is an instance's own place, as it is stored: its cell, or the bits of its coordinates. A place relative to a camera or
// an anchor that moves is no key.
// Based on: Jarzynski & Olano 2020, Hash functions for GPU rendering (pcg2d); Wellons 2018, Prospecting for hash functions
// (lowbias32, each word's last mix).
#ifndef WINDROW_PLANT_HASH_GLSL
#define WINDROW_PLANT_HASH_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

WINDROW_FN uvec2 windrow_plant_hash(uvec2 key) {
    uvec2 v = key * 1664525u + 1013904223u;
    v.x += v.y * 1664525u;
    v.y += v.x * 1664525u;
    v = v ^ (v >> 16u);
    v.x += v.y * 1664525u;
    v.y += v.x * 1664525u;
    v = v ^ (v >> 16u);
    // The mix above leaves rows of a grid of floats uneven in single words (chi squared 46.8 of 15 degrees of freedom): once
    // more.
    v = v * 0x7feb352du;
    v = v ^ (v >> 15u);
    v = v * 0x846ca68bu;
    return v ^ (v >> 16u);
}

// A key from a place: distinct in x or z, distinct key. -0 counts as 0.
WINDROW_FN uvec2 windrow_place_key(float x, float z) {
    return uvec2(x == 0.0f ? 0u : floatBitsToUint(x), z == 0.0f ? 0u : floatBitsToUint(z));
}

// 0 to 1, 1 left out.
WINDROW_FN float windrow_fraction(uint word) {
    return float(int(word >> 8u)) * 5.9604644775390625e-8f; // by int: what vector instructions convert
}

// [rad] Yaw of a plant, 0 to 2 pi, from the first word of its hash. One rounding, hence one result in every language.
WINDROW_FN float windrow_plant_yaw(uvec2 hash) { return windrow_fraction(hash.x) * 6.28318530718f; }

// A factor between 1 - spread and 1 + spread from the second word; `spread` 0 to 1. One rounding of the product, one of the sum.
WINDROW_FN float windrow_plant_factor(uvec2 hash, float spread) {
    float chance = 2.0f * windrow_fraction(hash.y) - 1.0f;
    return 1.0f + spread * chance;
}

// A second chance that belongs to the same plant, from -1 to 1: for what should not follow its stiffness.
WINDROW_FN float windrow_plant_chance(uvec2 hash) {
    return 2.0f * windrow_fraction((hash.x << 11u) ^ (hash.y * 2654435761u)) - 1.0f;
}

#endif
