// A corner of a solid thing at its place, and where it was a frame ago.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "solid.glsl"

layout(location = 0) out vec3 position;
layout(location = 1) out vec3 normal;
layout(location = 2) out vec3 albedo;
layout(location = 3) out vec3 clip_now;
layout(location = 4) out vec3 clip_before;

void main() {
    SolidVertex vertex = solid_vertices[gl_VertexIndex];
    SolidPlace place = solid_places[gl_InstanceIndex + int(vertex.position.w)];
    position = (place.now * vec4(vertex.position.xyz, 1.0)).xyz;
    normal = mat3(place.now) * vertex.normal.xyz; // turned and moved alone
    albedo = vertex.colour.rgb;
    gl_Position = frame.view_projection * vec4(position, 1.0);
    clip_now = gl_Position.xyw;
    clip_before = (frame.view_projection_before * vec4((place.before * vec4(vertex.position.xyz, 1.0)).xyz, 1.0)).xyw;
}
