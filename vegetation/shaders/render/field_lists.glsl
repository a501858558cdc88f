// The lists of a field as the passes over its visible blades have them: a group a list (x: 2 * order + view) and part of it (y).
// Sets as field_blades.comp has them.
#ifndef WINDROW_RENDER_FIELD_LISTS_GLSL
#define WINDROW_RENDER_FIELD_LISTS_GLSL

#define GRASS_SET 3
#include "../grass/grass_blade.glsl"
#define FIELD_ACCESS
#include "field_blade.glsl"

layout(local_size_x = 64) in;
layout(std430, set = GRASS_SET, binding = 4) readonly buffer GrassDraws { uvec4 grass_draws[]; };
layout(std430, set = GRASS_SET, binding = 5) readonly buffer GrassOrders { ivec4 grass_orders[]; };

layout(push_constant) uniform Which { uint first_order; };

uint slot_of(uint list) { return uint(grass_orders[first_order + list / 2u].x); }

// Near and far blades of a list.
uvec2 counts_of(uint list) {
    uint draw = 2u * (2u * slot_of(list) + list % 2u);
    return uvec2(grass_draws[draw].y, grass_draws[draw + 1u].y);
}

// How many of `count` blades from `base` on there is room for.
uint room_of(uint base, uint count) {
    uint room = uint(field_blades.length());
    return min(count, room - min(base, room));
}

#endif
