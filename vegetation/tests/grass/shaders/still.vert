// Blades in an even wind of 1.5 m/s along x, each in a colour of its own: what the pictures of the tests compare.
#version 460
#extension GL_GOOGLE_include_directive : require
#define GRASS_SET 0
#include "vegetation/shaders/grass/grass_blade.glsl"

layout(push_constant) uniform Told {
    mat4 view_projection; // from the anchor
    uvec2 grass_draw;
};
layout(location = 0) out vec4 colour;

void main() {
    GrassBlade blade = grass_blade(grass_draw, gl_InstanceIndex);
    vec3 bend = windrow_blade_load(blade.kind, vec3(0.0, 1.0, 0.0), windrow_plant_hash(blade.key), vec3(1.5, 0.0, 0.0));
    WindrowVertex made = grass_vertex(blade, bend, gl_VertexIndex);
    colour = vec4(blade.looks, 0.25 + 0.75 * grass_height(blade, gl_VertexIndex), 1.0);
    gl_Position = view_projection * vec4(made.position, 1.0);
}
