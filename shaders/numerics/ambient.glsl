// The ambient wind as a function of place and time.
//
//   profile    P(z) = log((z + z0) / z0) / log((zref + z0) / z0)         0 at the ground, 1 at the reference height
//   ambient    u(x, t) = P U + min(P, 1) A n((x - t V) / s)              V the horizontal part of U, s [m] the edge of a texel
//   detail     d = share |u| n((x - t V) / s_d) / max|n|                 |d| <= share |u|: still air gives exactly 0
//   felt       (u + d) times a strength, its length kept below a limit
//
// n is the gust tile: 128 x 16 x 128 texels of solenoidal noise, texel i centred on i + 1/2. It repeats along x and z; along y
// it holds half a period, mirrored at both ends, where the vertical component turns its sign: no gust blows through the ground.
// Texels are blended by hand, since texture units weigh with 8 fractional bits. Gusts are frozen and carried along by the mean.
// Positions are [m] from an anchor whose place in the tile the host finds in double: exact however far away.
//
// A language that keeps the tile elsewhere than in a sampler3D defines WINDROW_TILE, the type of the parameter that stands for
// it, and windrow_tile_texel, before this text.
// Based on: Taylor 1938, The spectrum of turbulence (frozen turbulence); the logarithmic law of the wall (Prandtl, von Karman),
// shifted by z0 so that it begins at the ground.
#ifndef WINDROW_AMBIENT_GLSL
#define WINDROW_AMBIENT_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

#ifndef WINDROW_TILE
#define WINDROW_TILE sampler3D
// One texel; each index lies within the tile.
WINDROW_FN vec3 windrow_tile_texel(WINDROW_TILE tile, ivec3 texel) { return texelFetch(tile, texel, 0).xyz; }
#endif

// The same layout as windrow::AmbientBlock (fluid/ambient.h), which says more of each field. Usable in a std140 block.
struct WindrowAmbient {
    vec3 mean;
    float gust_strength;
    float roughness_length, reference_height, anchor_height, felt_strength;
    vec3 gust_texel;
    float gust_texels;
    vec3 gust_fraction;
    float longest_gust;
    vec3 gust_axes;
    float felt_limit;
    vec3 detail_texel;
    float detail_texels;
    vec3 detail_fraction;
    float detail_amount;
};

// Share of the reference wind at a height [m]. `roughness` and `reference` [m] above 0.
WINDROW_FN float windrow_profile(float height, float roughness, float reference) {
    if (!(height > 0.0f))
        return 0.0f;
    return log(1.0f + height / roughness) / log(1.0f + reference / roughness);
}

// What a cubic read of a profile has over a linear one, at t in [0, 1] between two rows with these second differences: Everett's form
// of the cubic.
WINDROW_FN float windrow_profile_bend(float t, float low, float high) {
    return (1.0f / 6.0f) * t * (t - 1.0f) * ((2.0f - t) * low + (1.0f + t) * high);
}

// The tile's vector at any whole texel: wrapped along x and z, mirrored along y.
WINDROW_FN vec3 windrow_tile_repeated(WINDROW_TILE tile, ivec3 texel) {
    int y = texel.y & 31;
    bool mirrored = y > 15;
    vec3 n = windrow_tile_texel(tile, ivec3(texel.x & 127, mirrored ? 31 - y : y, texel.z & 127));
    return mirrored ? vec3(n.x, -n.y, n.z) : n;
}

// a + t (b - a): equal ends give themselves, to the bit, and opposite ends cancel halfway.
WINDROW_FN vec3 windrow_tile_blend(vec3 a, vec3 b, float t) { return a + t * (b - a); }

// The tile `offset` texels from the centre of `texel`, trilinear.
WINDROW_FN vec3 windrow_tile_at(WINDROW_TILE tile, ivec3 texel, vec3 offset) {
    vec3 whole = floor(offset);
    vec3 t = offset - whole;
    ivec3 low = texel + ivec3(whole);
    ivec3 high = low + ivec3(1, 1, 1);
    vec3 ll = windrow_tile_blend(windrow_tile_repeated(tile, low), windrow_tile_repeated(tile, ivec3(high.x, low.y, low.z)), t.x);
    vec3 hl = windrow_tile_blend(windrow_tile_repeated(tile, ivec3(low.x, high.y, low.z)),
                                 windrow_tile_repeated(tile, ivec3(high.x, high.y, low.z)), t.x);
    vec3 lh = windrow_tile_blend(windrow_tile_repeated(tile, ivec3(low.x, low.y, high.z)),
                                 windrow_tile_repeated(tile, ivec3(high.x, low.y, high.z)), t.x);
    vec3 hh =
        windrow_tile_blend(windrow_tile_repeated(tile, ivec3(low.x, high.y, high.z)), windrow_tile_repeated(tile, high), t.x);
    return windrow_tile_blend(windrow_tile_blend(ll, hl, t.y), windrow_tile_blend(lh, hh, t.y), t.z);
}

// [m/s] The ambient wind at `local` [m] from the anchor. What is off is not fetched.
WINDROW_FN vec3 windrow_ambient(WINDROW_TILE tile, WindrowAmbient ambient, vec3 local) {
    float share = 1.0f;
    if (ambient.roughness_length > 0.0f)
        share = windrow_profile(ambient.anchor_height + local.y, ambient.roughness_length, ambient.reference_height);
    vec3 wind = share * ambient.mean;
    if (ambient.gust_strength > 0.0f) {
        vec3 offset = ambient.gust_texels * local + ambient.gust_fraction;
        vec3 gust = windrow_tile_at(tile, ivec3(ambient.gust_texel), offset);
        wind += ambient.gust_strength * min(share, 1.0f) * ambient.gust_axes * gust;
    }
    return wind;
}

// Length of a vector whose square may not fit a float.
WINDROW_FN float windrow_speed(vec3 u) {
    float largest = max(max(abs(u.x), abs(u.y)), max(abs(u.z), 1e-30f));
    return largest * length(u / largest);
}

// [m/s] Small-scale detail of a wind `u` at `local` [m] from the anchor; never longer than its share of |u|.
WINDROW_FN vec3 windrow_detail(WINDROW_TILE tile, WindrowAmbient ambient, vec3 u, vec3 local) {
    if (!(ambient.detail_amount > 0.0f))
        return vec3(0.0f, 0.0f, 0.0f);
    vec3 offset = ambient.detail_texels * local + ambient.detail_fraction;
    vec3 ripple = windrow_tile_at(tile, ivec3(ambient.detail_texel), offset) / ambient.longest_gust;
    return ambient.detail_amount * windrow_speed(u) * ripple;
}

// NaN or infinity, by the bits: a compiler may assume away a comparison.
WINDROW_FN bool windrow_not_finite(float value) { return (floatBitsToUint(value) & 0x7f800000u) == 0x7f800000u; }

// u times `strength`, shortened to `limit` [m/s] if longer; 0 for what is not finite. Below the limit it is linear to the bit.
// The limit is met from below, by a margin of half a millionth, so that no rounding exceeds it.
WINDROW_FN vec3 windrow_limited(vec3 u, float strength, float limit) {
    if (windrow_not_finite(u.x) || windrow_not_finite(u.y) || windrow_not_finite(u.z))
        return vec3(0.0f, 0.0f, 0.0f);
    float most = 0.9999995f * limit;
    float largest = max(max(abs(u.x), abs(u.y)), max(abs(u.z), 1e-30f));
    vec3 direction = u / largest;
    float relative = length(direction);
    if (abs(strength) * largest * relative <= most)
        return strength * u;
    return (strength < 0.0f ? -most : most) / relative * direction;
}

// [m/s] What a plant feels of a wind `u` at `local` [m] from the anchor: detail, strength, limit.
WINDROW_FN vec3 windrow_felt(WINDROW_TILE tile, WindrowAmbient ambient, vec3 u, vec3 local) {
    return windrow_limited(u + windrow_detail(tile, ambient, u, local), ambient.felt_strength, ambient.felt_limit);
}

// [m/s] A gust that is the same everywhere, without a tile or a fluid: in each period the wind rises within a fifth and falls
// over the rest, both as exponentials of three time constants, e = exp(-3). It lies between its lull and mean + amplitude, never
// further than `amplitude` from the mean, which it has exactly: the curve g, from 0 to 1, has the mean M below. `period` [s]
// above 0.
WINDROW_FN float windrow_uniform_gust(float time, float mean, float amplitude, float period) {
    float e = exp(-3.0f);
    float phase = time / period;
    phase -= floor(phase);
    float g = phase < 0.2f ? (1.0f - exp(-15.0f * phase)) / (1.0f - e) : (exp(-3.75f * (phase - 0.2f)) - e) / (1.0f - e);
    float M = 0.2f * (1.0f / (1.0f - e) - 1.0f / 3.0f) + 0.8f * (1.0f / 3.0f - e / (1.0f - e));
    return mean + amplitude * (g - M) / (1.0f - M);
}

#endif
