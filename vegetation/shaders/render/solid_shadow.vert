#version 460
#extension GL_GOOGLE_include_directive : require
#include "solid.glsl"

layout(push_constant) uniform Which { int cascade; };

void main() {
    vec3 position = (solid_places[gl_InstanceIndex].now * vec4(solid_vertices[gl_VertexIndex].position.xyz, 1.0)).xyz;
    gl_Position = frame.shadow[cascade] * vec4(position, 1.0);
}
