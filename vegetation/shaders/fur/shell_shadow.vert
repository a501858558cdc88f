// A layer of the coat as the sun sees it: fewer layers than the eye has, of the same strands.
#version 460
#extension GL_GOOGLE_include_directive : require
#define WINDROW_SET 1
#include "shaders/coupling/windrow_plants.glsl"
#include "../render/frame.glsl"
#include "coat.glsl"
#include "shell_vertex.glsl"

layout(location = 0) out vec4 rest;
layout(location = 1) out vec3 rest_normal;
layout(location = 2) out vec2 uv;

layout(push_constant) uniform Which { int cascade; };

void main() {
    int all = max(coat.layers.w, 1);
    int layer = all - 1 - gl_InstanceIndex;
    float height = all > 1 ? layer_height(layer, float(all - 1)) : 0.0;
    CoatVertex vertex = vertices[gl_VertexIndex];
    ShellPlace now = shell_place(skins[coat.counts.y + gl_VertexIndex], height, skins[coat.counts.y + gl_VertexIndex].load.xyz);
    rest = vec4(vertex.position.xyz, height);
    rest_normal = vertex.normal.xyz;
    uv = vec2(vertex.position.w, vertex.normal.w);
    gl_Position = frame.shadow[cascade] * vec4(now.position, 1.0);
}
