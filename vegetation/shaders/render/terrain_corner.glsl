// Corners of the terrain that a draw of render::TerrainTiles names, in its vertex stages.
#ifndef WINDROW_RENDER_TERRAIN_CORNER_GLSL
#define WINDROW_RENDER_TERRAIN_CORNER_GLSL

#include "terrain.glsl"

layout(push_constant) uniform Which {
    int cascade;
    int level_side; // cells along a level tile; 0 strips
};

// Corner of a strip along a row of cells: the instance is the row, vertices go in pairs along x. The triangles of a cell meet in its
// corners (1, 0) and (0, 1), as windrow_grid_drawn_at has them.
ivec2 terrain_strip() { return ivec2(gl_VertexIndex / 2, gl_InstanceIndex + (gl_VertexIndex & 1)); }

// Tile that is level, the instance's.
ivec2 terrain_tile() {
    int across = (frame.terrain_size.x - 2) / level_side + 1;
    return ivec2(gl_InstanceIndex % across, gl_InstanceIndex / across);
}

// One of its four vertices: a cell beyond its rim, where its neighbours are in its plane.
ivec2 terrain_level() {
    ivec2 end = ivec2(gl_VertexIndex >> 1, gl_VertexIndex & 1);
    return clamp(level_side * (terrain_tile() + end) + 2 * end - 1, ivec2(0), frame.terrain_size.xy - 1);
}

ivec2 terrain_corner() { return level_side > 0 ? terrain_level() : terrain_strip(); }

#endif
