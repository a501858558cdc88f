// Two triangles a cell of the grid of heights, without a vertex buffer: one instance a row, six vertices a cell.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "terrain.glsl"

layout(location = 0) out vec3 position;
layout(location = 1) out vec3 normal;
layout(location = 2) out vec3 clip_now;
layout(location = 3) out vec3 clip_before;

void main() {
    int corner = gl_VertexIndex % 6;
    ivec2 at = ivec2(gl_VertexIndex / 6, gl_InstanceIndex);
    at += ivec2(corner == 1 || corner == 3 || corner == 4 ? 1 : 0, corner == 2 || corner == 4 || corner == 5 ? 1 : 0);
    position = terrain_point(at);
    normal = terrain_normal(at);
    gl_Position = frame.view_projection * vec4(position, 1.0);
    clip_now = gl_Position.xyw;
    clip_before = (frame.view_projection_before * vec4(position, 1.0)).xyw;
}
