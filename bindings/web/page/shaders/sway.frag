#version 300 es
// One fragment a part of a tree: what the wind holds there, and the spring that follows it (vegetation/shaders/trees/tree_loads.comp).
#include "sway.glsl"
uniform sampler2D sway_speed, sway_target;
layout(location = 0) out vec4 now;   // xyz [rad]; w [m/s] wind
layout(location = 1) out vec4 speed; // [rad/s]
layout(location = 2) out vec4 held;  // [rad] what the wind holds

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    int n = at.y * k_row + at.x;
    now = speed = held = vec4(0.0);
    if (n >= tree_counts.x)
        return;
    WindrowPart part = tree_part(n);
    int kind = n == 0 ? 0 : n < tree_counts.y ? 1 : 2;
    WindrowDrag drag = tree.leaf;
    if (kind == 0)
        drag = tree.trunk;
    else if (kind == 1)
        drag = tree.branch;
    // Trees and twigs of one size do not swing as one.
    int band = int(windrow_plant_hash(uvec2(uint(n), floatBitsToUint(tree_turn.z))).x & 3u);
    vec3 wind = windrow_wind_on_part(tree_base.xyz, part);
    held = vec4(windrow_part_load(drag, part, wind), 0.0);
    now = vec4(held.xyz, length(wind));
    if (tree_counts.z == 1) {
        vec3 place = texelFetch(sway_now, at, 0).xyz, velocity = texelFetch(sway_speed, at, 0).xyz, before = texelFetch(sway_target, at, 0).xyz;
        WindrowSpringStep spring = springs[4 * kind + band];
        now.xyz = place + windrow_spring_place(spring, place, velocity, before, held.xyz);
        speed.xyz = velocity + windrow_spring_velocity(spring, place, velocity, before, held.xyz);
    }
}
