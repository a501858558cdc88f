// Leaves in the sun: the formulas of plants (leaf_light.glsl), darker within the crown and lighter at its rim.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "../render/frame.glsl"
#include "../numerics/leaf_light.glsl"
#include "../numerics/motion_vector.glsl"
#include "leaf_mask.glsl"
#include "tree_parts.glsl"

layout(location = 0) in vec4 card;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 sun;
layout(location = 3) in vec4 tone;
layout(location = 4) in vec3 to_eye;
layout(location = 5) in vec3 clip_now;
layout(location = 6) in vec3 clip_before;
layout(location = 7) in vec3 shade;
layout(location = 8) flat in uvec2 own;
layout(location = 0) out vec4 colour;
layout(location = 1) out vec2 motion;

const float k_passed_on = 0.35; // of the light that the leaves around get: what is left of it here

void main() {
    LeafMask mask = leaf_mask(card.x, card.y, card.z, card.w, kind.clock.w == 1u, own, kind.flutter, shade.z);
    int bits = sample_bits(mask.coverage, int(kind.clock.z), int(50.0 * (1.0 + card.w)));
    if (bits == 0)
        discard;
    gl_SampleMask[0] = bits;

    vec3 eye_way = normalize(to_eye);
    vec3 to_sun = frame.sky.sun.xyz;
    // Leaves of one card look into directions of their own.
    float turn = 6.28318531 * mask.leaf;
    vec3 n = normalize(normal) + 0.35 * vec3(cos(turn), 0.6 * sin(2.0 * turn), sin(turn));
    // Flutter tilts the normal by the sine of the turn, across the leaf's direction.
    n = normalize(n + sin(mask.turn) * vec3(-sin(turn), 0.0, cos(turn)));

    float many = 1.0 / max(card.z, 1.0); // a card that stands for many leaves has their mean
    float spread = 0.5 * many * card.w + 0.6 * (mask.leaf - 0.5) + 0.5 * shade.y;
    float young = clamp(0.75 * shade.x * shade.x + 0.35 * spread, 0.0, 1.0);
    vec3 albedo = mix(kind.leaf.rgb, kind.young.rgb, young) * (1.0 + kind.leaf.w * spread) * mix(0.8, 1.05, mask.along);
    vec3 through = kind.through.rgb * (1.0 + 0.5 * kind.leaf.w * spread);

    float cosine = dot(n, to_sun);
    vec3 radiance =
        0.318309886 * sun.rgb *
        (albedo * windrow_half_lambert(cosine) + through * windrow_leaf_through(cosine, -dot(eye_way, to_sun), kind.through.w));
    radiance += sun.rgb * windrow_gloss(n, to_sun, eye_way, kind.young.w);
    radiance += sun.w * albedo * windrow_around(n, frame.skylight.rgb, frame.groundlight.rgb);
    // What leaves around pass on of the sun's light, green by having been through them.
    radiance += 0.318309886 * k_passed_on * shade.x * frame.sunlight.rgb * kind.through.rgb * (albedo + through);
    colour = vec4(tone.rgb + tone.w * radiance, 1.0);
    motion = windrow_motion_vector(clip_now, clip_before);
}
