// Light as an open shutter sees it: numerics/motion_blur.glsl.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "blur_passes.glsl"

layout(set = 1, binding = 0) uniform sampler2D light;
layout(set = 1, binding = 1) uniform sampler2D streak_map;
layout(set = 1, binding = 2) uniform sampler2D longest_map; // a texel a tile
layout(location = 0) in vec2 ndc;
layout(location = 0) out vec4 seen;

const float k_most_samples = 24.0;

float samples_of(float half_length) { return clamp(2.0 * ceil(half_length), 4.0, k_most_samples); }

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy), last = textureSize(light, 0) - 1;
    vec4 here = texelFetch(streak_map, pixel, 0);
    vec2 longest = texelFetch(longest_map, pixel / int(push.most), 0).xy;
    seen = texelFetch(light, pixel, 0);
    float reach = length(longest), own = length(here.xy);
    if (!(reach > WINDROW_BLUR_LEAST))
        return; // all stands still
    // Samples of neighbours lie at other places, so that too few of them are grain and no steps. Based on: Jimenez 2014.
    float jitter = fract(52.9829189 * fract(dot(vec2(pixel), vec2(0.06711056, 0.00583715)))) - 0.5;

    // What is not before this pixel, over its own streak.
    vec4 behind = seen;
    if (own > WINDROW_BLUR_LEAST) {
        float count = samples_of(own), sum = 0.0;
        vec3 light_sum = vec3(0.0);
        for (float n = 0.5; n < count; ++n) {
            ivec2 there = ivec2(gl_FragCoord.xy + here.xy * (2.0 * (n + jitter) / count - 1.0));
            if (clamp(there, ivec2(0), last) != there)
                continue;
            float weight = 1.0 - windrow_blur_before(here.z, texelFetch(streak_map, there, 0).z);
            light_sum += weight * texelFetch(light, there, 0).rgb;
            sum += weight;
        }
        if (sum > 0.0)
            behind.rgb = light_sum / sum;
    }

    // What passes before it.
    float span = reach + 0.5; // windrow_blur_reaches
    float count = samples_of(span), apart = 2.0 * span / count, covered = 0.0;
    vec2 along = longest / reach;
    vec3 light_sum = vec3(0.0);
    for (float n = 0.5; n < count; ++n) {
        float away = apart * (n + jitter) - span;
        ivec2 there = ivec2(gl_FragCoord.xy + along * away);
        if (clamp(there, ivec2(0), last) != there)
            continue;
        vec4 streak = texelFetch(streak_map, there, 0);
        float weight = windrow_blur_before(here.z, streak.z) * windrow_blur_covers(abs(dot(streak.xy, along)), abs(away), apart);
        light_sum += weight * texelFetch(light, there, 0).rgb;
        covered += weight;
    }
    if (covered == 0.0)
        seen = behind;
    else
        seen.rgb = light_sum / max(covered, 1.0) + (1.0 - min(covered, 1.0)) * behind.rgb;
}
