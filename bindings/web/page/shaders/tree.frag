#version 300 es
// A crown of clumps of leaves: a noise cuts its edge and turns its normal, so that it is lit as a heap of balls is.
#include "page.glsl"
#include "vegetation/shaders/numerics/leaf_light.glsl"
in vec3 position;
in vec2 at;
flat in float chance;
flat in float tall;
out vec4 colour;

float clumps(vec2 p) { return 0.5 * windrow_place_noise(p * 6.0) + 0.5 * windrow_place_noise(p * 19.0 + 7.0); }

void main() {
    vec2 seed = vec2(300.0 + 400.0 * chance, 500.0 + 90.0 * fract(chance * 17.0));
    vec2 p = vec2(at.x * 0.8, at.y * 1.6) + seed;
    float heap = clumps(p), step_ = 0.02;
    vec2 slope = vec2(clumps(p + vec2(step_, 0.0)) - heap, clumps(p + vec2(0.0, step_)) - heap) / step_;
    // The crown: wider below its middle, from a quarter of the height on.
    vec2 c = vec2(at.x, (at.y - 0.6) / 0.4);
    float edge = length(vec2(c.x * (1.0 + 0.25 * c.y), c.y));
    float inside = 1.02 - edge - 0.85 * (0.62 - heap);
    float trunk = abs(at.x + 0.05 * sin(9.0 * at.y + 40.0 * chance)) - mix(0.05, 0.025, at.y);
    bool wood = trunk < 0.0 && at.y < 0.5 && inside < 0.12;
    if (inside < 0.0 && !wood)
        discard;
    vec3 to_eye = normalize(eye.xyz - position), right = normalize(vec3(to_eye.z, 0.0, -to_eye.x));
    vec3 n = normalize(right * (0.9 * c.x - 0.14 * slope.x) + vec3(0.0, 0.75 * c.y + 0.25 - 0.14 * slope.y, 0.0) + to_eye * (0.35 + 0.5 * max(1.0 - edge, 0.0)));
    vec3 leaf = mix(vec3(0.035, 0.07, 0.014), vec3(0.065, 0.1, 0.022), fract(chance * 7.0)) * mix(0.45, 1.25, heap);
    float hidden = mix(0.35, 1.0, smoothstep(0.0, 0.5, inside + 0.35 * (heap - 0.4) + 0.4 * c.y));
    vec3 sun = sunlight.rgb * hidden;
    float cosine = dot(n, sky.sun.xyz);
    vec3 radiance = wood ? vec3(0.05, 0.04, 0.03) * (0.318309886 * sun * 0.4 + windrow_around(n, skylight.rgb, groundlight.rgb))
                         : 0.318309886 * sun * leaf * (windrow_half_lambert(cosine) + 0.6 * windrow_leaf_through(cosine, -dot(to_eye, sky.sun.xyz), 2.0)) +
                               leaf * hidden * windrow_around(n, skylight.rgb, groundlight.rgb);
    colour = vec4(toned(fogged(radiance, position)), 1.0);
}
