// A glTF 2.0 file, as text or binary (GLB), checked before Assimp sees it, and written again without what was not understood.
//
// Kept: the scene's nodes with their places, meshes of triangles with POSITION, NORMAL, TEXCOORD_0 and indices, the materials'
// names, and of accessors, views and buffers those that these use. Images, skins, animations, cameras and extensions are left
// out. Based on: Khronos 2021, glTF 2.0 specification, sections 3.5 to 3.7 and 4.4 (GLB).
#pragma once

#include "fluid/files/input_budget.h"
#include "vegetation/fur/mesh.h"

#include <filesystem>
#include <string>
#include <vector>

namespace windrow::vegetation::fur {

struct GltfText {
    std::string json;                 ///< for Assimp: its buffers are the files 0.bin, 1.bin and so on
    std::vector<std::string> buffers; ///< their bytes
};

/// `bytes` are those of the file `path`, whose folder has the buffers. Rejects, with the file's name and the JSON's path: what is
/// no JSON, extensions that are required, buffers that are missing, too short or outside of the folder, views and accessors that
/// reach beyond what they lie in, attributes of other types than floats, indices without a vertex, nodes in a circle or deeper
/// than 24, and absurd counts.
[[nodiscard]] Result<GltfText> check_gltf(const std::string& bytes, const std::filesystem::path& path,
                                          windrow::detail::InputBudget& budget);

} // namespace windrow::vegetation::fur
