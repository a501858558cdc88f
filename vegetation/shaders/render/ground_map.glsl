// Noise of the ground's colour about the eye, from a map: what it has been is read, not worked out at each pixel.
//
//   r  clump of the meadow's colour     g  lightness of its plants     b  how dry it is       0 to 1, in 8 bits
#ifndef WINDROW_RENDER_GROUND_MAP_GLSL
#define WINDROW_RENDER_GROUND_MAP_GLSL

#include "shaders/numerics/place_noise.glsl"
#include "noise_map.glsl"

// At a place [m] from the ground's corner.
vec3 ground_noise(vec2 place) {
    float clump = windrow_place_noise(place / 2.3 + 11.0);
    float own = 0.5 * (windrow_place_noise(place / 0.5) + windrow_place_noise(place / 31.0 + 5.0));
    return vec3(clump, own, windrow_dryness(place));
}

#endif
