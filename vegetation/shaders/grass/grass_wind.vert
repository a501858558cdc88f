// Blades in the wind, with what a fragment needs for colour and light. Windrow's set is 0, the field's 1.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shaders/coupling/windrow_plants.glsl"
#include "../grass/grass_blade.glsl"

layout(push_constant) uniform Told {
    mat4 view_projection; // from the anchor
    uvec2 grass_draw;     // GrassPass::push_offset is 64
};

layout(location = 0) out vec3 position; // [m] from the anchor
layout(location = 1) out vec3 normal;
layout(location = 2) out vec4 look; // x height on the blade, 0 to 1; y size by the mask; zw two chances

void main() {
    GrassBlade blade = grass_blade(grass_draw, gl_InstanceIndex);
    vec3 bend = windrow_blade_bend(blade.kind, blade.root, vec3(0.0, 1.0, 0.0), blade.key, vec3(0.0));
    WindrowVertex made = grass_vertex(blade, bend, gl_VertexIndex);
    position = made.position;
    normal = made.normal;
    look = vec4(grass_height(blade, gl_VertexIndex), blade.size, blade.looks);
    gl_Position = view_projection * vec4(made.position, 1.0);
}
