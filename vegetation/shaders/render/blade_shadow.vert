// The blade as the sun sees it, of three rows: its shadow is as bent as itself.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame.glsl"
#include "blades.glsl"

layout(std430, set = 2, binding = 3) readonly buffer Bends { vec4 bends[]; };
layout(push_constant) uniform Which { int cascade; };

void main() {
    BladePlace place = places[gl_InstanceIndex];
    vec4 bend = bends[gl_InstanceIndex];
    vec2 where = strip_place(gl_VertexIndex, 3);
    WindrowVertex now = blade_point_of(blade_of(place), place, vec3(bend.x, 0.0, bend.y), frame.eye.xyz, where, 0.0);
    gl_Position = frame.shadow[cascade] * vec4(now.position, 1.0);
}
