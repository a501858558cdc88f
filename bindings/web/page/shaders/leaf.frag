#version 300 es
// Leaves in the sun (vegetation/shaders/trees/tree_leaf.frag).
#include "sway.glsl"
#include "vegetation/shaders/numerics/leaf_light.glsl"
#include "vegetation/shaders/trees/leaf_mask.glsl"
in vec4 card;
in vec3 position, normal, sun;
in vec2 shade;
flat in uvec2 own;
uniform float wide;
uniform bool depth_alone;
out vec4 colour;

void main() {
    LeafMask mask = leaf_mask(card.x, card.y, wide, card.z, tree_counts.w == 1, own, flutter, card.w);
    if (mask.coverage < 0.5)
        discard;
    colour = vec4(0.0);
    if (depth_alone)
        return;
    vec3 to_eye = normalize(eye.xyz - position);
    float leaf_turn = 6.28318531 * mask.leaf;
    vec3 n = normalize(normal);
    n = dot(n, to_eye) < 0.0 ? -n : n;
    n = normalize(n + 0.35 * vec3(cos(leaf_turn), 0.6 * sin(2.0 * leaf_turn), sin(leaf_turn)));
    n = normalize(n + sin(mask.turn) * vec3(-sin(leaf_turn), 0.0, cos(leaf_turn)));
    float spread = 0.5 * card.z / wide + 0.6 * (mask.leaf - 0.5) + 0.5 * tree_turn.z;
    float green = clamp(0.75 * shade.y * shade.y + 0.35 * spread, 0.0, 1.0);
    vec3 albedo = mix(leaf.rgb, young.rgb, green) * (1.0 + leaf.w * spread) * mix(0.8, 1.05, mask.along);
    vec3 shining = through.rgb * (1.0 + 0.5 * leaf.w * spread);
    float cosine = dot(n, sky.sun.xyz);
    vec3 radiance = 0.318309886 * sun * (albedo * windrow_half_lambert(cosine) +
                                         shining * windrow_leaf_through(cosine, -dot(to_eye, sky.sun.xyz), through.w));
    radiance += sun * windrow_gloss(n, sky.sun.xyz, to_eye, young.w);
    radiance += shade.x * albedo * windrow_around(n, skylight.rgb, groundlight.rgb);
    // What the leaves around pass on of the sun's light, green by having been through them.
    radiance += 0.318309886 * 0.35 * shade.y * sunlight.rgb * through.rgb * (albedo + shining);
    colour = vec4(toned(fogged(radiance, position)), 1.0);
}
