// Trees of one kind: set 2. The same layouts as in vegetation/trees (tree_model.h, stand_blocks.h).
//
// A vertex is that of the tree at rest, thinned out by its distance (tree_levels.glsl), turned and scaled by its place, and then
// moved by windrow_tree_bent alone. Each leaf of a card flutters (leaf_mask.glsl), and the card turns by the mean of its leaves.
#ifndef WINDROW_TREE_PARTS_GLSL
#define WINDROW_TREE_PARTS_GLSL

#include "shaders/numerics/flutter.glsl"
#include "shaders/numerics/plant_hash.glsl"
#include "shaders/numerics/spring.glsl"
#include "shaders/numerics/tree.glsl"
#include "../numerics/tree_levels.glsl"

struct TreeVertex {
    vec4 position; // xyz [m] from the trunk's base; w leaves: rank, 0 to 1; wood: radius of its stem [m]
    vec4 normal;   // xyz; w leaves: along the card, 0 to 1; wood: around the stem, 0 to 1 and back
    vec4 centre;   // xyz what it shrinks to or grows from; w leaves: across, -1 to 1; wood: [m] along the stem
    vec4 open;     // share of light from direction d: w + xyz . d
    vec4 home;     // xyz [m] leaves: from its centre to the middle of those it stands for afar; trunk: to the coarse trunk; w 0
    uvec4 parts;   // x limb, y twig, or k_no_part; z bits of a chance, -1 to 1; w bits of a card's length [m], 0: wood
};
struct TreeModelPart {
    vec4 root_reach;
    vec4 axis_stiffness;
};
struct TreePlace {
    vec4 base;   // xyz [m] from the anchor; w size
    vec4 turn;   // x, y cosine and sine of its yaw; z the tree's own chance, -1 to 1; w 0
    uvec4 first; // x its model's first part; y its first state; z parts of trunk and limbs; w 0
};
// [rad] xyz each.
struct PartState {
    vec4 now;      // bend; w bits of the number of the frame that made it
    vec4 before;   // bend of the last frame; w [m/s] wind of then
    vec4 velocity; // [rad/s]; w [m/s] wind
    vec4 target;   // what the wind holds in this frame
};

layout(std140, set = 2, binding = 0) uniform TreeClass {
    WindrowTree wind;
    WindrowTreeLevels levels;
    WindrowSpringStep trunk_spring;
    WindrowSpringStep limb_springs[4];
    WindrowSpringStep twig_springs[4];
    WindrowFlutter flutter;
    uvec4 clock;  // x number of this frame; y 1: springs; z samples a pixel; w 1: needles
    vec4 bark;    // rgb; w how far its lines go across
    vec4 furrow;  // rgb; w [m] height of the middle of a tree of size 1
    vec4 leaf;    // rgb; w spread between leaves and trees
    vec4 young;   // rgb; w exponent of the gloss
    vec4 through; // rgb; w how much more of it against the light
    // clang-format off
} kind;
// clang-format on
layout(std430, set = 2, binding = 1) readonly buffer Vertices { TreeVertex vertices[]; };
layout(std430, set = 2, binding = 2) readonly buffer Parts { TreeModelPart model_parts[]; };
layout(std430, set = 2, binding = 3) readonly buffer Places { TreePlace places[]; };
#ifdef TREE_STATES_WRITTEN
layout(std430, set = 2, binding = 4) buffer States { PartState states[]; };
#else
layout(std430, set = 2, binding = 4) readonly buffer States { PartState states[]; };
#endif

const uint k_no_part = 0xffffffffu;

vec3 tree_turned(TreePlace place, vec3 v) {
    return vec3(place.turn.x * v.x + place.turn.y * v.z, v.y, place.turn.x * v.z - place.turn.y * v.x);
}

// A part of a placed tree; k_no_part is none.
WindrowPart tree_part(TreePlace place, uint index) {
    WindrowPart part;
    part.root = vec3(0.0);
    part.axis = vec3(0.0, 1.0, 0.0);
    part.reach = 1.0;
    part.stiffness = 0.0;
    if (index == k_no_part)
        return part;
    TreeModelPart held = model_parts[place.first.x + index];
    part.root = place.base.w * tree_turned(place, held.root_reach.xyz);
    part.axis = tree_turned(place, held.axis_stiffness.xyz);
    part.reach = place.base.w * held.root_reach.w;
    part.stiffness = held.axis_stiffness.w;
    return part;
}

// [m] Of a tree of size 1 that would look as large.
float tree_distance(TreePlace place, vec3 eye) {
    vec3 middle = place.base.xyz + vec3(0.0, place.base.w * kind.furrow.w, 0.0);
    return length(eye - middle) / place.base.w;
}

bool is_leaf(TreeVertex vertex) { return vertex.parts.w != 0u; }

// Size over that of the near tree, as seen from `eye`.
float tree_scale(TreePlace place, TreeVertex vertex, vec3 eye) {
    float distance = tree_distance(place, eye);
    return is_leaf(vertex) ? windrow_leaf_scale(kind.levels, windrow_tree_keep(kind.levels, distance), vertex.position.w)
                           : windrow_stem_scale(kind.levels, distance, vertex.position.w);
}

// At rest, from the trunk's base, as seen from `eye`; `fill` is a factor on leaves' size, for what draws them as a whole.
WindrowTreeVertex tree_rest(TreePlace place, TreeVertex vertex, vec3 eye, float scale, float fill) {
    vec3 offset = vertex.position.xyz - vertex.centre.xyz;
    vec3 at = vertex.centre.xyz;
    vec3 normal = vertex.normal.xyz;
    if (is_leaf(vertex)) {
        // One that stands for many goes among them and turns its face to the eye, as far as it has grown: few cards fill a crown
        // only if none is seen on edge. Its light stays the crown's.
        float grown = smoothstep(1.2, 4.0, scale);
        vec3 way = eye - place.base.xyz - vec3(0.0, place.base.w * kind.furrow.w, 0.0);
        way /= max(length(way), 1e-3);
        vec3 to_eye = vec3(place.turn.x * way.x - place.turn.y * way.z, way.y, place.turn.y * way.x + place.turn.x * way.z);
        vec3 facing = offset - dot(offset, to_eye) * to_eye;
        offset = mix(offset, facing * (length(offset) / max(length(facing), 0.25 * length(offset))), 0.9 * grown) * fill;
        at += 0.7 * grown * vertex.home.xyz;
        normal = mix(normal, vertex.open.xyz / max(length(vertex.open.xyz), 0.05), 0.8 * grown);
    } else {
        at += windrow_trunk_morph(kind.levels, tree_distance(place, eye)) * vertex.home.xyz;
    }
    at += scale * offset;
    WindrowTreeVertex rest;
    rest.position = place.base.w * tree_turned(place, at);
    rest.normal = tree_turned(place, normal / max(length(normal), 1e-3));
    return rest;
}

PartState tree_state(TreePlace place, uint index) { return states[place.first.y + (index == k_no_part ? 0u : index)]; }

// [rad] The bends of a vertex's parts. A leaf that has grown by `scale` stands for many twigs: its own would swing it that much
// too far.
WindrowTreeLoads tree_loads(vec3 trunk, vec3 limb, vec3 twig, float scale) {
    return WindrowTreeLoads(trunk, limb, twig / max(scale, 1.0));
}

// A card has about ten leaves with independent phases, so its own turn is smaller by sqrt(1 / 10). A card that replaces several has
// more leaves.
const float k_turned_by_leaves = 0.32;

uvec2 tree_leaf_hash(TreePlace place, TreeVertex vertex) {
    return windrow_plant_hash(uvec2(vertex.parts.z, floatBitsToUint(place.turn.z)));
}

WindrowTreeVertex tree_turned_leaf(TreePlace place, TreeVertex vertex, float scale, vec4 phases, float speed,
                                   WindrowTreeVertex rest) {
    if (!is_leaf(vertex) || vertex.parts.y == k_no_part || !(kind.flutter.motion.x > 0.0))
        return rest;
    float angle =
        k_turned_by_leaves / max(scale, 1.0) * windrow_flutter_angle(kind.flutter, phases, tree_leaf_hash(place, vertex), speed);
    return windrow_leaf_turned(tree_part(place, vertex.parts.y), angle, rest);
}

// In this frame's wind and in the last one's, from the trunk's base; `scale` as tree_rest had it.
WindrowTreeVertex tree_point(TreePlace place, TreeVertex vertex, WindrowTreeVertex rest, float scale) {
    WindrowTreeLoads loads = tree_loads(tree_state(place, 0u).now.xyz, tree_state(place, vertex.parts.x).now.xyz,
                                        tree_state(place, vertex.parts.y).now.xyz, scale);
    rest = tree_turned_leaf(place, vertex, scale, kind.flutter.now, tree_state(place, vertex.parts.y).velocity.w, rest);
    return windrow_tree_bent(kind.wind, tree_part(place, 0u), tree_part(place, vertex.parts.x), tree_part(place, vertex.parts.y),
                             loads, rest);
}
WindrowTreeVertex tree_point_before(TreePlace place, TreeVertex vertex, WindrowTreeVertex rest, float scale) {
    WindrowTreeLoads loads = tree_loads(tree_state(place, 0u).before.xyz, tree_state(place, vertex.parts.x).before.xyz,
                                        tree_state(place, vertex.parts.y).before.xyz, scale);
    rest = tree_turned_leaf(place, vertex, scale, kind.flutter.before, tree_state(place, vertex.parts.y).before.w, rest);
    return windrow_tree_bent(kind.wind, tree_part(place, 0u), tree_part(place, vertex.parts.x), tree_part(place, vertex.parts.y),
                             loads, rest);
}

#endif
