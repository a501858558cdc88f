// What shaders of a coat are told: set 2. The same layouts as in vegetation/fur/coat_block.h, which says more of each field.
#ifndef WINDROW_SHELLS_COAT_GLSL
#define WINDROW_SHELLS_COAT_GLSL

#include "shaders/numerics/cascade.glsl"
#include "../numerics/coat_lean.glsl"
#include "../numerics/cloud_shells.glsl"
#include "../numerics/strand_field.glsl"

struct CoatSpot {
    vec4 from; // xyz [m] in the mesh's space; w radius
    vec4 to;   // xyz; w [m] width of the soft edge
    vec4 tint; // rgb; w share
    vec4 more; // x length; y glow
};
struct CoatFoot {
    vec4 place;  // xyz [m] from the anchor; w radius
    vec4 weight; // x
};
struct CoatLamp {
    vec4 place;  // xyz [m] from the anchor; w reach
    vec4 colour; // rgb irradiance at 1 m
};

layout(std140, set = 2, binding = 0) uniform Coat {
    WindrowShells shells;
    WindrowStrandField field;
    // x divisor of a layer's number; y [m] strands' length over the mesh's metres; z wind share; w the animated cells' time [s]
    vec4 levels;
    ivec4 counts;   // x vertices; y, z first entry of this and of the last frame's skin; w stages of the cascade
    ivec4 layers;   // x drawn; y 1: outer first; z 1: mirrored; w all layers of the shadow
    ivec4 form;     // x 1: translated; y WindAt; z 1: strands by the surface, 0: by uv; w 1: bare
    ivec4 drawing;  // x march; y samples a pixel; z spots; w lamps
    vec4 comb;      // xyz direction in the mesh's space; w [rad] bend
    vec4 tousle;    // x [rad]; y 1 / [m]; z 1 / [s] of the last frame, 0: no velocity; w bald_below
    vec4 root;      // rgb; w power of root to tip
    vec4 tip;       // rgb; w variation
    vec4 second;    // rgb; w 1 / [m] of patches
    vec4 skin;      // rgb; w bias of the occlusion
    vec4 light;     // x occlusion exponent; y wrap; z gloss; w its power
    vec4 sheen;     // x sheen; y its power; z through; w strand normals
    vec4 cel;       // x levels; y square normals; z 1: a cloud in place of strands; w 0
    vec4 drift;     // xy [m] along x and z of the mesh by which the strands have gone; z, w feet now and before
    vec4 low;       // xyz corner of the mesh's box; w Projection
    vec4 extent;    // xyz 1 / its size; w noise tiles
    vec4 influence; // x, y of the noise pictures; z [rad] push of feet; w 1: exact normals
    WindrowCloudShells cloud;
    ivec4 pictures[4]; // length, colour, noise a, noise b: x first texel; y columns; z rows; w levels, 0: none
    CoatSpot spots[24];
    CoatLamp lamps[8];
    CoatFoot feet[8];
    CoatFoot feet_before[8];
    ivec4 ahead; // x the pose of a moment later; y its first bone; z 1: there is one
    vec4 gone;   // xyz [m] in the world that the pattern has gone since the last frame; w 1 / [s] of that moment
    // clang-format off
} coat;
// clang-format on

struct CoatVertex {
    vec4 position; // xyz [m] at rest in the mesh's space; w u
    vec4 normal;   // xyz; w v
    uvec4 bones;
    vec4 weights;
};
// A vertex in the body's pose, [m] from the anchor.
struct CoatSkin {
    vec4 position; // xyz; w share of the strands' length there
    vec4 normal;   // xyz unit; w 0
    vec4 load;     // [rad] xyz; w fraction of the length that the body's own skin leaves no room for
    vec4 own;      // [rad] xyz the comb's bend; w fraction of the lean that it leaves no room for
    vec4 lag;      // [m] xyz across the normal; w 0
    vec4 lag_more;
    vec4 velocity; // [m/s] xyz; w 0
};

layout(std430, set = 2, binding = 1) readonly buffer CoatVertices { CoatVertex vertices[]; };
#ifdef COAT_SKIN_WRITTEN
layout(std430, set = 2, binding = 2) buffer CoatSkins { CoatSkin skins[]; };
#else
layout(std430, set = 2, binding = 2) readonly buffer CoatSkins { CoatSkin skins[]; };
#endif
layout(std430, set = 2, binding = 3) readonly buffer CoatPoses { WindrowPose poses[]; };
layout(std430, set = 2, binding = 4) readonly buffer CoatBones { mat4 bones[]; };
layout(std430, set = 2, binding = 5) readonly buffer CoatTexels { uvec2 texels[]; }; // four halves each

// [rad] What feet do to a strand on the skin at p, this frame and the one before; n the unit normal there.
vec3 feet_on(vec3 p, vec3 n) {
    vec3 load = vec3(0.0);
    for (int foot = 0; foot < int(coat.drift.z); ++foot)
        load += windrow_foot_load(coat.feet[foot].place, coat.influence.z * coat.feet[foot].weight.x, coat.shells.form.x, p, n);
    return load;
}
vec3 feet_on_before(vec3 p, vec3 n) {
    vec3 load = vec3(0.0);
    for (int foot = 0; foot < int(coat.drift.w); ++foot)
        load += windrow_foot_load(coat.feet_before[foot].place, coat.influence.z * coat.feet_before[foot].weight.x,
                                  coat.shells.form.x, p, n);
    return load;
}

const int k_wind_at_strand = 0;
const int k_wind_at_shell = 1;
const int k_wind_at_pixel = 2;

#endif
