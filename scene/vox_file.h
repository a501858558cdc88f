// Models of MagicaVoxel (.vox): the format that voxel editors and games exchange.
//
//     "VOX " i32 version, then chunks: 4 letters, i32 bytes of content, i32 bytes of chunks within, content, chunks.
//     MAIN   all others are within it
//     SIZE   i32 x, y, z: cells of a model; z points up
//     XYZI   i32 count, then 4 bytes a cell: x, y, z, colour from 1
//     nTRN, nGRP, nSHP   nodes of the editor's scene: how the model is turned and mirrored there
//
// Colours and materials are left out, and the model's place in the editor's scene: an obstacle has its own.
#pragma once

#include "fluid/shapes/voxel_grid.h"

#include <string>
#include <string_view>

namespace windrow::scene {

/// The model's cells as they are turned in the editor's scene, then so that y points up: its x stays, its z becomes y, its y becomes
/// -z. Rejects, with `name` and the byte: what is no such file, chunks and nodes longer than the file, sizes beyond 256, cells outside
/// of the model, and no model or several, or one that stands at several places.
[[nodiscard]] Result<VoxelData> read_vox(std::string_view bytes, const std::string& name);

} // namespace windrow::scene
