// The plants of the page: their class, springs and look, and where the blades of a level stand. A level is a square of cells around
// the middle of the view that wraps: a cell keeps its texel while the square moves.
#include "page.glsl"
#include "shaders/coupling/windrow_plants.glsl"
#include "vegetation/shaders/numerics/grass.glsl"
#include "vegetation/shaders/render/grass_light.glsl"

layout(std140) uniform Plants {
    WindrowBlade blade_class;
    WindrowSwingStep swing_steps[4];
    PlantLook look;
    vec4 clumps; // x [1/m] clumps a metre; shares: y less height, z one way to face, w outward
    vec4 patches; // x [1/m] patches a metre, y share of less height
};

ivec2 cell_in(int n, ivec2 lowest, ivec2 slot) {
    ivec2 off = (slot - lowest) % n;
    return lowest + off + n * ivec2(lessThan(off, ivec2(0)));
}
uint seed_of(int k) { return uint(cells.w + 31 * k); }
vec2 place_of(int k, ivec2 cell) { return windrow_grass_place(cell, 1.0 / level[k].x, 0.9, seed_of(k)); }

// Share of a blade's size that its level has there: coarser levels begin where finer ones end.
float level_share(int k, vec2 place) {
    vec2 off = abs(place - middle.xy);
    float far_off = max(off.x, off.y);
    float share = 1.0 - windrow_grass_ramp(far_off, level[k].y, level[k].z);
    if (k > 0)
        share *= windrow_grass_ramp(far_off, 0.7 * level[k - 1].y, level[k - 1].y); // full before the finer one fades
    return share;
}
WindrowClump clump_of(vec2 place) { return windrow_clump((place + 512.0) * clumps.x, uvec2(3u, 17u)); }
