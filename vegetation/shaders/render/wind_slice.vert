// A tile around each place of the lattice, above the ground.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "wind_lattice.glsl"

layout(location = 0) out vec3 shown; // x speed [m/s], y z beside and along a tile
layout(location = 1) out vec3 clip_now;
layout(location = 2) out vec3 clip_before;

void main() {
    int corner = gl_VertexIndex;
    vec2 at =
        vec2(corner == 1 || corner == 3 || corner == 4 ? 0.5 : -0.5, corner == 2 || corner == 4 || corner == 5 ? 0.5 : -0.5);
    vec3 position = lattice_place(gl_InstanceIndex);
    position.xz += lattice.corner.w * at;
    position.y = terrain_height(position.xz) + lattice.corner.y; // tiles meet
    shown = vec3(length(windrow_velocity(position)), 0.0, 1.0);
    gl_Position = frame.view_projection * vec4(position, 1.0);
    clip_now = gl_Position.xyw;
    clip_before = (frame.view_projection_before * vec4(position, 1.0)).xyw;
}
