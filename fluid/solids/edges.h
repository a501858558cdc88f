// Sharp edges of bodies. Air leaves a body at a sharp edge: its layer along the surface goes on, into the air. Where a surface cuts cells
// a part of the way through, the open parts behind the edge let air around it as around a round one. So cells at a sharp edge that are
// inside, or nearly so, are shut: of a block whose sides pass through the middles of cells the drag is that of one whose sides are
// between cells, and else half of it.
//
// An edge is sharp on the scale of a cell: half a cell from it along either side, the surface is as far away as beside a right angle.
// So neither a seam between bodies, nor the foot of a wall, nor a line of a round mesh is one. Only edges within 14 degrees of an axis of
// the cells count. Along another edge, or the rim of a cylinder, the shut cells would form stairs that block a wind parallel to it.
#pragma once

#include "fluid/obstacle.h"

#include <span>

namespace windrow::detail {

/// A straight edge near a place, in a shape's own axes.
struct SharpEdge {
    glm::vec3 from, to;      ///< [m] its ends
    glm::vec3 normal, other; ///< unit vectors out of the surfaces that meet there
};

/// Whether a shape may have sharp edges.
[[nodiscard]] bool has_sharp_edges(const Shape& shape);
/// Fills `found` with edges of a shape that are nearer to a place than `most` [m], as many as there is room for. Returns their number.
/// Voxels below half of `cell` [m] have none: a slope of them is one surface.
[[nodiscard]] std::size_t sharp_edges_near(const Shape& shape, glm::vec3 place, float most, float cell,
                                           std::span<SharpEdge> found);

} // namespace windrow::detail
