// Boundary rules of each stage: the source of ghost values, and the bounds of trajectories. Shared by the kernels of the CPU and
// the tables of the GPU.
#pragma once

#include "fluid/allocator.h"
#include "fluid/api.h"
#include "fluid/box.h"
#include "fluid/grid/basis.h"
#include "fluid/grid/halo.h"

#include <array>
#include <vector>

namespace windrow {

/// Ghost values beyond a boundary, for the pressure and for a component of the velocity.
[[nodiscard]] EndRule pressure_end(const Boundary& side);
[[nodiscard]] EndRule velocity_end(const Boundary& side, bool normal);
/// End rules of all boundaries, for the pressure and for a component of the velocity.
[[nodiscard]] WINDROW_INTERNAL std::array<std::array<EndRule, 2>, 3> pressure_ends(const Boundaries& boundaries);
[[nodiscard]] WINDROW_INTERNAL std::array<std::array<EndRule, 2>, 3> velocity_ends(const Boundaries& boundaries, int component);

/// Rules of an axis, one per padded index [cell + k_halo_low], for viscosity.
[[nodiscard]] WINDROW_INTERNAL detail::HostVector<HaloRule> halo_rules(const Box& box, int axis);
/// The same for transport: the air slips along every wall. A no-slip wall acts through a layer made by viscosity, thinner than a
/// cell except in very viscous air. A ghost of opposite sign puts that layer between the outermost cell and the ghost, where a
/// cubic read takes it for a slope and amplifies it: two cells between such walls grew to 100 times the driving speed. So
/// advected air slips, and only viscosity slows it.
[[nodiscard]] WINDROW_INTERNAL detail::HostVector<HaloRule> carried_rules(const Box& box, int axis);

/// Ghost values of a stencil beyond one end of an axis. Beyond an open boundary the divergence takes the cell itself and p is 0
/// at the ghost's centre. This pair is not adjoint: the projection can amplify waves of a few cells along an edge (operators.h).
/// Both adjoint pairs cost more. p = 0 at the face has a fifth more error against a larger box. With the ambient wind as the
/// ghost, a stream through the box loses 1 / (cells + 1) of its excess over the ambient wind in each step of any length.
[[nodiscard]] WINDROW_INTERNAL NormalGhost velocity_ghost(const Box& box, int axis, int end);
[[nodiscard]] WINDROW_INTERNAL NormalGhost potential_ghost(const Box& box, int axis, int end);

/// Range of departure points on an axis, in cells from the first centre. At an open boundary it ends one cell beyond the
/// outermost centre, where all samples are ambient. A wall ends it at the face; a periodic axis wraps.
struct LegalPlaces {
    float low = 0.0f, high = 0.0f;
    float period = 0.0f, inverse_period = 0.0f; ///< 0 where the axis is not periodic
};
[[nodiscard]] WINDROW_INTERNAL LegalPlaces legal_places(const Box& box, int axis);

/// Place of a cell in a padded field of a box of `cells`.
[[nodiscard]] inline std::size_t padded_index(glm::ivec3 cells, glm::ivec3 at) {
    const glm::ivec3 padded = cells + k_halo;
    at += k_halo_low;
    return (static_cast<std::size_t>(at.z) * padded.y + at.y) * padded.x + at.x;
}

} // namespace windrow
