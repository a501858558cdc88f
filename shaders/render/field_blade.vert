// A blade of a field, bent by this frame's wind; and where the same vertex was a frame ago.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "field_vertex.glsl"

layout(location = 0) out vec3 position;
layout(location = 1) out vec3 normal;
layout(location = 2) out vec3 across;
layout(location = 3) out vec4 kind; // x height 0 to 1, y side -1 to 1, z chance -1 to 1, w dryness
layout(location = 4) out vec3 clip_now;
layout(location = 5) out vec3 clip_before;

void main() {
    FieldBlade blade = field_blade();
    vec2 row = field_row(blade.traits.z);
    float least = frame.eye_before.w * smoothstep(0.0, 0.25 * grass.blade.size.x, blade.size.x); // what shrinks away may vanish
    WindrowVertex now = field_point(blade, blade.size.xy, blade.bend.xy, row, frame.eye.xyz, least);
    WindrowVertex before = field_point(blade, blade.size.zw, blade.bend.zw, field_row(blade.traits.w), frame.eye_before.xyz, least);
    position = now.position;
    normal = now.normal;
    across = cross(now.tangent, now.normal);
    kind = vec4(row, 2.0 * mix(blade.looks.x, blade.looks.z, 0.5) - 1.0, blade.root.w);
    gl_Position = frame.view_projection * vec4(position, 1.0);
    clip_now = gl_Position.xyw;
    clip_before = (frame.view_projection_before * vec4(before.position, 1.0)).xyw;
}
