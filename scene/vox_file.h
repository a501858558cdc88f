// Models of MagicaVoxel (.vox): the format that voxel editors and games exchange.
//
//     "VOX " i32 version, then chunks: 4 letters, i32 bytes of content, i32 bytes of chunks within, content, chunks.
//     MAIN   all others are within it
//     SIZE   i32 x, y, z: cells of a model; z points up
//     XYZI   i32 count, then 4 bytes a cell: x, y, z, colour from 1
//     nTRN, nGRP, nSHP   nodes of the editor's scene: how models are turned, mirrored and placed there
//
// Colours and materials are left out, and where the whole stands in the editor's scene: an obstacle has a place of its own.
#pragma once

#include "fluid/shapes/voxel_grid.h"

#include <string>
#include <string_view>

namespace windrow::scene {

/// The cells of all models that are not hidden, turned and placed as in the editor's scene, in the box that holds the models; then so
/// that y points up: x stays, z becomes y, y becomes -z. Of an animation the first frame. Rejects, with `name` and the byte: what is no
/// such file, chunks and nodes longer than the file, sizes beyond 256, cells outside of their model, no model, models that no scene
/// places, and scenes larger than a VoxelGrid.
[[nodiscard]] Result<VoxelData> read_vox(std::string_view bytes, const std::string& name);

} // namespace windrow::scene
