#version 300 es
#include "page.glsl"
#include "vegetation/shaders/numerics/leaf_light.glsl"
in vec3 position, normal;
uniform vec4 tint; // rgb albedo; w how much its grain shows
out vec4 colour;
void main() {
    vec3 n = normalize(normal), to_eye = normalize(eye.xyz - position);
    n = dot(n, to_eye) < 0.0 ? -n : n;
    vec3 p = position / 0.16, share = n * n; // of a noise along each axis; of one along a slope a ball shows streaks
    float grain = share.x * windrow_place_noise(p.zy + 600.0) + share.y * windrow_place_noise(p.xz + 600.0) +
                  share.z * windrow_place_noise(p.xy + 600.0);
    vec3 albedo = tint.rgb * (1.0 + tint.w * (grain - 0.5));
    // The grass around takes the sky from what stands low in it.
    float open = 0.45 + 0.55 * clamp((position.y - ground_height(position.xz)) / 0.6, 0.0, 1.0);
    vec3 sun = sunlight.rgb * sun_fraction(position + 0.05 * n);
    vec3 radiance =
        albedo * (0.318309886 * sun * max(dot(n, sky.sun.xyz), 0.0) + open * windrow_around(n, skylight.rgb, groundlight.rgb));
    colour = vec4(toned(fogged(radiance, position)), 1.0);
}
