// Grass in the sun: dark between the roots; a blade that leans shows its pale face.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "scene.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 look;
layout(location = 0) out vec4 colour;

void main() {
    float height = clamp(look.x, 0.0, 1.0);
    float lean = smoothstep(0.25, 1.2, look.y);
    vec3 fresh = mix(vec3(0.040, 0.105, 0.016), vec3(0.170, 0.270, 0.045), height);
    vec3 own = mix(fresh, vec3(0.250, 0.215, 0.085), 0.5 * smoothstep(0.7, 1.0, look.z) * height);
    vec3 leaf = mix(own, vec3(0.58, 0.60, 0.29), 0.8 * lean * height);
    float open = mix(0.25, 1.0, pow(height, 0.8)); // what the neighbours leave of the light
    vec3 view = normalize(position - scene.eye.xyz);
    vec3 n = normalize(dot(normal, view) > 0.0 ? -normal : normal);
    float facing = dot(n, k_to_sun);
    vec3 light = k_skylight * (0.6 + 0.4 * n.y) + k_sunlight * (max(facing, 0.0) + 0.55 * max(-facing, 0.0));
    colour = vec4(hazed(1.3 * open * leaf * light, position), 1.0);
}
