#version 300 es
// Bark: furrows along the stem or marks across it (vegetation/shaders/trees/tree_bark.frag).
#include "sway.glsl"
#include "vegetation/shaders/numerics/leaf_light.glsl"
in vec3 position, normal, wood;
in vec4 open;
uniform bool depth_alone;
out vec4 colour;

void main() {
    colour = vec4(0.0);
    if (depth_alone)
        return;
    vec3 n = normalize(normal);
    vec2 at = vec2(wood.x * 3.14159265 * max(wood.z, 0.02), wood.y) + 20.0 * tree_turn.z + 60.0;
    float seen = clamp(1.2 - 12.0 * (fwidth(at.x) + 0.25 * fwidth(at.y)), 0.0, 1.0);
    float ridges = windrow_place_noise(vec2((at.x + 0.05 * windrow_place_noise(at * vec2(9.0, 2.5))) * 26.0, at.y * 4.0));
    float furrows = smoothstep(0.3, 0.55, 0.65 * ridges + 0.35 * windrow_place_noise(at * vec2(70.0, 16.0)));
    float marks = windrow_place_noise(vec2(at.x * 9.0, at.y * 42.0)) * (0.55 + 0.45 * windrow_place_noise(at * vec2(3.0, 1.1)));
    float lines = (1.0 - smoothstep(0.5, 0.6, marks)) * smoothstep(0.02, 0.06, wood.z);
    float ridge = mix(0.65, mix(furrows, lines, bark.w), seen);
    vec3 albedo = mix(furrow.rgb, bark.rgb, ridge) * (1.0 + 0.15 * tree_turn.z);
    float through_crown = clamp(open.w + dot(open.xyz, sky.sun.xyz), 0.0, 1.0);
    float lit = sun_fraction(position + 0.05 * n) * mix(0.4, 1.0, through_crown);
    vec3 radiance = albedo * (0.318309886 * sunlight.rgb * max(dot(n, sky.sun.xyz), 0.0) * lit +
                              clamp(open.w + 0.6 * open.y, 0.08, 1.0) * windrow_around(n, skylight.rgb, groundlight.rgb));
    colour = vec4(toned(fogged(radiance, position)), 1.0);
}
