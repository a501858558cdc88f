#version 300 es
// A strand of the layer, or none; its colour and light (vegetation/shaders/fur/shell_colour.glsl, shell_light.glsl).
#include "coat.glsl"
in vec3 position, normal, along, rest, rest_normal;
flat in float height;
uniform bool depth_alone;
out vec4 colour;

// Share of a layer that strands fill at h, for those thinner than a pixel (shell_strand.glsl).
float mean_fraction(float h) {
    float sum = 0.0;
    for (int n = 0; n < 3; ++n) {
        float reach = mix(field.reach.x, field.reach.y, 0.5 * float(n)), radius = max(windrow_strand_radius(field, h, reach), 0.0);
        sum += (n == 1 ? 4.0 : 1.0) * (h <= reach ? 1.0 - exp(-3.14159265 * radius * radius) : 0.0);
    }
    return sum / 6.0;
}

void main() {
    colour = vec4(0.0);
    if (depth_alone)
        return;
    vec3 dx = dFdx(rest), dy = dFdy(rest);
    float longer = sqrt(max(dot(dx, dx), dot(dy, dy)));
    float pixel = max(field.cells.x * max(length(cross(dx, dy)) / max(longer, 1e-20), 0.125 * longer), 1e-4);
    float thin = smoothstep(0.6, 1.4, pixel);
    vec3 rest_n = normalize(rest_normal), n = normalize(normal);
    float map = coat_length(rest);
    bool bald = height <= 0.0, grows = map >= tousle.w;
    WindrowStrandHit hit = windrow_strand_none();
    float own = height / max(map, 1e-4), coverage = 0.0;
    if (!bald) {
        if (!grows || own > 1.0)
            discard;
        if (thin < 1.0) {
            hit = windrow_strand_surface(field, rest, rest_n, own);
            coverage = clamp(0.5 + hit.inside / pixel, 0.0, 1.0);
        }
        coverage = mix(coverage, mean_fraction(own), thin);
        // A share of the pixels of thin strands shows them all.
        float chance = windrow_fraction(windrow_space_hash(7u, ivec3(floor(rest * field.cells.x / max(pixel, 1.0)))).x);
        if (coverage < mix(0.5, chance, thin))
            discard;
    } else if (grows) // between the roots
        hit.key = windrow_space_hash(11u, ivec3(floor(rest * field.cells.x)));

    vec3 to_eye = normalize(eye.xyz - position);
    float t = clamp(own, 0.0, 1.0), lit_t = 1.0 - min(map, 1.0) * (1.0 - t);
    // A pixel without samples shows one of the strands that it covers: nearer to their mean.
    lit_t = mix(lit_t, 0.45 + 0.55 * lit_t, 0.4 + 0.6 * thin);
    float tone = grows ? windrow_strand_tone(hit.key, tip_colour.w * (1.0 - thin)) : 1.0;
    vec3 albedo = grows ? windrow_strand_colour(root_colour.rgb, tip_colour.rgb, second.rgb, windrow_strand_patch(91u, rest * second.w), lit_t, root_colour.w, tone)
                        : skin_colour.rgb;
    vec3 tint = vec3(0.0);
    float tinted = 0.0;
    for (int k = 0; k < coat_counts.y; ++k) {
        float share = spot_weight(spots[k], rest) * spots[k].tint.w, both = share + tinted * (1.0 - share);
        tint = both > 0.0 ? mix(tint, spots[k].tint.rgb, share / both) : tint;
        tinted = both;
    }
    albedo = mix(albedo, tint, tinted);
    float open = grows ? windrow_strand_occlusion(lit_t, coat_light.x, skin_colour.w) : 1.0, hair = grows ? 1.0 : 0.0;

    if (dot(n, to_eye) < 0.0) // beyond the horizon: what is seen still turns to the eye
        n = normalize(n + (0.02 - dot(n, to_eye)) * to_eye);
    vec3 outward = coat_turned(hit.outward);
    vec3 lit_normal = n;
    if (grows && dot(outward, outward) > 1e-12)
        lit_normal = normalize(mix(n, windrow_strand_blended(normalize(outward), n, t), sheen.w * (1.0 - thin)));
    vec3 to_sun = sky.sun.xyz, half_way = windrow_half_way(to_sun, to_eye, lit_normal);
    float facing = windrow_wrapped(dot(lit_normal, to_sun), coat_light.y);
    vec3 shine = facing * (vec3(coat_light.z * windrow_plain_gloss(lit_normal, half_way, coat_light.w)) +
                           sheen.x * windrow_hair_sheen(normalize(along), half_way, sheen.y) * mix(vec3(0.04), albedo, 0.5)) +
                 sheen.z * windrow_tips_through(t, -dot(to_eye, to_sun)) * albedo;
    vec3 sun = sunlight.rgb * sun_fraction(position + shells.form.x * (1.0 - height) * n + 0.06 * to_sun);
    vec3 radiance = 0.318309886 * sun * (open * facing * albedo + hair * t * shine) +
                    open * albedo * windrow_around(lit_normal, skylight.rgb, groundlight.rgb);
    colour = vec4(toned(fogged(radiance, position)), 1.0);
}
