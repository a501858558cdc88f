// Fewer triangles: the edge whose collapse moves the surface least goes first.
//
// The error of a vertex moved to p is the sum of its planes' squared distances times their triangles' areas, p^T Q p with
// homogeneous p; a collapse keeps one end of its edge where it is, so that all vertices are the file's own, and gives it both
// quadrics. Vertices on borders, on seams of the uv and between parts stay, but others may collapse onto them. A collapse is
// refused that would turn a triangle by more than 75 degrees, or pinch the surface.
// Based on: Garland & Heckbert 1997, Surface simplification using quadric error metrics, sections 4 and 5; Dey et al. 1999,
// Topology preserving edge contraction (the link condition).
#pragma once

#include "vegetation/fur/mesh.h"

namespace windrow::vegetation::fur {

/// Down to `most` triangles, or to as few as the rules above allow; vertices that are left over are removed. It ends earlier where
/// points with thousands of triangles each would take minutes: after 12 million looks at a triangle and 100 for each. Normals are those
/// of the vertices that stay: make them anew. The order of collapses does not depend on the machine.
void simplify(Mesh& mesh, std::size_t most);

} // namespace windrow::vegetation::fur
