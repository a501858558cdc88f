// Sun, shadow and fog at a point, for fragments.
#ifndef WINDROW_RENDER_SHADING_GLSL
#define WINDROW_RENDER_SHADING_GLSL

#include "air.glsl"
#include "cloud_map.glsl"
#include "frame.glsl"
#include "../numerics/leaf_light.glsl"

// Share of the sun that reaches `at`, by one of the two maps: nine bilinear comparisons, a tent of four texels; of hard
// shadows one.
float shadow_fraction(int cascade, vec3 at) {
    vec3 clip = (frame.shadow[cascade] * vec4(at, 1.0)).xyz;
    vec2 uv = 0.5 * clip.xy + 0.5;
    float texel = frame.shadow_texel.z;
    uv = clamp(uv, vec2(2.0 * texel), vec2(1.0 - 2.0 * texel)); // what lies beside must not leak from the map's other half
    if (frame.pixel.z > 0.0)
        return texture(shadow_map, vec3(0.5 * (uv.x + float(cascade)), uv.y, clip.z));
    float lit = 0.0;
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
            vec2 tap = uv + texel * vec2(x, y);
            lit += texture(shadow_map, vec3(0.5 * (tap.x + float(cascade)), tap.y, clip.z));
        }
    return lit / 9.0;
}

// Of the sun's beam, past what stands in the maps and past the clouds. `lift` is the unit vector along which the point is moved
// off its surface, by texels, so that it does not shade itself.
float sun_fraction(vec3 position, vec3 lift) {
    float distance = length(position - frame.eye.xyz);
    float reach = frame.shadow_texel.w;
    float far = smoothstep(0.8 * reach, reach, distance);
    float lit = 0.0;
    if (far < 1.0)
        lit += (1.0 - far) * shadow_fraction(0, position + 1.5 * frame.shadow_texel.x * lift);
    if (far > 0.0) {
        vec3 at = position + 1.5 * frame.shadow_texel.y * lift;
        vec3 clip = (frame.shadow[1] * vec4(at, 1.0)).xyz;
        float edge = smoothstep(0.9, 1.0, max(abs(clip.x), abs(clip.y))); // beyond the map all is lit
        lit += far * (edge < 1.0 ? mix(shadow_fraction(1, at), 1.0, edge) : 1.0);
    }
    return lit * cloud_light(position);
}

vec3 fogged(vec3 radiance, vec3 p) {
    if (frame.sunlight.w <= 0.0)
        return radiance;
    vec4 air = air_before(p);
    return mix(air.rgb, radiance, air.w);
}

#endif
