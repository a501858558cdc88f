// Boundary rules of each stage: the source of ghost values, and the bounds of trajectories. Shared by the kernels of the CPU and
// the tables of the GPU.
#pragma once

#include "fluid/box.h"
#include "fluid/cpu/basis.h"
#include "fluid/cpu/kernels/kernels.h"

#include <array>
#include <vector>

namespace windrow::cpu {

/// Ghost values beyond a boundary, for the pressure and for a component of the velocity.
[[nodiscard]] EndRule pressure_end(const Boundary& side);
[[nodiscard]] EndRule velocity_end(const Boundary& side, bool normal);
/// End rules of all boundaries, for the pressure and for a component of the velocity.
[[nodiscard]] std::array<std::array<EndRule, 2>, 3> pressure_ends(const Boundaries& boundaries);
[[nodiscard]] std::array<std::array<EndRule, 2>, 3> velocity_ends(const Boundaries& boundaries, int component);

/// Rules of an axis, one per padded index [cell + k_halo_low], for viscosity.
[[nodiscard]] std::vector<HaloRule> halo_rules(const Box& box, int axis);
/// The same as transport sees them: along every wall the air slips. What a no-slip wall holds back is a layer that viscosity
/// makes, thinner than a cell in all but the stiffest air. A ghost of the other sign puts that layer between the outermost cell
/// and the one beyond it, where a cubic read takes it for a slope and feeds on it: two cells between such walls grew to 100 times
/// the speed of what drove them. So carried air slips, and viscosity alone holds it back.
[[nodiscard]] std::vector<HaloRule> carried_rules(const Box& box, int axis);

/// Ghost values of a stencil beyond one end of an axis. Beyond an open boundary the divergence takes the cell itself and p is 0
/// at the ghost's centre, which is no adjoint pair: the projection can add to waves of a few cells along an edge (operators.h).
/// Both pairs that cannot cost more. p = 0 at the face: a fifth more error against a larger box. The ambient wind as the ghost: a
/// stream through the box loses 1 / (cells + 1) of what is not ambient in each step, however short.
[[nodiscard]] NormalGhost velocity_ghost(const Box& box, int axis, int end);
[[nodiscard]] NormalGhost potential_ghost(const Box& box, int axis, int end);

/// Range of departure points on an axis, in cells from the first centre. At an open boundary it ends one cell beyond the
/// outermost centre, where all samples are ambient. A wall ends it at the face; a periodic axis wraps.
struct LegalPlaces {
    float low = 0.0f, high = 0.0f;
    float period = 0.0f, inverse_period = 0.0f; ///< 0 where the axis is not periodic
};
[[nodiscard]] LegalPlaces legal_places(const Box& box, int axis);

} // namespace windrow::cpu
