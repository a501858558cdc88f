// The sky above, the soil below, with the shadows of walker and fan.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "scene.glsl"

layout(location = 0) in vec3 far_point;
layout(location = 0) out vec4 colour;

void main() {
    vec3 direction = normalize(far_point - scene.eye.xyz);
    if (direction.y > -1e-3) {
        colour = vec4(sky_colour(direction), 1.0);
        return;
    }
    vec3 p = scene.eye.xyz - direction * (scene.eye.y / direction.y);
    float shadow = 0.0;
    for (int n = 0; n < 2; ++n) {
        vec2 offset = p.xz - (n == 0 ? scene.walker.xz : scene.fan.xz);
        vec2 away_from_sun = -normalize(k_to_sun.xz);
        float behind = dot(offset, away_from_sun), beside = dot(offset, vec2(-away_from_sun.y, away_from_sun.x));
        shadow = max(shadow, smoothstep(0.5, 0.1, abs(beside)) * smoothstep(-0.3, 0.0, behind) * smoothstep(4.5, 3.0, behind));
    }
    vec3 soil = mix(vec3(0.026, 0.036, 0.011), vec3(0.012, 0.016, 0.006), 0.8 * shadow);
    colour = vec4(hazed(soil, p), 1.0);
}
