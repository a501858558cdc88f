// A field's blade as the sun sees it: its shadow is as bent as itself.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "field_vertex.glsl"

void main() {
    FieldBlade blade = field_blade();
    WindrowVertex now = field_point(blade, blade.size.xy, blade.bend.xy, field_row(blade.traits.z), frame.eye.xyz, 0.0);
    gl_Position = frame.shadow[cascade] * vec4(now.position, 1.0);
}
