// What the passes of a field share: its block, its buffers, and where a chunk's part of them lies.
//
//   slot s, n places of a chunk     blades[s n + i]                     records, i = z * side + x within the chunk
//                                   lists[(2 s + view) n ...]           near blades from the front, far ones from the back
//                                   draws[(2 s + view) 2 + level]       VkDrawIndirectCommand
#ifndef GRASS_FIELD_GLSL
#define GRASS_FIELD_GLSL

#define WINDROW_GRID int
float windrow_grid_value(int grid, ivec2 corner, int across);

#include "../numerics/grass.glsl"
#include "shaders/numerics/height_grid.glsl"

layout(std140, set = 0, binding = 0) uniform Frame { WindrowGrass grass; };
layout(std430, set = 0, binding = 1) buffer Blades { vec4 blades[]; };
layout(std430, set = 0, binding = 2) buffer Lists { uint lists[]; };
layout(std430, set = 0, binding = 3) buffer Chunks { ivec2 chunks[]; }; // which chunk a slot holds
layout(std430, set = 0, binding = 4) writeonly buffer Draws { uvec4 draws[]; };
layout(std430, set = 0, binding = 5) readonly buffer Orders { ivec4 orders[]; }; // x slot; yz chunk, or y views as bits
layout(std430, set = 0, binding = 6) readonly buffer Heights { float heights[]; };
layout(std430, set = 0, binding = 7) readonly buffer Mask { float mask[]; };

layout(push_constant) uniform Told { uint first_order; };

const int k_heights = 0;
const int k_mask = 1;

float windrow_grid_value(int grid, ivec2 corner, int across) {
    int at = corner.y * across + corner.x;
    return grid == k_heights ? heights[at] : mask[at];
}

uint places_of_a_chunk() { return uint(grass.cells.z * grass.cells.z); }

#endif
