// Plants in the sun: colour from root to tip and from plant to plant, half-Lambert, light through the leaf, gloss, shadow, fog.
// Any plant whose vertex stage gives these inputs may use it.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "plant_look.glsl"
#include "shading.glsl"
#include "../numerics/motion_vector.glsl"

layout(std140, set = 2, binding = 0) uniform Look { PlantLook look; };

// Centroid: where a pixel's middle lies beside a thin blade, values from beyond its edge would sparkle.
layout(location = 0) centroid in vec3 position;
layout(location = 1) centroid in vec3 normal;
layout(location = 2) centroid in vec3 across;
layout(location = 3) centroid in vec4 kind;
layout(location = 4) centroid in vec3 clip_now;
layout(location = 5) centroid in vec3 clip_before;
layout(location = 0) out vec4 colour;
layout(location = 1) out vec2 motion;

void main() {
    float h = clamp(kind.x, 0.0, 1.0);
    vec3 to_sun = frame.sky.sun.xyz;
    vec3 sight = frame.eye.xyz - position;
    float distance = length(sight);
    vec3 to_eye = sight / distance;

    // A blade is rounded across, while it is wide enough to show; afar normals that differ from one blade to the next only
    // flicker.
    float shows = clamp(0.15 / max(fwidth(kind.y), 1e-3), 0.0, 1.0); // from 13 px across down to 2, where a seventh is left
    vec3 n = normalize(normal + 0.45 * shows * clamp(kind.y, -1.0, 1.0) * across);
    n = dot(n, to_eye) < 0.0 ? -n : n;
    n = normalize(mix(n, vec3(0.0, 1.0, 0.0), 0.25 + 0.55 * smoothstep(0.0, look.size.y, distance)));

    float dryness = smoothstep(0.35, 0.8, kind.w);
    vec3 fresh = mix(look.root.rgb, look.tip.rgb, h);
    float aged = clamp(0.6 * dryness + 0.45 * smoothstep(0.55, 1.0, kind.z), 0.0, 1.0);
    vec3 leaf = mix(fresh, mix(look.root.rgb, look.dry.rgb, h), aged) * (1.0 + look.tip.w * kind.z);
    leaf *= mix(vec3(1.0), vec3(0.78, 0.96, 1.15), clamp(-kind.z, 0.0, 1.0)); // some are bluer
    vec3 through = mix(look.through.rgb, look.dry.rgb, 0.7 * aged) * (0.4 + 0.6 * h);

    float lit = sun_fraction(position, to_sun);
    float open = mix(look.root.w, 1.0, h * (2.0 - h)); // what the neighbours leave of the sky
    float cosine = dot(n, to_sun);
    vec3 sun = frame.sunlight.rgb * lit * mix(0.55, 1.0, h);
    vec3 radiance =
        0.318309886 * sun *
        (leaf * windrow_half_lambert(cosine) + through * windrow_leaf_through(cosine, -dot(to_eye, to_sun), look.through.w));
    radiance += sun * windrow_gloss(n, to_sun, to_eye, look.dry.w) * h;
    radiance += open * leaf * windrow_around(n, frame.skylight.rgb, frame.groundlight.rgb);
    colour = vec4(fogged(radiance, position), 1.0);
    motion = windrow_motion_vector(clip_now, clip_before);
}
