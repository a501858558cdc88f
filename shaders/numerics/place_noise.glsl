// Value noise of places: patches of a meadow, the same on the host and in shaders.
//
//   noise(x) = sum over the four corners of the cell of w(x) v(corner)
//   w bilinear with s^2 (3 - 2 s), v by windrow_plant_hash, 0 to 1
//
// `at` counts in cells from a corner that does not move with the camera. Within +-1e6 cells; the slope is continuous.
#ifndef WINDROW_PLACE_NOISE_GLSL
#define WINDROW_PLACE_NOISE_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

#include "plant_hash.glsl"

WINDROW_FN float windrow_place_chance(ivec2 cell) { return windrow_fraction(windrow_plant_hash(uvec2(cell)).x); }

WINDROW_FN float windrow_place_noise(vec2 at) {
    vec2 below = floor(at);
    ivec2 cell = ivec2(below);
    vec2 s = at - below;
    s = s * s * (3.0f - 2.0f * s);
    float near = mix(windrow_place_chance(cell), windrow_place_chance(cell + ivec2(1, 0)), s.x);
    float far = mix(windrow_place_chance(cell + ivec2(0, 1)), windrow_place_chance(cell + ivec2(1, 1)), s.x);
    return mix(near, far, s.y);
}

// How dry a meadow is at a place [m from its corner], 0 to 1: patches of 9 m, 3.1 m and 1.1 m.
WINDROW_FN float windrow_dryness(vec2 place) {
    return 0.55f * windrow_place_noise(place / 9.0f) + 0.3f * windrow_place_noise(place / 3.1f + 31.0f) +
           0.15f * windrow_place_noise(place / 1.1f + 77.0f);
}

#endif
