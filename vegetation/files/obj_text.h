// The text of an OBJ file, checked before Assimp sees it, and its faces written anew without what was not understood.
//
// Kept: v, vt, vn, f, usemtl; noted: mtllib. Everything else (groups, smoothing, lines, curves, comments) is left out: a mesh
// with shells has one normal a position anyway. Indices may count from the end, and mean vertices that stand above their face.
#pragma once

#include "vegetation/fur/mesh.h"

#include <string>
#include <string_view>
#include <vector>

namespace windrow::vegetation::fur {

struct ObjText {
    std::string text;                   ///< for Assimp: v, vt, vn, usemtl and f with indices from 1, each checked
    std::vector<std::string> libraries; ///< the names of mtllib, at most 64
};

/// More corners in one face are no face; cutting it into triangles takes the square of their number.
inline constexpr std::size_t k_max_corners = 64;

/// Rejects, with `name` and the line's number: numbers that are none or not finite, indices without a vertex, faces of fewer than
/// 3 or more than k_max_corners corners or with different kinds of corners, more vertices or triangles than k_most_*, lines that
/// go on after a backslash, and zero bytes.
[[nodiscard]] Result<ObjText> check_obj(std::string_view text, const std::string& name);

} // namespace windrow::vegetation::fur
