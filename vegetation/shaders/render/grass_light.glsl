// Colour and light of grass: one text for its blades and for the ground that stands for them afar, so that the cut is not seen.
#ifndef WINDROW_RENDER_GRASS_LIGHT_GLSL
#define WINDROW_RENDER_GRASS_LIGHT_GLSL

#include "plant_look.glsl"
#include "../numerics/leaf_light.glsl"

// What a low eye sees of a canopy is its upper part: this share of its height stands for all of it afar.
const float k_seen_height = 0.72;

// A leaf at a height over the ground, 0 to 1 of the tallest. `clump` and `own` are chances 0 to 1, `dry` how dry its place is, 0
// to 1.
vec3 grass_albedo(PlantLook look, float tall, float clump, float own, float dry) {
    vec3 tip = mix(look.tip.rgb, look.second.rgb, clump);
    float aged = clamp(look.size.z * (0.75 * smoothstep(0.4, 0.75, dry) + 0.8 * smoothstep(0.9, 1.0, own)), 0.0, 1.0);
    vec3 leaf = mix(look.root.rgb, mix(tip, look.dry.rgb, aged), smoothstep(-0.1, 1.0, tall));
    return leaf * (1.0 + look.tip.w * (2.0 * own - 1.0));
}

// What shines through it.
vec3 grass_through(PlantLook look, vec3 leaf, float tall) {
    float lightness = max(leaf.g, 1e-4) / max(look.tip.g, 1e-4);
    return look.through.rgb * min(lightness, 1.2) * (0.3 + 0.7 * tall);
}

// Share of the sun that the neighbours leave at a height.
float grass_self_shade(PlantLook look, float tall) { return exp(-look.shape.y * (1.0 - tall)); }

// Share of the sky that they leave.
float grass_open(PlantLook look, float tall) { return mix(look.root.w, 1.0, tall * (2.0 - tall)); }

// Normal of a canopy afar whose tips lean by `bend` [rad]: leaves that lean turn their upper sides against the wind, most of all at
// 45 degrees; upright and flat ones have no side. So a gust is a lighter or a darker wave, by where the sun is.
vec3 grass_canopy_normal(PlantLook look, vec3 ground, vec2 bend) {
    float tip = length(bend);
    vec2 against = bend * (-0.5 * look.size.w * sin(2.0 * min(tip, 1.5707963)) / max(tip, 1e-6));
    return normalize(ground + vec3(against.x, 0.0, against.y));
}

// Its gloss: leaves that lie show their length to the sky.
float grass_canopy_gloss(PlantLook look, vec2 bend) {
    float flat_share = sin(min(length(bend), 1.5707963));
    return k_seen_height * min(look.size.w, 1.0) * (0.4 + 0.6 * flat_share * flat_share);
}

// `sun` is irradiance times what reaches the leaf; n looks toward the eye.
vec3 grass_radiance(PlantLook look, vec3 leaf, vec3 through, vec3 n, vec3 to_sun, vec3 to_eye, vec3 sun, vec3 sky, vec3 below,
                    float gloss) {
    float cosine = dot(n, to_sun);
    vec3 radiance =
        0.318309886 * sun *
        (leaf * windrow_half_lambert(cosine) + through * windrow_leaf_through(cosine, -dot(to_eye, to_sun), look.through.w));
    radiance += sun * (windrow_gloss(n, to_sun, to_eye, look.dry.w) * gloss);
    return radiance + leaf * windrow_around(n, sky, below);
}

#endif
