#version 300 es
#include "sway.glsl"
layout(location = 0) in vec3 at;
layout(location = 1) in vec3 beside;
layout(location = 2) in vec4 stem; // x around, 0 to 1 and back; y [m] along; z [m] radius; w limb, -1 none
layout(location = 3) in vec4 crown_open;
uniform mat4 camera;
out vec3 position, normal, wood;
out vec4 open;

void main() {
    int limb = int(stem.w) < 0 ? -1 : 1 + int(stem.w);
    WindrowTreeVertex v = WindrowTreeVertex(tree_base.w * tree_turned(at), tree_turned(beside));
    WindrowTreeLoads loads = WindrowTreeLoads(tree_sway(0).xyz, tree_sway(limb).xyz, vec3(0.0));
    v = windrow_tree_bent(tree, tree_part(0), tree_part(limb), tree_part(-1), loads, v);
    position = tree_base.xyz + v.position;
    normal = v.normal;
    wood = stem.xyz;
    open = vec4(tree_turned(crown_open.xyz), crown_open.w);
    gl_Position = camera * vec4(position, 1.0);
}
