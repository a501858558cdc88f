// Makes the blades of a chunk, an invocation a place: x of the group along the places, y along the chunks to make.
#version 460
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 128) in;
#include "../grass/field.glsl"

void main() {
    uint place = gl_GlobalInvocationID.x;
    if (place >= places_of_a_chunk())
        return;
    ivec4 order = orders[first_order + gl_WorkGroupID.y];
    int side = grass.cells.z;
    ivec2 cell = order.yz * side + ivec2(int(place) % side, int(place) / side);
    vec4 blade = vec4(0.0);
    if (cell.x < grass.cells.x && cell.y < grass.cells.y) {
        vec2 p = windrow_grass_place(cell, grass.ground.x, grass.ground.y, uint(grass.cells.w));
        float alpha = windrow_grid_at(k_mask, WindrowGrid(grass.corners.zw, grass.spacing.zw), p);
        WindrowGrid ground = WindrowGrid(grass.corners.xy, grass.spacing.xy);
        float height = min(windrow_grid_at(k_heights, ground, p), windrow_grid_drawn_at(k_heights, ground, p)); // no root floats
        blade = vec4(p.x, height, p.y, windrow_grass_size(alpha) * windrow_grass_growth(grass, p));
    }
    blades[uint(order.x) * places_of_a_chunk() + place] = blade;
    if (place == 0u)
        chunks[order.x] = order.yz;
}
