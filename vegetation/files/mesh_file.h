// Meshes from files: OBJ (with the fur line of its mtl), glTF and GLB, 3DS.
//
//     auto bunny = fur::read_mesh("bunny.obj", {.size = 1.0f, .max_triangles = 8'000});
//
// Assimp turns a file into triangles, and has had memory faults on hostile files. So each file is read here first (scene/obj_text.h,
// gltf_text.h, three_ds_chunks.h): counts, sizes, indices and names of files are checked, and assimp is handed only the parts
// that were understood, from memory. It opens no file.
//
// What then happens, in order: positions turned (y up), one vertex for each position and uv, triangles without area dropped,
// normals (mesh_normals.h), fewer triangles if asked (mesh.h), uv of a box where there are none (mesh.h), placed.
#pragma once

#include "fluid/input_budget.h"
#include "vegetation/fur/mesh.h"

#include <filesystem>

namespace windrow::vegetation::fur {

enum class UpAxis { x, y, z };

/// What `size` is the length of.
enum class SizeOf { longest_edge, height };

struct MeshLoad {
    UpAxis up = UpAxis::y;
    float size = 1.0f;
    SizeOf size_of = SizeOf::longest_edge;
    float yaw_deg = 0.0f;
    std::size_t max_triangles = k_max_triangles;

    static constexpr auto settings() {
        return std::tuple{
            Setting("up", &MeshLoad::up,
                    "Axis of the file that points up: y of glTF and of most OBJ files, z mostly of 3DS files."),
            Setting("size", &MeshLoad::size, {1e-3, 1e3, "m"},
                    "Size to which the mesh is scaled, and a fur line's height with it."),
            Setting("size_of", &MeshLoad::size_of, "The length that `size` sets."),
            Setting("yaw_deg", &MeshLoad::yaw_deg, {-360.0, 360.0, "deg"}, "Turn about y, seen from above counter-clockwise."),
            Setting("max_triangles", &MeshLoad::max_triangles, {4.0, k_max_triangles}, "Files with more are simplified."),
        };
    }
};

/// [byte] Of one file; a mesh of `k_max_triangles` as text is about as long.
inline constexpr std::size_t k_max_bytes = std::size_t{512} << 20;

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

template <>
inline constexpr std::array<const char*, 3> windrow::k_words<windrow::vegetation::fur::UpAxis>{"x", "y", "z"};
template <>
inline constexpr std::array<const char*, 2> windrow::k_words<windrow::vegetation::fur::SizeOf>{"longest_edge", "height"};
