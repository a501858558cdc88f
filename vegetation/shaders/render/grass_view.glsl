// What grass shows in place of its colours, for those who look into it: render::GrassView (vegetation/render/frame_block.h).
#ifndef WINDROW_RENDER_GRASS_VIEW_GLSL
#define WINDROW_RENDER_GRASS_VIEW_GLSL

#include "shaders/numerics/plant_hash.glsl"
#include "../numerics/speed_colour.glsl"

const int k_view_lean = 1, k_view_levels = 2, k_view_chunks = 3;

// Linear light, before exposure. `bend` [rad] x and z; `level` 0 near, 1 far; `morph` of a near one, 0 to 1; `slot` of its chunk.
vec3 grass_view(int view, vec2 bend, uint level, float morph, uint slot) {
    if (view == k_view_lean)
        return windrow_speed_colour(length(bend) / 1.5); // straw: laid over by 86 degrees
    if (view == k_view_levels)
        return level == 1u ? vec3(0.02, 0.09, 0.45) : mix(vec3(0.10, 0.42, 0.05), vec3(0.70, 0.42, 0.03), morph);
    uvec2 hash = windrow_plant_hash(uvec2(slot, 77u));
    return 0.08 + 0.5 * vec3(windrow_fraction(hash.x), windrow_fraction(hash.y), windrow_fraction(hash.x ^ (hash.y << 7)));
}

#endif
