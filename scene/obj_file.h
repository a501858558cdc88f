// An OBJ file: its vertices, and its faces as triangles.
//
// Read: v, vt, vn, f, usemtl; noted: mtllib. Everything else (groups, smoothing, lines, curves, comments) is left out. Indices may
// count from the end, and mean vertices that are above their face.
#pragma once

#include "fluid/result.h"
#include "fluid/shapes/triangle_mesh.h"

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace windrow::scene {

/// Indices from 0 into the lists of the file.
struct ObjCorner {
    static constexpr std::uint32_t k_none = ~0u;
    std::uint32_t position = k_none, uv = k_none, normal = k_none; ///< the last two: k_none where the face has none
};

/// All triangles of one material.
struct ObjPart {
    std::string material;             ///< "none" where the file names none
    std::vector<ObjCorner> corners{}; ///< three a triangle
};

struct ObjFile {
    std::vector<glm::vec3> positions, normals;
    std::vector<glm::vec2> uvs;
    std::vector<ObjPart> parts;         ///< in the order of their first faces, none empty
    std::vector<std::string> libraries; ///< the names of mtllib, at most 64
};

/// More corners in one face are no face; cutting it into triangles takes the square of their number.
inline constexpr std::size_t k_max_corners = 64;
inline constexpr std::size_t k_max_materials = 4096;

/// The most that a file may have.
struct ObjLimits {
    std::size_t vertices, triangles;
};

/// Faces of more corners than three are cut within their outline. Rejects, with `name` and the line's number: numbers
/// that are none or not finite, indices without a vertex, faces of fewer than 3 or more than k_max_corners corners or with
/// different kinds of corners, more vertices or triangles than `limits`, more than k_max_materials, lines that go on after a
/// backslash, and zero bytes. Throws std::bad_alloc.
[[nodiscard]] Result<ObjFile> read_obj(std::string_view text, const std::string& name, const ObjLimits& limits);

/// All vertices and triangles. Throws std::bad_alloc.
[[nodiscard]] MeshData mesh_of_obj(const ObjFile& obj);

} // namespace windrow::scene
