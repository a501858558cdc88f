// A blade, bent by this frame's wind; and where the same vertex was a frame ago.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame.glsl"
#include "blades.glsl"

layout(std430, set = 2, binding = 3) readonly buffer Bends { vec4 bends[]; };

layout(location = 0) out vec3 position;
layout(location = 1) out vec3 normal;
layout(location = 2) out vec3 across;
layout(location = 3) out vec4 kind; // x height 0 to 1, y side -1 to 1, z chance -1 to 1, w dryness
layout(location = 4) out vec3 clip_now;
layout(location = 5) out vec3 clip_before;

void main() {
    BladePlace place = places[gl_InstanceIndex];
    WindrowBlade blade = blade_of(place);
    vec4 bend = bends[gl_InstanceIndex];
    vec2 where = strip_place(gl_VertexIndex, k_rows);

    WindrowVertex now = blade_point_of(blade, place, vec3(bend.x, 0.0, bend.y), frame.eye.xyz, where, frame.eye_before.w);
    WindrowVertex before =
        blade_point_of(blade, place, vec3(bend.z, 0.0, bend.w), frame.eye_before.xyz, where, frame.eye_before.w);
    position = now.position;
    normal = now.normal;
    across = cross(now.tangent, now.normal);
    kind = vec4(where, windrow_plant_chance(windrow_plant_hash(place.key.xy)), uintBitsToFloat(place.key.z));
    gl_Position = frame.view_projection * vec4(position, 1.0);
    clip_now = gl_Position.xyw;
    clip_before = (frame.view_projection_before * vec4(before.position, 1.0)).xyw;
}
