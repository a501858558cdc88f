// The bend of each blade in this frame's wind and in the last one's, once a blade: its vertices, and its shadow, read it.
#version 460
#extension GL_GOOGLE_include_directive : require
#define WINDROW_SET 1
#include "shaders/coupling/windrow_plants.glsl"
#include "blades.glsl"

layout(local_size_x = 64) in;
layout(std430, set = 2, binding = 3) writeonly buffer Bends { vec4 bends[]; }; // x, z of this frame, x, z of the last

layout(push_constant) uniform Count { uint blade_count; };

void main() {
    uint n = gl_GlobalInvocationID.x;
    if (n >= blade_count)
        return;
    BladePlace place = places[n];
    WindrowBlade blade = blade_of(place);
    const vec3 up = vec3(0.0, 1.0, 0.0);
    vec3 now = windrow_blade_bend(blade, place.root.xyz, up, place.key.xy, vec3(0.0));
    vec3 before = windrow_blade_bend_previous(blade, place.root.xyz, up, place.key.xy, vec3(0.0));
    bends[n] = vec4(now.xz, before.xz);
}
