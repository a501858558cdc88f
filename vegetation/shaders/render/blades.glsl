// Blades that a host has placed: set 2. The same layouts as in vegetation/render/blades.h.
#ifndef WINDROW_RENDER_BLADES_GLSL
#define WINDROW_RENDER_BLADES_GLSL

#include "shaders/numerics/blade.glsl"
#include "blade_width.glsl"
#include "plant_look.glsl"

struct BladePlace {
    vec4 root; // xyz [m] from the anchor; w factor on length and width
    uvec4 key; // xy the plant's key; z bits of how dry its place is, 0 to 1; w bits of the factor on its width alone
};

layout(std140, set = 2, binding = 0) uniform Look { PlantLook look; };
layout(std140, set = 2, binding = 1) uniform Class { WindrowBlade blade_class; };
layout(std430, set = 2, binding = 2) readonly buffer Places { BladePlace places[]; };

// The class at the size of this place.
WindrowBlade blade_of(BladePlace place) {
    WindrowBlade blade = blade_class;
    blade.size.x *= place.root.w;
    blade.size.z *= place.root.w * uintBitsToFloat(place.key.w);
    return blade;
}

const int k_rows = 5; // rows of two vertices, and one at the tip

// Height and side of a vertex of the strip: k_rows rows below the tip.
vec2 strip_place(int vertex, int rows) {
    float h = float(vertex / 2) / float(rows);
    float side = vertex == 2 * rows ? 0.0 : (vertex & 1) == 0 ? -1.0 : 1.0;
    return vec2(h, side);
}

// A vertex of the blade, [m] from the anchor; `least` as in blade_width.glsl.
WindrowVertex blade_point_of(WindrowBlade blade, BladePlace place, vec3 bend, vec3 eye, vec2 where, float least) {
    vec3 sight = place.root.xyz - eye;
    vec3 view = sight / max(length(sight), 1e-6);
    const vec3 up = vec3(0.0, 1.0, 0.0);
    WindrowBladePlant plant = windrow_blade_plant(blade, up, windrow_plant_hash(place.key.xy), bend, view);
    WindrowVertex vertex = windrow_blade_vertex(blade, plant, where.x, where.y);
    vertex.position += place.root.xyz;
    return wide_enough(vertex, where.y, windrow_blade_half_width(blade, where.x), eye, least);
}

#endif
