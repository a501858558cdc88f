// An outside shader: a blade, a shell and a tree in the wind of a box, this frame and the one before.
#version 460
#extension GL_GOOGLE_include_directive : require
#define WINDROW_BINDING 3
#define WINDROW_EXACT
#include "coupling/windrow_plants.glsl"

layout(local_size_x = 64) in;
layout(std430, set = 0, binding = 0) readonly buffer Places { vec4 places[]; };
layout(std430, set = 0, binding = 1) writeonly buffer Plants { vec4 plants[]; }; // blade, shell, tree; then a frame before
layout(std430, set = 0, binding = 2) readonly buffer Classes {
    WindrowBlade blade;
    WindrowShells shells;
    WindrowTree tree;
};

void main() {
    uint n = gl_GlobalInvocationID.x;
    if (n >= places.length())
        return;
    vec3 p = places[n].xyz, up = vec3(0.0, 1.0, 0.0), velocity = vec3(0.5, 0.0, -0.25), eye = vec3(0.0, 2.0, 0.0);
    uvec2 key = uvec2(n, 5u);
    WindrowPart trunk = WindrowPart(vec3(0.0), up, 8.0, 1.0);
    WindrowPart branch = WindrowPart(vec3(0.0, 2.0, 0.0), vec3(1.0, 0.0, 0.0), 2.5, 1.0);
    WindrowPart leaf = WindrowPart(vec3(1.0, 2.0, 0.0), vec3(0.0, 0.0, 1.0), 0.1, 1.0);
    WindrowTreeVertex rest = WindrowTreeVertex(vec3(1.0, 2.0, 0.1), up);

    plants[6 * n] =
        vec4(windrow_blade(blade, p, up, key, windrow_blade_bend(blade, p, up, key, velocity), eye, 1.0, 0.5).position, 0.0);
    plants[6 * n + 1] = vec4(windrow_shell(shells, p, up, 7.0, 0.8, velocity), 0.0);
    plants[6 * n + 2] = vec4(windrow_tree(tree, p, trunk, branch, leaf, rest).position, 0.0);
    plants[6 * n + 3] = vec4(
        windrow_blade(blade, p, up, key, windrow_blade_bend_previous(blade, p, up, key, velocity), eye, 1.0, 0.5).position, 0.0);
    plants[6 * n + 4] = vec4(windrow_shell_previous(shells, p, up, 7.0, 0.8, velocity), 0.0);
    plants[6 * n + 5] = vec4(windrow_tree_previous(tree, p, trunk, branch, leaf, rest).position, 0.0);
}
