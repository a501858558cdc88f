// The chunks of a 3DS file, checked before Assimp sees them.
//
//     4D4D main > 3D3D editor > AFFF material > A000 name
//                             > 4000 object (name, then) > 4100 mesh > 4110 vertices, 4120 faces > 4130 faces of a material
//                                                                    > 4140 uv
//
// Each chunk is a kind [2 bytes], its length with all that is in it [4], its content; little-endian. All other chunks, such as
// colours, cameras, key frames and the frames of meshes (vertices stand in the world already), are made a kind that no reader
// knows, and are stepped over. Based on: the chunks as the files themselves and Pitts 1994, The 3D Studio file format, have them.
#pragma once

#include "vegetation/fur/mesh.h"

#include <string>

namespace windrow::vegetation::fur {

/// The file's bytes, with the chunks that a mesh does not need made unknown. Rejects chunks that are longer than what they lie
/// in, lists that do not fill their chunk, faces whose vertices are not there, uv of another number than the vertices, and absurd
/// counts.
[[nodiscard]] Result<std::string> check_three_ds(std::string bytes, const std::string& name);

} // namespace windrow::vegetation::fur
