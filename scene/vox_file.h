// Models of MagicaVoxel (.vox): the format that voxel editors and games exchange.
//
//     "VOX " i32 version, then chunks: 4 letters, i32 bytes of content, i32 bytes of chunks within, content, chunks.
//     MAIN   all others are within it
//     SIZE   i32 x, y, z: cells of a model; z points up
//     XYZI   i32 count, then 4 bytes a cell: x, y, z, colour from 1
//
// Colours, materials and the scene of several models are left out.
#pragma once

#include "fluid/shapes/voxel_grid.h"

#include <string>
#include <string_view>

namespace windrow::scene {

/// The model's cells, turned so that y points up: its x stays, its z becomes y, its y becomes -z. Rejects, with `name` and the
/// byte: what is no such file, chunks longer than the file, sizes beyond 256, cells outside of the model, and no model or several.
[[nodiscard]] Result<VoxelData> read_vox(std::string_view bytes, const std::string& name);

} // namespace windrow::scene
