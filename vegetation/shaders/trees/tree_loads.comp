// The bend of each part of each tree that is seen, once a frame: what the wind holds at the part's own place, or a spring that
// follows it.
#version 460
#extension GL_GOOGLE_include_directive : require
#define WINDROW_SET 1
#define TREE_STATES_WRITTEN
#include "shaders/coupling/windrow_plants.glsl"
#include "tree_parts.glsl"

layout(local_size_x = 64) in;
// one a group: x tree, y its first part, z end of the parts that the tree needs
layout(std430, set = 2, binding = 5) readonly buffer Jobs { uvec4 jobs[]; };

void main() {
    uvec4 job = jobs[gl_WorkGroupID.x];
    uint n = job.y + gl_LocalInvocationID.x;
    if (n >= job.z)
        return;
    TreePlace place = places[job.x];
    WindrowPart part = tree_part(place, n);
    WindrowDrag drag = kind.wind.leaf;
    uint band = windrow_plant_hash(uvec2(place.first.y + n, 0u)).x & 3u; // trees and twigs of one size do not swing as one
    WindrowSpringStep spring = kind.twig_springs[band];
    if (n == 0u) {
        drag = kind.wind.trunk;
        spring = kind.trunk_spring;
    } else if (n < place.first.z) {
        drag = kind.wind.branch;
        spring = kind.limb_springs[band];
    }
    vec3 wind = windrow_wind_on_part(place.base.xyz, part);
    vec3 target = windrow_part_load(drag, part, wind);
    PartState state = states[place.first.y + n];
    // A part that was not drawn in the last frame has no motion to go on with.
    bool goes_on = kind.clock.y == 1u && floatBitsToUint(state.now.w) + 1u == kind.clock.x;
    if (goes_on) {
        vec3 place_gain = windrow_spring_place(spring, state.now.xyz, state.velocity.xyz, state.target.xyz, target);
        vec3 velocity_gain = windrow_spring_velocity(spring, state.now.xyz, state.velocity.xyz, state.target.xyz, target);
        state.before = vec4(state.now.xyz, state.velocity.w);
        state.now.xyz += place_gain;
        state.velocity.xyz += velocity_gain;
    } else {
        vec3 wind_before = windrow_wind_on_part_previous(place.base.xyz, part);
        state.before = vec4(windrow_part_load(drag, part, wind_before), length(wind_before));
        state.now.xyz = target;
        state.velocity = vec4(0.0);
    }
    state.velocity.w = length(wind);
    state.target.xyz = target;
    state.now.w = uintBitsToFloat(kind.clock.x);
    states[place.first.y + n] = state;
}
