// Boxes and fields that the analytic tests share, beside those of the cases.
//
// Positions are metres from the box's low corner, in double; a field samples a flow at cell centres, box.h's layout.
#pragma once

#include "cases/cell_values.h"
#include "cases/flows.h"
#include "cases/whole_step.h"
#include "fluid/operators.h"
#include "tests/winds.h"

#include <numbers>
#include <span>

namespace windrow::flows {

inline constexpr BoundaryKind k_open = BoundaryKind::open, k_slip = BoundaryKind::free_slip, k_rough = BoundaryKind::no_slip,
                              k_periodic = BoundaryKind::periodic;

using cases::ArnoldBeltramiChildress;
using cases::k_pi;
using cases::periodic_box;
using cases::relative_error;
using cases::scalars_of;
using cases::side_of;
using cases::sides_of;
using cases::TaylorGreen2D;
using cases::velocities_of;
using cases::velocity_error;
using cases::visit_cells;
using test::for_each_cell;
using test::largest_apart;
using test::largest_off;
using test::Random;
using test::take_steps;
using Field = cases::CellVelocities;

/// Workspace of a box that is known to be legal.
inline Workspace workspace(const Box& box, glm::vec3 ambient = glm::vec3(0.0f)) {
    return *Workspace::create({.box = box, .ambient = ambient, .parallel_for = {}});
}

/// A Wind of `box` for the raw step: no settling, no sub-steps. The box's low corner is the origin.
inline Wind raw_wind(const Box& box, double viscosity, Scheme scheme, Interpolation interpolation) {
    Config config = cases::raw_config(box, viscosity, {});
    config.scheme = scheme;
    config.interpolation = interpolation;
    return *Wind::create(config);
}

// --- Random fields -----------------------------------------------------------------------------------------------------

/// Any mix of kinds, a quarter of the axes periodic.
inline Boundaries random_kinds(Random& random) {
    Boundaries result;
    for (int axis = 0; axis < 3; ++axis) {
        const bool periodic = random.integer(0, 3) == 0;
        for (int end = 0; end < 2; ++end)
            side_of(result, axis, end).kind = periodic ? BoundaryKind::periodic : static_cast<BoundaryKind>(random.integer(0, 2));
    }
    return result;
}
inline Field random_field(Random& random, const Box& box, float size = 1.0f) {
    return test::white_noise(box.cells, size, random.bits());
}

// --- Norms -----------------------------------------------------------------------------------------------------------

inline double rms(std::span<const glm::vec4> u) {
    double squares = 0.0;
    for (const glm::vec4& v : u)
        squares += glm::dot(glm::dvec3(v), glm::dvec3(v));
    return std::sqrt(squares / static_cast<double>(u.size()));
}

inline double rms(std::span<const float> values) {
    double squares = 0.0;
    for (const float v : values)
        squares += static_cast<double>(v) * v;
    return std::sqrt(squares / static_cast<double>(values.size()));
}

} // namespace windrow::flows
