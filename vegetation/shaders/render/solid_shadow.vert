#version 460
#extension GL_GOOGLE_include_directive : require
#include "solid.glsl"

layout(push_constant) uniform Which { int cascade; };

void main() {
    vec4 vertex = solid_vertices[gl_VertexIndex].position;
    vec3 position = (solid_places[gl_InstanceIndex + int(vertex.w)].now * vec4(vertex.xyz, 1.0)).xyz;
    gl_Position = frame.shadow[cascade] * vec4(position, 1.0);
}
