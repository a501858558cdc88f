// Advection against its own definition, re-read in double by trajectory_reference.h, at every kind of side and odd sizes.
//
// The interpolant is continuous in the departure point, so a departure that rounds to the other side of a cell's face gives the
// same value: float and double must agree everywhere to rounding, 1e-4 of fields of size 1 at trajectories of up to 6 cells.
#include "cases/reference/trajectory.h"
#include "figures.h"
#include "flows.h"

#include <array>

namespace windrow {
namespace {

using namespace flows;
using figures::expect_at_most;

constexpr std::array k_sizes = {glm::ivec3(1, 1, 1), glm::ivec3(1, 5, 7),  glm::ivec3(2, 2, 2),
                                glm::ivec3(3, 1, 4), glm::ivec3(17, 9, 5), glm::ivec3(8, 4, 70)};

// Where two moving walls meet, the order of their mirrors would be a matter of convention: only y's walls move.
Boundaries random_walls(Random& random) {
    Boundaries boundaries = random_kinds(random);
    for (int end = 0; end < 2; ++end)
        if (Boundary& side = side_of(boundaries, 1, end); side.kind == BoundaryKind::no_slip)
            side.wall_velocity = glm::vec3(random.point(1.0)) * glm::vec3(1.0f, 0.0f, 1.0f);
    return boundaries;
}

double worst_difference(Interpolation interpolation, bool with_history) {
    Random random(with_history ? 71 : 17);
    double worst = 0.0;
    for (int trial = 0; trial < 120; ++trial) {
        const Box box{.cells = k_sizes[trial % k_sizes.size()], .cell_size = 0.5f, .boundaries = random_walls(random)};
        Workspace work = workspace(box, glm::vec3(random.point(1.0)));
        const Field carried = random_field(random, box), wind = random_field(random, box), old = random_field(random, box),
                    history = random_field(random, box);
        Transport transport{.carried = carried, .velocity = wind, .interpolation = interpolation};
        transport.dt = static_cast<float>(random.real(0.1, 1.0));
        if (with_history) {
            transport.velocity_old = old;
            transport.extrapolation = static_cast<float>(random.real(0.0, 1.0));
            transport.history = history;
            transport.history_scale = static_cast<float>(random.real(0.0, 2.0));
            transport.relaxation = 0.9f;
        }
        Field moved(box.cell_count());
        advect(work, transport, moved);
        for_each_cell(box.cells, [&](int i, int j, int k) {
            const glm::dvec3 exact = reference::arrival(box, glm::dvec3(work.ambient()), transport, {i, j, k});
            for (int axis = 0; axis < 3; ++axis)
                worst = std::max(worst, std::abs(moved[box.index(i, j, k)][axis] - exact[axis]));
        });
    }
    return worst;
}

TEST(AdvectionSides, AStepEqualsItsDefinition) {
    expect_at_most("advection_sides.plain.linear", worst_difference(Interpolation::linear, false), 2e-5);
    expect_at_most("advection_sides.plain.cubic", worst_difference(Interpolation::cubic, false), 2e-5);
}

TEST(AdvectionSides, ASecondOrderStepEqualsItsDefinition) {
    expect_at_most("advection_sides.second_order.linear", worst_difference(Interpolation::linear, true), 1e-4);
    expect_at_most("advection_sides.second_order.cubic", worst_difference(Interpolation::cubic, true), 1e-4);
}

TEST(AdvectionSides, AScalarEqualsItsDefinition) {
    for (const Interpolation interpolation : {Interpolation::linear, Interpolation::cubic}) {
        Random random(29);
        double worst = 0.0;
        for (int trial = 0; trial < 120; ++trial) {
            const Box box{.cells = k_sizes[trial % k_sizes.size()], .cell_size = 2.0f, .boundaries = random_walls(random)};
            Workspace work = workspace(box, glm::vec3(random.point(1.0)));
            const Field wind = random_field(random, box);
            const auto values = scalars_of(box, [&](glm::dvec3) { return random.real(-1.0, 1.0); });
            const float dt = static_cast<float>(random.real(0.5, 4.0)), outside = static_cast<float>(random.real(-1.0, 1.0));
            std::vector<float> moved(values.size());
            EXPECT_TRUE(
                advect(work,
                       ScalarTransport{
                           .carried = values, .velocity = wind, .dt = dt, .interpolation = interpolation, .outside = outside},
                       moved));
            const Transport trace{.carried = wind, .velocity = wind, .dt = dt};
            for_each_cell(box.cells, [&](int i, int j, int k) {
                const glm::dvec3 from = reference::departure(box, glm::dvec3(work.ambient()), trace, {i, j, k});
                const double exact = reference::interpolate<double>(
                    interpolation, from, [&](glm::ivec3 index) { return reference::scalar_at(box, values, outside, index); });
                worst = std::max(worst, std::abs(moved[box.index(i, j, k)] - exact));
            });
        }
        expect_at_most(std::string("advection_sides.scalar.") + (interpolation == Interpolation::linear ? "linear" : "cubic"),
                       worst, 2e-5);
    }
}

} // namespace
} // namespace windrow
