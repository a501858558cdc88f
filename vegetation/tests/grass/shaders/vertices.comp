// The vertex stage's own functions in a compute pass: every vertex of a list, in an even wind of 6 m/s.
#version 460
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 64) in;
#define GRASS_SET 0
#include "vegetation/shaders/grass/grass_blade.glsl"

layout(std430, set = 1, binding = 0) writeonly buffer Vertices { vec4 vertices[]; }; // position and normal, 15 an instance
layout(push_constant) uniform Told {
    uvec2 grass_draw;
    uint instances;
};

void main() {
    uint instance = gl_GlobalInvocationID.x;
    if (instance >= instances)
        return;
    GrassBlade blade = grass_blade(grass_draw, int(instance));
    vec3 bend = windrow_blade_load(blade.kind, vec3(0.0, 1.0, 0.0), windrow_plant_hash(blade.key), vec3(6.0, 0.0, 0.0));
    for (int vertex = 0; vertex < 15; ++vertex) {
        WindrowVertex made = grass_vertex(blade, bend, vertex);
        uint at = 2u * (15u * instance + uint(vertex));
        vertices[at] = vec4(made.position, grass_height(blade, vertex));
        vertices[at + 1u] = vec4(made.normal, blade.morph);
    }
}
