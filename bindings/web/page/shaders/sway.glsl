// A tree of the page: its class, springs and place, and its parts in texels (trees.js).
#include "page.glsl"
#include "shaders/coupling/windrow_plants.glsl"

layout(std140) uniform Tree {
    WindrowTree tree;
    WindrowSpringStep springs[12]; // four bands each: trunk, limbs, twigs
    WindrowFlutter flutter;
    vec4 tree_base;     // xyz [m]; w size
    vec4 tree_turn;     // x, y cosine and sine of its yaw; z its own chance, -1 to 1
    ivec4 tree_counts;  // x parts, y of them trunk and limbs; z 1: springs go on; w 1: needles
    vec4 bark;     // rgb; w how far its lines go across
    vec4 furrow;   // rgb
    vec4 leaf;     // rgb; w spread between leaves and trees
    vec4 young;    // rgb; w exponent of the gloss
    vec4 through;  // rgb; w how much more of it against the light
};
uniform sampler2D places;   // of parts, two texels each
uniform sampler2D sway_now; // xyz [rad] bend of a part, w [m/s] wind at it

const int k_row = 64;

vec3 tree_turned(vec3 v) { return vec3(tree_turn.x * v.x + tree_turn.y * v.z, v.y, tree_turn.x * v.z - tree_turn.y * v.x); }

// A part of the placed tree; below 0 is none.
WindrowPart tree_part(int index) {
    WindrowPart part = WindrowPart(vec3(0.0), vec3(0.0, 1.0, 0.0), 1.0, 0.0);
    if (index < 0)
        return part;
    ivec2 at = ivec2(2 * (index % k_row), index / k_row);
    vec4 root = texelFetch(places, at, 0), axis = texelFetch(places, at + ivec2(1, 0), 0);
    return WindrowPart(tree_base.w * tree_turned(root.xyz), tree_turned(axis.xyz), tree_base.w * root.w, axis.w);
}
vec4 tree_sway(int index) {
    int n = max(index, 0);
    return texelFetch(sway_now, ivec2(n % k_row, n / k_row), 0);
}
