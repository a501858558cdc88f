// Grass in the sun: dark between the roots, light at the tips; a blade that leans shows its pale face, so that gusts run as
// waves.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "scene.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 look;
layout(location = 0) out vec4 colour;

void main() {
    float height = clamp(look.x, 0.0, 1.0); // where a pixel's middle lies beside the blade, it is told a value from beyond it
    float lean = smoothstep(0.35, 1.35, look.y);
    vec3 fresh = mix(vec3(0.045, 0.115, 0.016), vec3(0.175, 0.275, 0.040), height);
    vec3 own = mix(fresh, vec3(0.250, 0.215, 0.085), 0.55 * smoothstep(0.72, 1.0, look.z) * height);
    vec3 leaf = mix(own, vec3(0.56, 0.58, 0.27), 0.8 * lean * height);

    float open = mix(0.22, 1.0, pow(height, 0.8)); // what the neighbours leave of the light
    vec3 view = normalize(position - scene.eye.xyz);
    vec3 n = normalize(dot(normal, view) > 0.0 ? -normal : normal);
    float facing = max(dot(n, k_to_sun), 0.0);
    float through = 0.55 * max(-dot(n, k_to_sun), 0.0); // light that shines through
    vec3 light = k_skylight * (0.6 + 0.4 * n.y) + k_sunlight * (facing + through);
    colour = vec4(hazed(1.35 * open * leaf * light, position), 1.0);
}
