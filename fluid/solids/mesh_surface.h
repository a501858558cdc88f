// The surface of a mesh: one vertex a place, and whether it is closed.
#pragma once

#include "fluid/shapes/triangle_mesh.h"

namespace windrow::detail {

/// Rejects what no closed surface is made of: counts, indices and coordinates out of range.
[[nodiscard]] Result<void> check_parts(const MeshData& data);

/// One vertex for each place that is used, in the order of their first; 0 for -0. Leaves out triangles with a corner twice.
void weld(MeshData& data);

/// Rejects edges that are not passed as often one way as the other. Where leaving out the second of equal triangles closes the
/// surface, they are left out.
[[nodiscard]] Result<void> close_surface(MeshData& data);

} // namespace windrow::detail
