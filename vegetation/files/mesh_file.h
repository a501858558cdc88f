// Meshes from files: OBJ (with the fur line of its mtl), glTF and GLB.
//
//     auto bunny = fur::read_mesh("bunny.obj", {.size = 1.0f, .max_triangles = 8'000});
//
// Counts, sizes, indices and names of files are checked (scene/obj_file.h, gltf_file.h); files beside the mesh are read through
// mesh_folder.h alone.
//
// What then happens, in order: positions turned (y up), one vertex for each position and uv, triangles without area dropped,
// normals (mesh_normals.h), fewer triangles if asked (mesh.h), uv of a box where there are none (mesh.h), placed.
#pragma once

#include "fluid/files/input_budget.h"
#include "scene/mesh_load.h"
#include "vegetation/fur/mesh.h"

#include <filesystem>

namespace windrow::vegetation::fur {

using windrow::scene::MeshLoad, windrow::scene::SizeOf, windrow::scene::UpAxis;

/// [byte] Of one file.
inline constexpr std::size_t k_max_bytes = windrow::scene::k_max_mesh_bytes;

/// It stands on y = 0, centred in x and z. Rejected with the file's name: no such file, not a mesh of these kinds, no triangles,
/// bad indices, what is not finite, normals of length 0 beside others, more vertices, triangles or bytes than above, files beside
/// it that are missing or lie outside of its folder: absolute names, `..`, and links that lead out. A place whose triangles face
/// each other (a sheet folded onto itself) is not rejected: it has the normal of the first of them.
[[nodiscard]] Result<Mesh> read_mesh(const std::filesystem::path& path, const MeshLoad& load = {});

/// The same for a mesh that a scene names: its file must be in `folder`, links followed, and takes its part of the scene's budget.
[[nodiscard]] Result<Mesh> read_mesh(const std::filesystem::path& path, const MeshLoad& load, const std::filesystem::path& folder,
                                     windrow::detail::InputBudget& budget);

[[nodiscard]] Result<void> validate(const MeshLoad& load);

} // namespace windrow::vegetation::fur
