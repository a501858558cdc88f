#version 300 es
// Trees at the horizon: a rectangle each, turned to the eye about its trunk.
#include "page.glsl"
#include "land.glsl"
layout(location = 0) in vec4 tree; // xy [m] place, z [m] height, w its chance
out vec3 position;
out vec2 at; // across -1 to 1, up 0 to 1
flat out float chance;
flat out float tall;

void main() {
    at = vec2(2.0 * float(gl_VertexID & 1) - 1.0, float(gl_VertexID >> 1));
    chance = tree.w;
    tall = tree.z;
    vec2 away = normalize(eye.xz - tree.xy);
    vec3 right = vec3(away.y, 0.0, -away.x);
    float wide = tall * mix(0.36, 0.52, chance);
    position = vec3(tree.x, ground_height(tree.xy) + hill_height(tree.xy) - 0.04 * tall, tree.y) + right * (wide * at.x) + vec3(0.0, 1.04 * tall * at.y, 0.0);
    gl_Position = to_clip * vec4(position, 1.0);
}
