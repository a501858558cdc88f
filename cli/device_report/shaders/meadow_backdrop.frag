// The sky above, the soil below.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "scene.glsl"

layout(location = 0) in vec2 place;
layout(location = 0) out vec4 colour;

void main() {
    vec4 far_point = inverse(scene.view_projection) * vec4(2.0 * place - 1.0, 1.0, 1.0);
    vec3 direction = normalize(far_point.xyz / far_point.w - scene.eye.xyz);
    vec3 soil = vec3(0.030, 0.042, 0.014);
    colour = vec4(
        direction.y > -1e-3 ? sky_colour(direction) : hazed(soil, scene.eye.xyz - direction * (scene.eye.y / direction.y)), 1.0);
}
