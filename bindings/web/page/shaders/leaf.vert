#version 300 es
// A corner of a card of leaves, at its twig, and its light.
#include "sway.glsl"
layout(location = 0) in vec3 at;
layout(location = 1) in vec3 face;
layout(location = 2) in vec4 which; // x twig, y limb; z along the card, 0 to 1; w across, -1 to 1
layout(location = 3) in vec4 crown_open;
layout(location = 4) in vec4 centre; // w the card's chance, -1 to 1
uniform mat4 camera;
uniform float wide; // a card's size over that of one among all
out vec4 card;      // x along, y across, z chance, w [m/s] wind
out vec3 position, normal, sun;
out vec2 shade;     // x the sky's share, y how near the crown's rim
flat out uvec2 own;

void main() {
    int twig = int(which.x), limb = int(which.y);
    WindrowPart held = tree_part(twig);
    vec3 rest = centre.xyz + wide * (at - centre.xyz);
    WindrowTreeVertex v = WindrowTreeVertex(tree_base.w * tree_turned(rest), tree_turned(face));
    vec4 sway = tree_sway(twig);
    own = windrow_plant_hash(uvec2(floatBitsToUint(centre.w), floatBitsToUint(tree_turn.z)));
    // About ten leaves of independent phases turn a card by sqrt(1 / 10) of one's turn.
    v = windrow_leaf_turned(held, 0.32 / wide * windrow_flutter_angle(flutter, flutter.now, own, sway.w), v);
    WindrowTreeLoads loads = WindrowTreeLoads(tree_sway(0).xyz, tree_sway(limb).xyz, sway.xyz / wide);
    v = windrow_tree_bent(tree, tree_part(0), tree_part(limb), held, loads, v);
    position = tree_base.xyz + v.position;
    normal = v.normal;
    card = vec4(which.zw, centre.w, sway.w);
    vec3 way = tree_turned(crown_open.xyz);
    float through_crown = clamp(crown_open.w + dot(way, sky.sun.xyz), 0.0, 1.0);
    // The shadow map has whole cards: a leaf of the rim is looked up a little outside.
    float lit = sun_fraction(position + 0.35 * tree_base.w * way / max(length(way), 0.3)) * mix(0.3, 1.0, through_crown);
    sun = sunlight.rgb * lit;
    shade = vec2(clamp(crown_open.w + 0.6 * way.y, 0.04, 1.0), clamp(crown_open.w + 0.5 * length(way), 0.0, 1.0));
    gl_Position = camera * vec4(position, 1.0);
}
