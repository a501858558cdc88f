// The text of an OBJ file, checked before anything else reads it, and its faces written again without what was not understood.
//
// Kept: v, vt, vn, f, usemtl; noted: mtllib. Everything else (groups, smoothing, lines, curves, comments) is left out. Indices may
// count from the end, and mean vertices that are above their face.
#pragma once

#include "fluid/result.h"
#include "fluid/shapes/triangle_mesh.h"

#include <string>
#include <string_view>
#include <vector>

namespace windrow::scene {

struct ObjText {
    std::string text;                   ///< v, vt, vn, usemtl and f with indices from 1, each checked
    std::vector<std::string> libraries; ///< the names of mtllib, at most 64
};

/// More corners in one face are no face; cutting it into triangles takes the square of their number.
inline constexpr std::size_t k_max_corners = 64;

/// The most that a file may have.
struct ObjLimits {
    std::size_t vertices, triangles;
};

/// Rejects, with `name` and the line's number: numbers that are none or not finite, indices without a vertex, faces of fewer than
/// 3 or more than k_max_corners corners or with different kinds of corners, more vertices or triangles than `limits`, lines that
/// go on after a backslash, and zero bytes.
[[nodiscard]] Result<ObjText> check_obj(std::string_view text, const std::string& name, const ObjLimits& limits);

/// Vertices and triangles of a checked text, as many as `limits` allowed. Faces of more corners are cut into triangles within their
/// outline, in a plane through them. Throws std::bad_alloc.
[[nodiscard]] MeshData mesh_of_obj(const ObjText& obj);

} // namespace windrow::scene
