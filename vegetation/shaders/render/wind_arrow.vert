// An arrow along the wind at a place of the lattice, turned about itself toward the eye: as long as the air goes in `look.y`
// seconds, no longer than two spacings.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "wind_lattice.glsl"

layout(location = 0) out vec3 shown; // x speed [m/s], y z beside and along a tile
layout(location = 1) out vec3 clip_now;
layout(location = 2) out vec3 clip_before;

// Beside and along, of a length of 1: shaft of two triangles, head of one.
const vec2 k_arrow[9] = vec2[](vec2(-0.03, 0.0), vec2(0.03, 0.0), vec2(0.03, 0.68), vec2(-0.03, 0.0), vec2(0.03, 0.68),
                               vec2(-0.03, 0.68), vec2(-0.12, 0.66), vec2(0.12, 0.66), vec2(0.0, 1.0));

void main() {
    vec3 tail = lattice_place(gl_InstanceIndex);
    vec3 wind = windrow_velocity(tail);
    float speed = length(wind);
    float way = min(speed * lattice.look.y, 2.0 * lattice.corner.w);
    vec3 along = speed > 1e-4 ? wind / speed : vec3(0.0, 1.0, 0.0);
    vec3 beside = cross(along, frame.eye.xyz - tail);
    beside /= max(length(beside), 1e-6);
    vec2 at = way * k_arrow[gl_VertexIndex];
    vec3 position = tail + at.y * along + at.x * beside;
    shown = vec3(speed, 0.0, 0.0);
    gl_Position = frame.view_projection * vec4(position, 1.0);
    clip_now = gl_Position.xyw;
    clip_before = (frame.view_projection_before * vec4(position, 1.0)).xyw;
}
