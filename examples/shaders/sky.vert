// One triangle over the whole picture, and the way in which the eye looks through each pixel.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "scene.glsl"

layout(location = 0) out vec3 far_point;

void main() {
    vec2 corner = vec2((gl_VertexIndex << 1) & 2, gl_VertexIndex & 2) * 2.0 - 1.0;
    gl_Position = vec4(corner, 1.0, 1.0);
    vec4 far = inverse(scene.view_projection) * gl_Position;
    far_point = far.xyz / far.w;
}
