// Streamlines of the air in a plane: lines along its velocity there, evenly spaced, that end at bodies.
//
// A line grows both ways from its seed until it comes nearer than half the spacing to another, to a body, to the box's side or to
// calm air. Seeds are one spacing beside lines that are there; where no more fit, places of a lattice that are still free.
// Based on: Jobard and Lefer 1997, "Creating Evenly-Spaced Streamlines of Arbitrary Density" (its sections 2 and 3).
#pragma once

#include "cli/drawing/sections.h"

#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace windrow::cli {

/// Points [m] in the plane's coordinates, in the direction of the flow.
using Streamline = std::vector<glm::dvec2>;

/// `spacing` [m] > 0. Air slower than `calm` [m/s] in the plane has none. `bodies` are those of `bodies_at`.
[[nodiscard]] std::vector<Streamline> streamlines(const SlicedAir& air, const Plane& plane, std::span<const CutBody> bodies,
                                                  double spacing, double calm);

} // namespace windrow::cli
