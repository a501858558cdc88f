#version 300 es
#include "page.glsl"
#include "land.glsl"
layout(location = 0) in vec2 at; // [m] from the middle
out vec3 position;

void main() {
    vec2 place = at + middle.xy;
    position = vec3(place.x, ground_height(place) + hill_height(place), place.y);
    gl_Position = to_clip * vec4(position, 1.0);
}
