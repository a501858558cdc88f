// The terrain as the sun sees it.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "terrain.glsl"

layout(push_constant) uniform Which { int cascade; };

void main() {
    int corner = gl_VertexIndex % 6;
    ivec2 at = ivec2(gl_VertexIndex / 6, gl_InstanceIndex);
    at += ivec2(corner == 1 || corner == 3 || corner == 4 ? 1 : 0, corner == 2 || corner == 4 || corner == 5 ? 1 : 0);
    gl_Position = frame.shadow[cascade] * vec4(terrain_point(at), 1.0);
}
