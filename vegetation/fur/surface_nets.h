// A body's skin as triangles: one vertex in each cell of a grid that the surface crosses, four neighbours to a face.
//
// The vertex is the mean of the crossings on the cell's edges, then moved onto the surface, p <- p - d g / |g|^2, as far as its
// cell lets it; its normal is the slope g there. Faces lie across each edge of the grid that the surface crosses.
// Based on: Gibson 1998, Constrained elastic surface nets (the cells and their faces).
#pragma once

#include "vegetation/fur/flesh.h"
#include "vegetation/fur/mesh.h"

namespace windrow::vegetation::fur {

/// Of cells of `cell` metres; without uv, of the material `material`. The body must lie within `low` to `high` [m]; the box must
/// have at most 512 cells along an edge. Rejects a body that touches the box or is nowhere, boxes of other sizes, and a skin that
/// is not closed, since two parts of it cross one cell.
[[nodiscard]] Result<Mesh> surface_nets(const Flesh& flesh, const glm::vec3& low, const glm::vec3& high, float cell,
                                        const char* material);

} // namespace windrow::vegetation::fur
