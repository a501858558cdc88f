// Diffusion beside walls and open sides.
//
//   any mix of sides   the equations of a step, u' = u + r L u or (1 - r L) u' = u, in double with the ghosts that sides.h names
//   Couette            between moving no-slip walls the steady flow is linear, which mirrored ghosts hold exactly
//   Stokes' second     over a wall that swings as U cos(w t): u = U exp(-y/d) cos(w t - y/d), d = sqrt(2 nu / w); order 2 in h
#include "figures.h"
#include "flows.h"
#include "stencil_reference.h"

#include <array>

namespace windrow {
namespace {

using namespace flows;
using figures::expect_at_least;
using figures::expect_at_most;
using reference::Stencil;
using reference::Values;

constexpr std::array k_sizes = {glm::ivec3(1, 1, 1),   glm::ivec3(1, 2, 3),  glm::ivec3(2, 1, 1),
                                glm::ivec3(3, 3, 2),   glm::ivec3(1, 5, 7),  glm::ivec3(3, 1, 4),
                                glm::ivec3(17, 9, 23), glm::ivec3(6, 12, 1), glm::ivec3(16, 8, 16)};

Sides random_sides(Random& random) {
    Sides sides = random.sides();
    for (int axis = 0; axis < 3; ++axis)
        for (int end = 0; end < 2; ++end)
            if (Side& side = side_of(sides, axis, end); side.kind == SideKind::no_slip) {
                side.wall_velocity = glm::vec3(random.vector());
                side.wall_velocity[axis] = 0.0f;
            }
    return sides;
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
        const Box box{.cells = k_sizes[trial % k_sizes.size()], .cell_size = 0.5f, .sides = random_sides(random)};
        const glm::vec3 ambient = admissible_ambient(box.sides, glm::vec3(random.vector()));
        Workspace work = workspace(box, ambient);
        // h^2 / dt = 1: the viscosity is the ratio.
        const auto viscosity = static_cast<float>(std::pow(10.0, random.uniform(-3.5, 4.0)));
        const double r = viscosity;
        const Field field = random.field(box);
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
    const glm::vec3 low(-0.5f, 0.0f, 0.25f), high(2.0f, 0.0f, -1.0f);
    for (const int axis : {0, 1, 2}) {
        // The walls' velocities lie in the plane across `axis`.
        const auto along_walls = [&](glm::vec3 v) {
            return axis == 0 ? glm::vec3(0.0f, v.x, v.z) : axis == 1 ? v : glm::vec3(v.x, v.z, 0.0f);
        };
        for (const int cells : {16, 17}) {
            Sides sides = Sides::all(SideKind::periodic);
            side_of(sides, axis, 0) = {SideKind::no_slip, along_walls(low)};
            side_of(sides, axis, 1) = {SideKind::no_slip, along_walls(high)};
            Box box{.cells = {4, 4, 4}, .sides = sides};
            box.cells[axis] = cells;
            for (const double r : {1.0 / 12.0, 40.0}) {
                Workspace work = workspace(box);
                Field field(box.cell_count(), glm::vec4(0.0f)), next = field;
                const int steps = r < 1.0 ? 8000 : 60;
                for (int step = 0; step < steps; ++step) {
                    ASSERT_TRUE(diffuse(work, field, static_cast<float>(r), 1.0f, next));
                    std::swap(field, next);
                }
                double worst = 0.0;
                for_each_cell(box, [&](std::size_t n, glm::dvec3 x) {
                    const glm::dvec3 line =
                        glm::dvec3(along_walls(low)) + glm::dvec3(along_walls(high - low)) * (x[axis] / cells);
                    for (int c = 0; c < 3; ++c)
                        worst = std::max(worst, std::abs(field[n][c] - line[c]));
                });
                expect_at_most("diffusion_sides.couette_axis_" + std::to_string(axis) + "_cells_" + std::to_string(cells) +
                                   (r < 1.0 ? ".one_pass" : ".implicit"),
                               worst / 2.0, r < 1.0 ? 2e-5 : 1e-5);
            }
        }
    }
}

// Error after two swings, of the flow within 4 d of the wall, relative to the wall's speed. r is fixed, so dt falls as h^2.
double stokes_error(int cells, double r) {
    constexpr double k_depth = 8.0, k_frequency = 2.0, k_viscosity = 1.0; // d = 1 m
    const double h = k_depth / cells, ends = 4.0 * k_pi / k_frequency;
    const int steps = static_cast<int>(std::ceil(ends * k_viscosity / (r * h * h)));
    const double dt = ends / steps;
    Sides sides = Sides::all(SideKind::periodic);
    sides.y_low.kind = SideKind::no_slip;
    sides.y_high.kind = SideKind::free_slip;
    const Box box{.cells = {1, cells, 1}, .cell_size = static_cast<float>(h), .sides = sides};
    Workspace work = workspace(box);
    const auto exact = [&](glm::dvec3 x, double t) {
        return glm::dvec3(std::exp(-x.y) * std::cos(k_frequency * t - x.y), 0.0, 0.0);
    };
    Field field = sample(box, [&](glm::dvec3 x) { return exact(x, 0.0); }), next = field;
    for (int step = 0; step < steps; ++step) {
        // The wall as it is at the time whose neighbours the method reads: the old one in one pass, the new one implicitly.
        const double t = (r > 1.0 / 12.0 ? step + 1 : step) * dt;
        sides.y_low.wall_velocity = {static_cast<float>(std::cos(k_frequency * t)), 0.0f, 0.0f};
        EXPECT_TRUE(work.set_sides(sides));
        EXPECT_TRUE(diffuse(work, field, static_cast<float>(k_viscosity), static_cast<float>(dt), next));
        std::swap(field, next);
    }
    double squares = 0.0;
    int count = 0;
    for_each_cell(box, [&](std::size_t n, glm::dvec3 x) {
        if (x.y > 0.5 * k_depth)
            return;
        squares += std::pow(field[n].x - exact(x, ends).x, 2);
        ++count;
    });
    return std::sqrt(squares / count);
}

TEST(DiffusionSides, StokesSecondProblemIsSecondOrder) {
    for (const double r : {0.08, 0.3}) {
        const std::string name = r < 0.1 ? "diffusion_sides.stokes.one_pass." : "diffusion_sides.stokes.implicit.";
        const double e16 = stokes_error(16, r), e32 = stokes_error(32, r), e64 = stokes_error(64, r);
        figures::report(name + "error_16", e16);
        figures::report(name + "error_32", e32);
        expect_at_most(name + "error_64", e64, 2e-3);
        expect_at_least(name + "order_16_32", figures::order(e16, e32), 1.9);
        expect_at_least(name + "order_32_64", figures::order(e32, e64), 1.9);
    }
}

} // namespace
} // namespace windrow
