// A mesh that wears shells: an indexed list of triangles, cut into parts that wear one coat each.
//
// y is up, metres, triangles counter-clockwise seen from outside. A vertex has one normal, the one that shells are extruded
// along. Vertices with the same position and different uv (a seam of the map) have the same normal, because shells would tear
// open along the seam otherwise; hence no hard edges.
#pragma once

#include "../../fluid/result.h"
#include "fur_line.h"

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <string>
#include <vector>

namespace windrow::vegetation::fur {

using windrow::Error;
using windrow::Result;

struct MeshVertex {
    glm::vec3 position{0.0f};           ///< [m]
    glm::vec3 normal{0.0f, 1.0f, 0.0f}; ///< unit vector, outward
    glm::vec2 uv{0.0f};                 ///< of the file, or a box projection
    glm::uvec4 bones{0u};               ///< indices into a skeleton; skeleton.h fills them
    glm::vec4 weights{0.0f};            ///< sum 1, or all 0: not bound
};

/// Triangles with one material.
struct MeshPart {
    std::string material;         ///< the file's name of it, or what a shape is made of
    std::uint32_t first = 0;      ///< of `indices`
    std::uint32_t count = 0;      ///< indices, three a triangle
    std::optional<FurLine> fur{}; ///< of the material's file (fur_line.h)
};

struct Mesh {
    std::vector<MeshVertex> vertices;
    std::vector<std::uint32_t> indices;
    std::vector<MeshPart> parts;     ///< in order, all indices, each once
    bool has_uv = false;             ///< false: uv is a box projection, which tears at its edges
    glm::vec3 low{0.0f}, high{0.0f}; ///< [m] the box of all positions

    [[nodiscard]] std::size_t triangles() const { return indices.size() / 3; }
};

/// More than a coat can be drawn on; a shell draws each again.
inline constexpr std::size_t k_max_vertices = 2'000'000, k_max_triangles = 4'000'000, k_max_parts = 4096;
/// [m] No coordinate is farther from the origin.
inline constexpr float k_farthest = 1e5f;

/// Rejects indices without a vertex, parts that are not the list of triangles, what is not finite, normals whose length is not 1
/// within 1e-3, weights that do not sum to 1 within 1e-4 (or are not all 0), a box that is not the positions', and absurd counts.
[[nodiscard]] Result<void> validate(const Mesh& mesh, const char* owner = "mesh");

/// Sets `low` and `high`.
void measure(Mesh& mesh);

/// The box projection, for meshes without a uv: each triangle is seen along the axis that its normals face most, and its vertices get
/// the other two coordinates [m], at most stretched by sqrt(3), torn where the axis changes. Sets every uv and has_uv to false.
/// Vertices where the axis changes are doubled; normals stay shared.
void project_uv(Mesh& mesh);

/// Down to `most` triangles, or to as few as the rules above allow; vertices that are left over are removed. It ends earlier where
/// points with thousands of triangles each would take minutes: after 12 million looks at a triangle and 100 for each. Normals are those
/// of the vertices that stay: make them again. The order of collapses does not depend on the machine.
void simplify(Mesh& mesh, std::size_t most);

} // namespace windrow::vegetation::fur
