// Diffusion beside walls and open boundaries.
//
//   any mix of sides   the equations of a step, u' = u + r L u or (1 - r L) u' = u, in double with the ghosts that boundaries.h names
//   Couette, Stokes    flows of cases/wall_cases.cpp
#include "case_check.h"
#include "cases/reference/stencil.h"
#include "flows.h"

#include <array>

namespace windrow {
namespace {

using namespace flows;
using figures::expect_at_most;
using reference::Stencil;
using reference::Values;

constexpr std::array k_diffused_sizes = {glm::ivec3(1, 1, 1),   glm::ivec3(1, 2, 3),  glm::ivec3(2, 1, 1),
                                         glm::ivec3(3, 3, 2),   glm::ivec3(1, 5, 7),  glm::ivec3(3, 1, 4),
                                         glm::ivec3(17, 9, 23), glm::ivec3(6, 12, 1), glm::ivec3(16, 8, 16)};

Boundaries random_diffusing_walls(Random& random) {
    Boundaries boundaries = random_kinds(random);
    for (int axis = 0; axis < 3; ++axis)
        for (int end = 0; end < 2; ++end)
            if (Boundary& side = side_of(boundaries, axis, end); side.kind == BoundaryKind::no_slip) {
                side.wall_velocity = glm::vec3(random.point(1.0));
                side.wall_velocity[axis] = 0.0f;
            }
    return boundaries;
}

Values component_of(const Field& field, int c) {
    Values values(field.size());
    for (std::size_t n = 0; n < field.size(); ++n)
        values[n] = field[n][c];
    return values;
}

// Air, walls and ambient wind are all of size 1 m/s, and so is what an error is held against. Rounding of u' alone is amplified
// by up to 1 + 12 r in the equation: beyond r = 5 the residual itself is held against that too. (1 - r L)^-1 of it is the error
// of u'.
TEST(DiffusionSides, EveryMixOfSidesSolvesItsEquations) {
    Random random(91);
    double worst_one_pass = 0.0, worst_implicit = 0.0, worst_scaled = 0.0, worst_error = 0.0;
    int trials[2] = {};
    for (int trial = 0; trial < 900; ++trial) {
        const Box box{.cells = k_diffused_sizes[trial % k_diffused_sizes.size()],
                      .cell_size = 0.5f,
                      .boundaries = random_diffusing_walls(random)};
        const glm::vec3 ambient = admissible_ambient(box.boundaries, glm::vec3(random.point(1.0)));
        Workspace work = workspace(box, ambient);
        // h^2 / dt = 1: the viscosity is the ratio.
        const auto viscosity = static_cast<float>(std::pow(10.0, random.real(-3.5, 4.0)));
        const double r = viscosity;
        const Field field = random_field(random, box);
        Field result(field.size());
        const DiffusionMethod method = *diffuse(work, field, viscosity, 0.25f, result);
        const bool implicit = method == DiffusionMethod::implicit;
        ASSERT_NE(method, DiffusionMethod::none);
        ++trials[implicit];
        for (int c = 0; c < 3; ++c) {
            const Stencil stencil = Stencil::velocity(box, c, ambient);
            const Values before = component_of(field, c), after = component_of(result, c);
            const Values image = stencil.laplacian(implicit ? after : before);
            const double size = std::sqrt(static_cast<double>(before.size()));
            Values residual(before.size());
            for (std::size_t n = 0; n < residual.size(); ++n)
                residual[n] = after[n] - before[n] - r * image[n];
            const double left = Stencil::norm(residual) / size;
            if (!implicit) {
                worst_one_pass = std::max(worst_one_pass, left);
                continue;
            }
            if (r <= 5.0)
                worst_implicit = std::max(worst_implicit, left);
            worst_scaled = std::max(worst_scaled, left / (1.0 + 12.0 * r));
            for (double& value : residual)
                value /= r;
            worst_error = std::max(worst_error, Stencil::norm(stencil.solve(1.0 / r, residual, 1e-4)) / size);
        }
    }
    figures::report("diffusion_sides.one_pass_trials", trials[0]);
    figures::report("diffusion_sides.implicit_trials", trials[1]);
    expect_at_most("diffusion_sides.one_pass_residual", worst_one_pass, 1e-6);
    expect_at_most("diffusion_sides.implicit_residual_to_ratio_5", worst_implicit, 1e-5);
    expect_at_most("diffusion_sides.implicit_residual_scaled", worst_scaled, 1e-6);
    expect_at_most("diffusion_sides.implicit_error", worst_error, 1e-5);
}

TEST(DiffusionSides, CouetteFlowReachesItsLine) {
    figures::expect_case("couette_one_pass", {16, 32, 64});
    figures::expect_case("couette_implicit", {16, 32, 64});
    figures::expect_case("couette_steady", {16, 33, 64});
}

TEST(DiffusionSides, StokesSecondProblemIsSecondOrder) {
    for (const char* const name : {"stokes_second_one_pass", "stokes_second_implicit"})
        figures::expect_case(name, {16, 32, 64});
}

} // namespace
} // namespace windrow
