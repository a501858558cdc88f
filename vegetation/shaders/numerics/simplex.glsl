// Simplex noise in space: smooth noise without the axes of a square lattice.
//
//   noise(x)  = k sum over the 4 corners c of the simplex that holds x of (1/2 - |x - c|^2)_+^4 g_c . (x - c)
//   octaves   = sum_n gain^n noise(R^n 2.03^n x) / sum_n gain^n    R a rotation: no octave repeats the lattice of another
//
// g_c are unit vectors, even over the sphere, from a hash of the corner: no table, no period. k scales the largest value to 1.
// Kernels of radius sqrt(1/2) end within their corners' simplices: value, slope and curvature are continuous (the usual 0.6
// jumps). |noise| <= 1, mean 0, zero at the corners, about one wave a unit. Within +-1e5 units.
// Based on: Perlin 2001, Noise hardware; Gustavson 2005, Simplex noise demystified; Quilez 2013, gradient noise (hashes for
// gradients).
#ifndef WINDROW_SIMPLEX_GLSL
#define WINDROW_SIMPLEX_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

#include "space_hash.glsl"
#include "../../../shaders/numerics/turn_sine.glsl"

// xyz slope, w value of one corner's kernel; `d` from the corner.
WINDROW_FN vec4 windrow_simplex_corner(uint seed, ivec3 corner, vec3 d) {
    float t = 0.5f - dot(d, d);
    if (!(t > 0.0f))
        return vec4(0.0f);
    uvec2 hash = windrow_space_hash(seed, corner);
    float z = 2.0f * windrow_fraction(hash.x) - 1.0f;
    float turn = windrow_fraction(hash.y);
    float across = sqrt(max(1.0f - z * z, 0.0f));
    vec3 g = vec3(across * windrow_turn_cosine(turn), across * windrow_turn_sine(turn), z);
    float along = dot(g, d);
    float square = t * t;
    return vec4(square * (square * g - (8.0f * t * along) * d), square * square * along);
}

// xyz slope [1/unit], w value, -1 to 1.
WINDROW_FN vec4 windrow_simplex_slope(uint seed, vec3 at) {
    vec3 base = floor(at + (at.x + at.y + at.z) * (1.0f / 3.0f));
    vec3 d = at - base + (base.x + base.y + base.z) * (1.0f / 6.0f);
    // The order of d's components names the tetrahedron of the skewed cube.
    bool xy = d.x >= d.y;
    bool yz = d.y >= d.z;
    bool xz = d.x >= d.z;
    ivec3 one = ivec3(xy && xz ? 1 : 0, !xy && yz ? 1 : 0, !xz && !yz ? 1 : 0);
    ivec3 two = ivec3(xy || xz ? 1 : 0, !xy || yz ? 1 : 0, !xz || !yz ? 1 : 0);
    ivec3 corner = ivec3(base);
    vec4 sum = windrow_simplex_corner(seed, corner, d);
    sum += windrow_simplex_corner(seed, corner + one, d - vec3(one) + 1.0f / 6.0f);
    sum += windrow_simplex_corner(seed, corner + two, d - vec3(two) + 1.0f / 3.0f);
    sum += windrow_simplex_corner(seed, corner + 1, d - 0.5f);
    return 107.6f * sum;
}

WINDROW_FN float windrow_simplex(uint seed, vec3 at) { return windrow_simplex_slope(seed, at).w; }

// -1 to 1; `gain` of each octave over the one before.
WINDROW_FN float windrow_simplex_octaves(uint seed, vec3 at, int octaves, float gain) {
    float sum = 0.0f;
    float all = 0.0f;
    float share = 1.0f;
    for (int n = 0; n < octaves; ++n) {
        sum += share * windrow_simplex(seed + uint(n), at);
        all += share;
        share *= gain;
        at = 2.03f * vec3(0.36f * at.x + 0.48f * at.y - 0.8f * at.z, -0.8f * at.x + 0.6f * at.y,
                          0.48f * at.x + 0.64f * at.y + 0.6f * at.z);
    }
    return sum / all;
}

#endif
