// Light on a leaf: half-Lambert, what shines through, a gloss.
//
//   reflected   albedo / pi * E ((n.l + 1) / 2)^2          half-Lambert: a thin, rough leaf has no dark side
//   through     albedo_t / pi * E ((1 - n.l) / 2)^2 (1 + k max(-v.l, 0)^4)   its other face, and more against the light
//   gloss       E F (s + 2) / (8 pi) * (n.h)^s max(n.l, 0)  Blinn-Phong with Schlick's F, F_0 = 0.04
//   around      albedo / pi * (E_sky (1 + n.y) / 2 + E_ground (1 - n.y) / 2)   even sky above, even ground below: exact for both
//
// n is the normal on the side that is seen, l the unit vector to the sun, v that from the point to the eye. n.l is not clamped
// before half-Lambert squares it: a clamped one gives an even quarter to all that turns away. One leaf that the sun grazes gives
// more than it gets; the mean over leaves of all directions gives 4/3 (albedo + albedo_t (1 + k / 10)) of what it gets, and the
// gloss at most 0.2 more: less than all while that sum is at most 0.6 (vegetation/tests/render/light_test.cpp).
// Based on: Mitchell, McTaggart & Green 2006, Shading in Valve's Source engine; Blinn 1977, Models of light reflection for
// computer synthesized pictures; Akenine-Moller, Haines & Hoffman 2018, Real-time rendering (the normalisation); Barre-Brisebois
// & Bouchard 2011, Approximating translucency for a fast, cheap and convincing subsurface scattering look.
#ifndef WINDROW_LEAF_LIGHT_GLSL
#define WINDROW_LEAF_LIGHT_GLSL

#ifndef WINDROW_FN
#define WINDROW_FN
#endif

// `cosine` -1 to 1.
WINDROW_FN float windrow_half_lambert(float cosine) {
    float half_way = 0.5f * cosine + 0.5f;
    return half_way * half_way;
}

// Share of the irradiance that comes through, before albedo / pi; `k` how much more against the light, 0 or more.
WINDROW_FN float windrow_leaf_through(float cosine, float against, float k) {
    float lobe = max(against, 0.0f);
    lobe *= lobe;
    return windrow_half_lambert(-cosine) * (1.0f + k * lobe * lobe);
}

// Radiance over irradiance of the gloss; `exponent` s, 1 or more.
WINDROW_FN float windrow_gloss(vec3 normal, vec3 to_light, vec3 to_eye, float exponent) {
    float facing = dot(normal, to_light);
    vec3 sum = to_light + to_eye;
    float square = dot(sum, sum);
    if (!(facing > 0.0f) || !(square > 1e-8f))
        return 0.0f;
    vec3 half_way = sum / sqrt(square);
    float away = 1.0f - clamp(dot(half_way, to_eye), 0.0f, 1.0f);
    float fresnel = 0.04f + 0.96f * away * away * away * away * away;
    return fresnel * (exponent + 2.0f) * 0.0397887358f * pow(max(dot(normal, half_way), 1e-6f), exponent) * facing;
}

// Irradiance over pi from what lies around, `sky` and `ground` being the irradiance that a level face gets from above and from
// below.
WINDROW_FN vec3 windrow_around(vec3 normal, vec3 sky, vec3 ground) {
    float up = 0.5f + 0.5f * normal.y;
    return 0.318309886f * (sky * up + ground * (1.0f - up));
}

#endif
