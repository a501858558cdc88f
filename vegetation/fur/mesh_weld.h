// From triangles that share nothing to a mesh: one vertex for each position and uv, one normal for each position.
//
// Normals: the sum over the corners at a position of the corner's normal times its angle, made a unit vector; the corner's normal
// is the file's, or else the triangle's. Weights by angle make the sum independent of how a flat face is cut.
// Based on: Thuermer & Wuethrich 1998, Computing vertex normals from polygonal facets.
#pragma once

#include "vegetation/fur/mesh.h"

#include <vector>

namespace windrow::vegetation::fur {

/// What a file gives before it is a mesh: three corners a triangle, not shared.
struct Corner {
    glm::vec3 position{0.0f};
    glm::vec3 normal{0.0f}; ///< of the file; 0 where it has none
    glm::vec2 uv{0.0f};
};

struct SoupPart {
    std::string material;
    std::vector<Corner> corners; ///< three a triangle
    bool has_uv = false;
};

using Soup = std::vector<SoupPart>;

/// For each vertex the number of its position, from 0: vertices of equal position (to the bit, -0 as 0) have the same.
[[nodiscard]] std::vector<std::uint32_t> same_positions(const std::vector<MeshVertex>& vertices);

/// Triangles without area (a sine of 1e-6 between their edges) are left out. A vertex's normal is the sum of the file's normals
/// at it, times angles: not of length 1 yet, and 0 where the file has none; smooth_normals ends it. Rejects what is not finite,
/// normals of the file of length 0 beside others, more vertices than k_max_vertices, and what has no triangle left.
[[nodiscard]] Result<Mesh> weld(const Soup& soup, const std::string& owner);

/// Sets all normals to unit vectors: of the sums that the vertices hold, or, where a position's sum is 0, of its triangles. A
/// position without direction, whose triangles face each other, gets the direction of the first of them.
void smooth_normals(Mesh& mesh);

} // namespace windrow::vegetation::fur
