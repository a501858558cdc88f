#version 460
#extension GL_GOOGLE_include_directive : require
#include "scene.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 paint;
layout(location = 0) out vec4 colour;

void main() {
    vec3 n = normalize(normal);
    float buried = smoothstep(0.0, 0.6, position.y); // between the blades it is dark
    vec3 light = k_skylight * (0.6 + 0.4 * n.y) + k_sunlight * max(dot(n, k_to_sun), 0.0);
    colour = vec4(hazed(paint * light * mix(0.25, 1.0, buried), position), 1.0);
}
