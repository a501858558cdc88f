// The vertex stage of a field's blades: which blade an instance is, and where its vertices go.
//
//     #define WINDROW_SET 0                              // the wind's, windrow_wind.glsl
//     #define GRASS_SET 1                                // GrassField::layout(); default 1
//     #include "shaders/coupling/windrow_plants.glsl"        // -I the root of the repository
//     #include "vegetation/shaders/grass/grass_blade.glsl"
//     layout(push_constant) uniform Told { uvec2 grass_draw; };      // at GrassPass::push_offset; GrassField::draw pushes it
//     GrassBlade blade = grass_blade(grass_draw, gl_InstanceIndex);
//     vec3 bend = windrow_blade_bend(blade.kind, blade.root, vec3(0, 1, 0), blade.key, vec3(0.0));
//     WindrowVertex v = grass_vertex(blade, bend, gl_VertexIndex);   // [m] from the anchor
//
// Triangle strips without a vertex buffer: 15 vertices near, 5 or 7 far. For motion vectors take windrow_blade_bend_previous and
// grass_vertex_previous: what moves by itself there is the eye, on which view bend, morph and fade depend.
#ifndef GRASS_BLADE_GLSL
#define GRASS_BLADE_GLSL

#ifndef GRASS_SET
#define GRASS_SET 1
#endif

#include "../numerics/grass.glsl"

layout(std140, set = GRASS_SET, binding = 0) uniform GrassFrame { WindrowGrass grass; };
layout(std430, set = GRASS_SET, binding = 1) readonly buffer GrassBlades { vec4 grass_blades[]; };
layout(std430, set = GRASS_SET, binding = 2) readonly buffer GrassLists { uint grass_lists[]; };
layout(std430, set = GRASS_SET, binding = 3) readonly buffer GrassChunks { ivec2 grass_chunks[]; };

struct GrassBlade {
    uint place;        // number of its place among those of all slots
    vec3 root;         // [m] from the anchor
    uvec2 key;         // its own, for windrow_blade_bend
    uvec2 hash;        // of its traits: the key's, turned to face as its clump does
    WindrowBlade kind; // the class at this blade's size and distance
    int level;
    float size;  // by the mask
    float morph; // 0 a near blade, 1 one that has the far blade's shape
    vec2 clump;  // two chances that the clump shares, 0 to 1
    vec2 looks;  // two chances, 0 to 1, for colours: independent of shape, place and stiffness
};

// `told`: x slot, y level + 2 * view.
GrassBlade grass_blade_seen(uvec2 told, uint instance, vec3 eye) {
    uint side = uint(grass.cells.z);
    uint places = side * side;
    uint list = 2u * told.x + (told.y >> 1u);
    GrassBlade blade;
    blade.level = int(told.y & 1u);
    uint place = blade.level == WINDROW_GRASS_NEAR ? grass_lists[list * places + instance]
                                                   : grass_lists[(list + 1u) * places - 1u - instance];
    blade.place = told.x * places + place;
    vec4 record = grass_blades[blade.place];
    ivec2 cell = grass_chunks[told.x] * int(side) + ivec2(int(place % side), int(place / side));
    float distance = length(record.xyz - eye);
    blade.root = record.xyz + grass.corner.xyz;
    blade.key = windrow_grass_key(cell, uint(grass.cells.w), 0u);
    WindrowClump clump = windrow_grass_clump(grass, record.xz);
    blade.hash = windrow_grass_facing(grass, windrow_plant_hash(blade.key), clump);
    blade.clump = vec2(windrow_fraction(clump.chance.x * 2246822519u), windrow_fraction(clump.chance.y * 3266489917u));
    blade.kind = windrow_grass_thinned(grass, record.w, distance, windrow_grass_chance(cell, uint(grass.cells.w)));
    blade.size = record.w;
    blade.morph = windrow_grass_ramp(distance, grass.reach.x, grass.reach.y);
    uvec2 hash = windrow_plant_hash(windrow_grass_key(cell, uint(grass.cells.w), 2u));
    blade.looks = vec2(windrow_fraction(hash.x), windrow_fraction(hash.y));
    return blade;
}
GrassBlade grass_blade(uvec2 told, int instance) { return grass_blade_seen(told, uint(instance), grass.eye.xyz); }
GrassBlade grass_blade_previous(uvec2 told, int instance) { return grass_blade_seen(told, uint(instance), grass.eye_before.xyz); }

WindrowVertex grass_vertex_seen(GrassBlade blade, vec3 bend, int vertex, vec3 eye) {
    vec3 sight = blade.root - grass.corner.xyz - eye;
    vec3 view = sight / max(length(sight), 1e-6);
    vec2 row = windrow_grass_row(vertex, blade.level, int(grass.ground.w), blade.morph);
    WindrowBladePlant plant = windrow_blade_plant(blade.kind, vec3(0.0, 1.0, 0.0), blade.hash, bend, view);
    WindrowVertex made = windrow_blade_vertex(blade.kind, plant, row.x, row.y);
    made.position += blade.root;
    return made;
}
// [m] from the anchor, `bend` [rad] from windrow_blade_bend, a spring, the ground's memory.
WindrowVertex grass_vertex(GrassBlade blade, vec3 bend, int vertex) {
    return grass_vertex_seen(blade, bend, vertex, grass.eye.xyz);
}
WindrowVertex grass_vertex_previous(GrassBlade before, vec3 bend, int vertex) {
    return grass_vertex_seen(before, bend, vertex, grass.eye_before.xyz);
}

// Height on the blade of a vertex, 0 at its root, 1 at its tip: for colours.
float grass_height(GrassBlade blade, int vertex) {
    return windrow_grass_row(vertex, blade.level, int(grass.ground.w), blade.morph).x;
}

#endif
