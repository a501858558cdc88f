// A uv for meshes without one: the box projection. Each triangle is seen along the axis that its normals face most, and its
// vertices get the other two coordinates, in metres: as dense everywhere, at most stretched by sqrt(3), torn where the axis
// changes.
#pragma once

#include "vegetation/fur/mesh.h"

namespace windrow::vegetation::fur {

/// Of a mesh with normals. Sets every uv [m] and has_uv to false. Vertices where the axis changes are doubled; normals stay
/// shared.
void project_uv(Mesh& mesh);

} // namespace windrow::vegetation::fur
