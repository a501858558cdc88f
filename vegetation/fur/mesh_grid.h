// Rows of vertices, sewn to triangles: what sheets, spheres and wings are made of.
#pragma once

#include "vegetation/fur/mesh.h"

namespace windrow::vegetation::fur {

/// Adds the two triangles of the cell with these corners, counter-clockwise seen from outside.
inline void add_cell(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    mesh.indices.insert(mesh.indices.end(), {a, b, c, a, c, d});
}

/// All triangles as one part of this material, and the box.
inline void finish(Mesh& mesh, const char* material) {
    mesh.parts = {{material, 0, static_cast<std::uint32_t>(mesh.indices.size()), {}}};
    measure(mesh);
}

} // namespace windrow::vegetation::fur
