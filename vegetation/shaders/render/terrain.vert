// The ground of a view: strips of cells and level tiles, without a vertex buffer.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "terrain_corner.glsl"

layout(location = 0) out vec3 position;
layout(location = 1) out vec3 normal;
layout(location = 2) out vec3 clip_now;
layout(location = 3) out vec3 clip_before;

void main() {
    ivec2 at = terrain_corner();
    position = terrain_point(at);
    normal = terrain_normal(level_side > 0 ? level_side * terrain_tile() : at); // one for all of a plane
    gl_Position = frame.view_projection * vec4(position, 1.0);
    clip_now = gl_Position.xyw;
    clip_before = (frame.view_projection_before * vec4(position, 1.0)).xyw;
}
