// Meshes from files: OBJ (with the fur line of its mtl), glTF and GLB, 3DS.
//
//     auto bunny = fur::read_mesh("bunny.obj", {.size = 1.0f, .most_triangles = 8'000});
//
// Assimp turns a file into triangles, and has had memory faults on hostile files. So each file is read here first (obj_text.h,
// gltf_text.h, three_ds_chunks.h): counts, sizes, indices and names of files are checked, and assimp is handed only the parts
// that were understood, from memory. It opens no file.
//
// What then happens, in order: positions turned (y up), one vertex for each position and uv, triangles without area dropped,
// normals (mesh_normals.h), fewer triangles if asked (mesh_simplify.h), uv of a box where there are none (mesh_uv.h), placed.
#pragma once

#include "fluid/input_budget.h"
#include "vegetation/fur/mesh.h"

#include <filesystem>

namespace windrow::vegetation::fur {

enum class UpAxis { x, y, z };

/// What `size` is the length of.
enum class SizeOf { longest_edge, height };

struct MeshLoad {
    /// Which axis of the file points up. Default y: of glTF by its specification, of most OBJ files, and of the bunny, the horse
    /// and the cat of Debian's glmark2-data. 3DS files mostly have z.
    UpAxis up = UpAxis::y;
    /// [m] The mesh's box is scaled to it, 1e-3 to 1e3. Default 1. A fur line's height is scaled with it.
    float size = 1.0f;
    /// Default the longest edge of the box.
    SizeOf size_of = SizeOf::longest_edge;
    /// [rad] Turn about y, seen from above counter-clockwise, -2 pi to 2 pi. Default 0.
    float yaw = 0.0f;
    /// At most so many triangles, 4 to 4,000,000; files with more are simplified. Default: as they are.
    std::size_t most_triangles = k_most_triangles;
};

/// [byte] Of one file; a mesh of `k_most_triangles` as text is about as long.
inline constexpr std::size_t k_most_bytes = std::size_t{512} << 20;

/// It stands on y = 0, centred in x and z. Refused with the file's name: no such file, not a mesh of these kinds, no triangles,
/// bad indices, what is not finite, normals of length 0 beside others, more vertices, triangles or bytes than above, files beside
/// it that are missing or lie outside of its folder: absolute names, `..`, and links that lead out. A place whose triangles face
/// each other (a sheet folded onto itself) is not refused: it has the normal of the first of them.
[[nodiscard]] Result<Mesh> read_mesh(const std::filesystem::path& path, const MeshLoad& load = {});

/// The same for a mesh that a scene names: its file must be in `folder`, links followed, and takes its part of the scene's budget.
[[nodiscard]] Result<Mesh> read_mesh(const std::filesystem::path& path, const MeshLoad& load, const std::filesystem::path& folder,
                                     windrow::detail::InputBudget& budget);

[[nodiscard]] Result<void> validate(const MeshLoad& load);

} // namespace windrow::vegetation::fur
