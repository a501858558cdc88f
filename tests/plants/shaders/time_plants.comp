// A blade's vertex an invocation, with the bytes of copy_plants.comp: wind and height in, position and normal out.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "numerics/blade.glsl"

layout(local_size_x = 64) in;
layout(std430, set = 0, binding = 0) readonly buffer From { vec4 from[]; };
layout(std430, set = 0, binding = 1) writeonly buffer To { vec4 to[]; };
layout(std430, set = 0, binding = 2) readonly buffer Classes { WindrowBlade blade; };

void main() {
    uint n = gl_GlobalInvocationID.x;
    if (2 * n + 1 >= from.length())
        return;
    vec4 root = from[2 * n], wind = from[2 * n + 1];
    const vec3 up = vec3(0.0, 1.0, 0.0);
    uvec2 hash = windrow_plant_hash(floatBitsToUint(root.xz));
    vec3 load = windrow_blade_load(blade, up, hash, wind.xyz);
    WindrowVertex v = windrow_blade_vertex(blade, windrow_blade_plant(blade, up, hash, load, vec3(0.0, 0.0, 1.0)), wind.w, 1.0);
    to[2 * n] = vec4(root.xyz + v.position, wind.w);
    to[2 * n + 1] = vec4(v.normal, 0.0);
}
