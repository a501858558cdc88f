// A glTF 2.0 file, as text or binary (GLB), as triangles. tinygltf reads it.
//
// Read: the nodes with their places, meshes of triangles with POSITION, NORMAL, TEXCOORD_0 and indices, the materials' names.
// Images, skins, animations, cameras and extensions are left out. Based on: Khronos 2021, glTF 2.0 specification, sections 3.5 to
// 3.7 and 4.4 (GLB).
#pragma once

#include "fluid/files/input_budget.h"
#include "vegetation/fur/mesh_weld.h"

#include <filesystem>
#include <string_view>

namespace windrow::vegetation::fur {

/// `bytes` are those of the file `path`, whose folder has the buffers. Rejects, with the file's name and mostly the JSON's path: what
/// is no JSON, extensions that are required, buffers that are missing, too short or outside of the folder, views and accessors
/// that reach beyond what they are in, attributes of other types than floats, indices without a vertex, nodes in a circle or
/// deeper than 24, and absurd counts. Numbers that are not finite are rejected by weld.
[[nodiscard]] Result<Soup> read_gltf(std::string_view bytes, const std::filesystem::path& path,
                                     windrow::detail::InputBudget& budget);

} // namespace windrow::vegetation::fur
