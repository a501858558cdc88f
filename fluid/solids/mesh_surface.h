// The surface of a mesh: one vertex a place, whether it is closed, and which of it bounds the body.
#pragma once

#include "fluid/solids/mesh_tree.h"

namespace windrow::detail {

/// Rejects what no closed surface is made of: counts, indices and coordinates out of range.
[[nodiscard]] Result<void> check_parts(const MeshData& data);

/// One vertex for each place that is used, in the order of their first; 0 for -0. Leaves out triangles with a corner twice.
void weld(MeshData& data);

struct ClosedSurface {
    /// Of each triangle, the number of its part's first one: triangles are of one part where they alone have an edge in common.
    std::vector<std::uint32_t> parts{};
    MeshEdges edges{};
};

/// Rejects edges that are not passed as often one way as the other. Where leaving out the second of equal triangles closes the
/// surface, they are left out.
[[nodiscard]] Result<ClosedSurface> close_surface(MeshData& data);

/// What of the parts of a closed mesh is a surface of their union, with a vertex of its own for each corner: parts that touch, overlap
/// or hold one another have triangles with the inside on both sides. Those that others cut are cut to 1/128 of the mesh's longest
/// side. Empty where all of it is a surface. What is left after 1,000 looks at others for each triangle, and 500 more with
/// two million for cutting, counts as surface.
[[nodiscard]] MeshData surface_of_union(const MeshData& data, std::span<const std::uint32_t> parts, const MeshTree& tree);

} // namespace windrow::detail
