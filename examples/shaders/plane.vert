// One triangle over the whole picture, which shows a level plane of air from above.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "plane.glsl"

layout(location = 0) out vec2 place; // [m] x and z from the middle

void main() {
    vec2 corner = vec2((gl_VertexIndex << 1) & 2, gl_VertexIndex & 2) * 2.0 - 1.0;
    place = corner * plane.half_size;
    gl_Position = vec4(corner, 0.0, 1.0);
}
