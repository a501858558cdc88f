// Colour of strands and light on them.
//
//   occlusion   o = sat(h^A + b)                                     dark roots; A = 0 none
//   colour      C = mix(root, mix(tip, second, patch), t^k) (1 + v (2 chance - 1))
//   pair        a = (1 - (1 - n_1) i_1)(1 - (1 - n_2) i_2), a strand where a >= h    two noise pictures with influences
//   gradient    g = mix(from the middle, from the side, square), without its part along N, of length 1
//   normal      blended  mix(g, N, t)                                the sources': lies at the root, faces up at the tip
//               sloped   g + slope N                                 exact: the gradient of the strand's own form
//   wrapped     mix(max(n.l, 0), ((n.l + 1) / 2)^2, wrap)            n.l not clamped before half-Lambert squares it: the back
//                                                                    falls to 0
//   gloss       max(n.h, 0)^power                                    Blinn and Phong as the sources have it, times an amount
//   sheen       (1 - (t.h)^2)^(power/2) = sin(t, h)^power            light along hair, t the strand's tangent
//   through     t^2 max(-v.l, 0)^4                                   tips that shine against the light
//   cel         levels of light with soft edges
//
// h counts over the whole coat, t = h / R over the strand. l to the light, v to the eye, h between them: unit vectors.
// windrow_gloss of leaf_light.glsl is the other gloss: normalised, with Fresnel's share; the plain one here has the sources' look
// and keeps no energy budget.
// Based on: Kajiya & Kay 1989, Rendering fur with three dimensional textures (light along hair: sine of the angle to it);
// Scheuermann 2004, Practical real-time hair rendering and shading (by the half vector); Blinn 1977, Models of light reflection;
// Mitchell, McTaggart & Green 2006, Shading in Valve's Source engine (half-Lambert).
#ifndef WINDROW_STRAND_LIGHT_GLSL
#define WINDROW_STRAND_LIGHT_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

#include "leaf_light.glsl"
#include "simplex.glsl"
#include "strand_field.glsl"

// Share of light that neighbours leave at h; `attenuation` A 0 or more, `bias` b 0 to 1.
WINDROW_FN float windrow_strand_occlusion(float h, float attenuation, float bias) {
    float open = attenuation > 0.0f ? windrow_mask_power(h, attenuation) : 1.0f;
    return clamp(open + bias, 0.0f, 1.0f);
}

// A factor between 1 - spread and 1 + spread that belongs to a strand, for its colour. Its length follows another chance.
WINDROW_FN float windrow_strand_tone(uvec2 key, float spread) {
    return 1.0f + spread * (2.0f * windrow_fraction(key.x * 747796405u + key.y) - 1.0f);
}

// How much of the second colour a place has, 0 to 1, in patches of about one unit of `place`.
WINDROW_FN float windrow_strand_patch(uint seed, vec3 place) {
    float s = clamp(0.5f + 1.25f * windrow_simplex(seed, place), 0.0f, 1.0f);
    return s * s * (3.0f - 2.0f * s);
}

// `t` 0 to 1 over the strand, `power` k above 0: 1 evenly, 3 the tip alone.
WINDROW_FN vec3 windrow_strand_colour(vec3 root, vec3 tip, vec3 second, float second_fraction, float t, float power, float tone) {
    return mix(root, mix(tip, second, second_fraction), windrow_mask_power(t, power)) * tone;
}

// What two noise pictures leave standing: a strand reaches up to this height. Influence 0 has no effect.
WINDROW_FN float windrow_noise_pair(float first, float second, float first_influence, float second_influence) {
    return (1.0f - (1.0f - first) * first_influence) * (1.0f - (1.0f - second) * second_influence);
}

// [cells] By how much a strand's section draws in from h to h + 1: what its form leans outward. 0 for cylinders; blunt tips count
// as 100.
WINDROW_FN float windrow_strand_slope(WindrowStrandField field, float h, float reach) {
    if (field.points.w < 0.5f)
        return 0.5f * field.cut.x;
    float own = max(reach, 1e-6f);
    float t = clamp(h / own, 1e-4f, 1.0f);
    float slope = (field.cut.x - field.cut.y) * field.cut.z * pow(t, field.cut.z - 1.0f) / own;
    if (field.points.w > 1.5f)
        return clamp(-slope, -100.0f, 100.0f);
    return clamp(0.5f * slope / max(sqrt(max(windrow_strand_cut(field, h, reach), 0.0f)), 1e-3f), -100.0f, 100.0f);
}

// Unit vector out of the strand, across n; 0 at its very middle. `outward` and `facet` as the hit has them, in the space of n.
WINDROW_FN vec3 windrow_strand_gradient(vec3 outward, vec3 facet, vec3 n, float square) {
    vec3 round_one = outward / max(sqrt(dot(outward, outward)), 1e-9f);
    vec3 g = mix(round_one, facet, square);
    g = g - dot(g, n) * n;
    float size = dot(g, g);
    return size > 1e-12f ? g / sqrt(size) : vec3(0.0f);
}

// The sources' normal: `g` at the root, n at the tip.
WINDROW_FN vec3 windrow_strand_blended(vec3 g, vec3 n, float t) {
    vec3 sum = mix(g, n, t);
    float size = dot(sum, sum);
    return size > 1e-12f ? sum / sqrt(size) : n;
}

// The normal of the strand's own form: `slope` from windrow_strand_slope over the cells that the coat is high (length times
// density).
WINDROW_FN vec3 windrow_strand_sloped(vec3 g, vec3 n, float slope) {
    vec3 sum = g + slope * n;
    float size = dot(sum, sum);
    return size > 1e-12f ? sum / sqrt(size) : n;
}

// Share of the irradiance across the beam that a surface gets; `wrap` 0 Lambert, 1 half-Lambert.
WINDROW_FN float windrow_wrapped(float cosine, float wrap) { return mix(max(cosine, 0.0f), windrow_half_lambert(cosine), wrap); }

// Between light and eye; n where they are opposite.
WINDROW_FN vec3 windrow_half_way(vec3 to_light, vec3 to_eye, vec3 n) {
    vec3 sum = to_light + to_eye;
    float size = dot(sum, sum);
    return size > 1e-8f ? sum / sqrt(size) : n;
}

// The sources' gloss, 0 to 1; `power` 1 or more.
WINDROW_FN float windrow_plain_gloss(vec3 n, vec3 half_way, float power) {
    float cosine = dot(n, half_way);
    return cosine > 0.0f ? pow(min(cosine, 1.0f), power) : 0.0f;
}

// Light along hair, 0 to 1; `tangent` unit vector along the strand.
WINDROW_FN float windrow_hair_sheen(vec3 tangent, vec3 half_way, float power) {
    float along = dot(tangent, half_way);
    float square = 1.0f - along * along;
    return square > 0.0f ? pow(min(square, 1.0f), 0.5f * power) : 0.0f;
}

// Light that comes through tips toward the eye, 0 to 1; `against` = -v.l.
WINDROW_FN float windrow_tips_through(float t, float against) {
    float lobe = max(against, 0.0f);
    lobe = t * lobe * lobe;
    return lobe * lobe;
}

// Light in `levels` steps of equal height, 0 to 1 and beyond; `soft` above 0 to 1 is the share of a step over which it rises.
// Below one level it stays as it is.
WINDROW_FN float windrow_cel(float light, float levels, float soft) {
    if (levels < 1.0f)
        return light;
    float at = light * levels;
    float below = floor(at);
    float s = clamp((at - below - 0.5f) / soft + 0.5f, 0.0f, 1.0f);
    return (below + s * s * (3.0f - 2.0f * s)) / levels;
}

#endif
