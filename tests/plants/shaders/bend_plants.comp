// The plants' text on the device: what bend_case of gpu_test.cpp computes on the CPU.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "numerics/blade.glsl"
#include "numerics/shell.glsl"
#include "numerics/strand.glsl"
#include "numerics/tree.glsl"

struct Case {
    vec4 wind;  // w h
    vec4 axis;  // w side
    vec4 view;  // w map
    vec4 place; // w p of the droop: its logarithm
    uvec4 key;
};
struct Answer {
    uvec4 chance; // hash, bits of yaw and factor
    vec4 blade_load, blade_position, blade_normal, blade_tangent;
    vec4 shell_load, shell_bent, shell_translated;
    vec4 tree_position, tree_normal;
    vec4 masks, strand;
};

layout(local_size_x = 64) in;
layout(std430, set = 0, binding = 0) readonly buffer Cases { Case cases[]; };
layout(std430, set = 0, binding = 1) writeonly buffer Answers { Answer answers[]; };
layout(std430, set = 0, binding = 2) readonly buffer Classes {
    WindrowBlade blade;
    WindrowShells shells;
    WindrowTree tree;
};

void main() {
    uint n = gl_GlobalInvocationID.x;
    if (n >= cases.length())
        return;
    Case c = cases[n];
    float h = c.wind.w;
    uvec2 hash = windrow_plant_hash(c.key.xy);
    Answer a;
    a.chance = uvec4(hash, floatBitsToUint(windrow_plant_yaw(hash)), floatBitsToUint(windrow_plant_factor(hash, 0.5)));

    vec3 load = windrow_blade_load(blade, c.axis.xyz, hash, c.wind.xyz);
    WindrowVertex v = windrow_blade_vertex(blade, windrow_blade_plant(blade, c.axis.xyz, hash, load, c.view.xyz), h, c.axis.w);
    a.blade_load = vec4(load, 0.0);
    a.blade_position = vec4(v.position, 0.0);
    a.blade_normal = vec4(v.normal, 0.0);
    a.blade_tangent = vec4(v.tangent, 0.0);

    vec3 strand = windrow_shell_load(shells, c.view.xyz, c.view.w, c.wind.xyz);
    a.shell_load = vec4(strand, 0.0);
    a.shell_bent = vec4(windrow_shell_bent(shells, c.place.xyz, c.view.xyz, h, c.view.w, strand), 0.0);
    a.shell_translated = vec4(windrow_shell_translated(shells, c.place.xyz, c.view.xyz, h, c.view.w, c.wind.xyz), 0.0);

    WindrowPart trunk = WindrowPart(vec3(0.0), vec3(0.0, 1.0, 0.0), 8.0, 1.0);
    WindrowPart branch = WindrowPart(vec3(0.0, 5.0, 0.0), c.view.xyz, 2.5, 0.5);
    WindrowPart leaf = WindrowPart(vec3(0.0, 5.0, 0.0) + 2.0 * c.view.xyz, c.axis.xyz, 0.1, 1.5);
    WindrowTreeVertex t = windrow_tree_vertex(tree, trunk, branch, leaf, c.wind.xyz,
                                              WindrowTreeVertex(leaf.root + 0.1 * h * leaf.axis, c.view.xyz));
    a.tree_position = vec4(t.position, 0.0);
    a.tree_normal = vec4(t.normal, 0.0);

    a.masks =
        vec4(windrow_mask_power(h, 2.5), windrow_mask_own(h, 0.5), windrow_mask_drag(h, 1.5), windrow_mask_droop(h, c.place.w));
    a.strand = vec4(windrow_strand_lean(load.xz, h, 1.5), windrow_radial_load(c.place.xz, 1.0, 1.2));
    answers[n] = a;
}
