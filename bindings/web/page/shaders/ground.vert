#version 300 es
#include "page.glsl"
layout(location = 0) in vec2 at; // [m] from the middle
out vec3 position;

// The land around the meadow: hills that begin beyond its edge.
float hill_height(vec2 place) {
    vec2 off = place - far.xy;
    float rise = smoothstep(far.z, 6.0 * far.z, length(off));
    return far.w * rise * (0.75 * windrow_place_noise(place / 90.0 + 40.0) + 0.25 * windrow_place_noise(place / 37.0 + 11.0));
}

void main() {
    vec2 place = at + middle.xy;
    position = vec3(place.x, ground_height(place) + hill_height(place), place.y);
    gl_Position = to_clip * vec4(position, 1.0);
}
