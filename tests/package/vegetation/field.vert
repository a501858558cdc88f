// A host's own vertex stage for a grass field, with installed includes alone.
#version 450
#extension GL_GOOGLE_include_directive : require
#define WINDROW_SET 0
#define GRASS_SET 1
#include "shaders/coupling/windrow_plants.glsl"
#include "vegetation/shaders/grass/grass_blade.glsl"

layout(push_constant) uniform Draw {
    mat4 view_projection;
    uvec2 grass_draw;
};

void main() {
    const GrassBlade blade = grass_blade(grass_draw, gl_InstanceIndex);
    const vec3 bend = windrow_blade_bend(blade.kind, blade.root, vec3(0.0, 1.0, 0.0), blade.key, vec3(0.0));
    const WindrowVertex v = grass_vertex(blade, bend, gl_VertexIndex);
    gl_Position = view_projection * vec4(v.position, 1.0);
}
