// Walls in the whole step. Ghosts are mirrored about the face, so
//   a free-slip box is one cell of a periodic box that was started mirrored: the same values to rounding;
//   Taylor-Green vortices fill a free-slip box of pi exactly; order 2;
//   the normal velocity at the face, taken from the two cells beside it, is 0 to order 2;
//   between no-slip walls sin(pi y / H) fades as exp(-nu (pi / H)^2 t); order 2 in h where dt falls as h^2;
//   a flow that starts mirrored between two walls stays mirrored.
#include "figures.h"
#include "flows.h"

#include <numbers>

namespace windrow {
namespace {

using namespace flows;
using figures::expect_at_most;

// A smooth solenoidal wind of a closed box of pi: its normal component is 0 on every wall, its others are even about them.
glm::dvec3 closed_wind(glm::dvec3 x) {
    const auto s = [](double a) { return std::sin(a); };
    const auto c = [](double a) { return std::cos(a); };
    return {s(x.x) * (2.0 * c(2.0 * x.y) + c(x.z)) + 0.4 * s(2.0 * x.x) * c(x.y) * c(x.z),
            -c(x.x) * s(2.0 * x.y) - 0.8 * c(2.0 * x.x) * s(x.y) * c(x.z), -c(x.x) * s(x.z)};
}

TEST(Walls, AFreeSlipBoxIsAnEighthOfAMirroredPeriodicBox) {
    const glm::ivec3 cells(16, 12, 15);
    const auto scaled = [](glm::dvec3 x, glm::ivec3 half) { return closed_wind(x * std::numbers::pi / glm::dvec3(half)); };
    for (const Scheme scheme : {Scheme::second_order, Scheme::stable_fluids})
        for (const double viscosity : {0.0, 0.05, 1.0}) {
            const Box closed{.cells = cells, .boundaries = Boundaries::all(k_slip)}, whole = periodic_box(2 * cells);
            Wind one = raw_wind(closed, viscosity, scheme, Interpolation::cubic),
                 eight = raw_wind(whole, viscosity, scheme, Interpolation::cubic);
            EXPECT_TRUE(one.set_velocity(velocities_of(closed, [&](glm::dvec3 x) { return scaled(x, cells); })));
            EXPECT_TRUE(eight.set_velocity(velocities_of(whole, [&](glm::dvec3 x) { return scaled(x, cells); })));
            take_steps(one, 60, 0.25);
            take_steps(eight, 60, 0.25);
            double worst = 0.0;
            for_each_cell(cells, [&](int i, int j, int k) {
                worst = std::max(worst,
                                 double(glm::length(one.field()[closed.index(i, j, k)] - eight.field()[whole.index(i, j, k)])));
            });
            expect_at_most(std::string("walls.mirrored_box_difference.") +
                               (scheme == Scheme::second_order ? "second_order." : "stable_fluids.") +
                               figures::number_text(viscosity),
                           worst, 1e-4);
        }
}

TEST(Walls, TaylorGreenVorticesFillAFreeSlipBox) {
    const TaylorGreen2D flow{.viscosity = 0.01};
    figures::expect_orders("walls.tg2d", {16, 32, 64}, 1.9, [&](int cells) {
        const Box box{.cells = {cells, cells, 1},
                      .cell_size = static_cast<float>(std::numbers::pi / cells),
                      .boundaries = sides_of({k_slip, k_slip}, {k_slip, k_slip}, {k_periodic, k_periodic})};
        Wind wind = raw_wind(box, flow.viscosity, Scheme::second_order, Interpolation::cubic);
        EXPECT_TRUE(wind.set_velocity(velocities_of(box, [&](glm::dvec3 x) { return flow(x, 0.0); })));
        const int steps = 10 * cells / 16; // even, CFL 1
        const double end = 0.625 * std::numbers::pi;
        take_steps(wind, steps, end / steps);
        return velocity_error(box, wind.field(), [&](glm::dvec3 x) { return flow(x, end); });
    });
}

// Root mean square over all walls of the normal velocity, extrapolated to the face from the two cells beside it.
double normal_velocity_at_walls(const Wind& wind) {
    const Box& box = wind.box();
    double squares = 0.0;
    int count = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const int a = (axis + 1) % 3, b = (axis + 2) % 3;
        for (int end = 0; end < 2; ++end)
            for (int p = 0; p < box.cells[a]; ++p)
                for (int q = 0; q < box.cells[b]; ++q, ++count) {
                    glm::ivec3 first, second;
                    first[a] = second[a] = p;
                    first[b] = second[b] = q;
                    first[axis] = end == 0 ? 0 : box.cells[axis] - 1;
                    second[axis] = end == 0 ? 1 : box.cells[axis] - 2;
                    const auto at = [&](glm::ivec3 cell) {
                        return static_cast<double>(wind.field()[box.index(cell.x, cell.y, cell.z)][axis]);
                    };
                    squares += std::pow(1.5 * at(first) - 0.5 * at(second), 2);
                }
    }
    return std::sqrt(squares / count);
}

TEST(Walls, NothingBlowsThroughAWall) {
    for (const BoundaryKind kind : {k_slip, k_rough})
        figures::expect_orders(std::string("walls.normal_velocity.") + (kind == k_slip ? "free_slip" : "no_slip"), {32, 64}, 1.9,
                               [&](int cells) {
                                   const Box box{.cells = glm::ivec3(cells),
                                                 .cell_size = static_cast<float>(std::numbers::pi / cells),
                                                 .boundaries = Boundaries::all(kind)};
                                   Wind wind = raw_wind(box, 0.02, Scheme::second_order, Interpolation::cubic);
                                   EXPECT_TRUE(wind.set_velocity(velocities_of(box, closed_wind)));
                                   take_steps(wind, cells / 4, 2.0 / cells);
                                   return normal_velocity_at_walls(wind) / rms(wind.field());
                               });
}

// u = sin(pi y / H) along the walls, carried sideways with them: the walls slide with the mean wind.
double shear_error(int cells, double end) {
    constexpr double k_viscosity = 0.05;
    const glm::vec3 sliding(0.5f, 0.0f, -0.25f);
    Boundaries boundaries = sides_of({k_periodic, k_periodic}, {k_rough, k_rough}, {k_periodic, k_periodic});
    boundaries.y_low.wall_velocity = boundaries.y_high.wall_velocity = sliding;
    const Box box{.cells = {4, cells, 4}, .cell_size = static_cast<float>(1.0 / cells), .boundaries = boundaries};
    Wind wind = raw_wind(box, k_viscosity, Scheme::second_order, Interpolation::cubic);
    const auto exact = [&](glm::dvec3 x, double t) {
        return glm::dvec3(sliding) + std::exp(-k_viscosity * std::numbers::pi * std::numbers::pi * t) *
                                         std::sin(std::numbers::pi * x.y) * glm::dvec3(1.0, 0.0, 0.5);
    };
    EXPECT_TRUE(wind.set_velocity(velocities_of(box, [&](glm::dvec3 x) { return exact(x, 0.0); })));
    const int steps = static_cast<int>(std::ceil(end * k_viscosity * cells * cells / 0.08));
    for (int step = 0; step < steps; ++step)
        EXPECT_EQ(wind.step(end / steps).diffusion, DiffusionMethod::one_pass);
    return velocity_error(
        box, wind.field(), [&](glm::dvec3 x) { return exact(x, end); }, glm::dvec3(sliding));
}

TEST(Walls, ShearBetweenSlidingNoSlipWallsFadesAtItsRate) {
    // At 64 cells the rounding of 5,000 steps would already show.
    const auto error = [](int cells) { return shear_error(cells, 2.0); };
    expect_at_most("walls.shear_error_32", figures::expect_orders("walls.shear", {8, 16, 32}, 1.9, error), 1e-3);
}

TEST(Walls, AMirroredFlowStaysMirrored) {
    for (const BoundaryKind kind : {k_slip, k_rough})
        for (const int cells : {24, 25}) {
            const Box box{.cells = {cells, 14, 18},
                          .boundaries = sides_of({kind, kind}, {k_slip, k_slip}, {k_periodic, k_periodic})};
            Wind wind = raw_wind(box, 0.0, Scheme::second_order, Interpolation::cubic);
            const glm::dvec3 size(box.cells);
            Field start = velocities_of(box, [&](glm::dvec3 x) {
                const glm::dvec3 p =
                    x * glm::dvec3(std::numbers::pi / size.x, std::numbers::pi / size.y, 2.0 * std::numbers::pi / size.z);
                return 1.5 * glm::dvec3(std::sin(2.0 * p.x) * std::cos(p.y),
                                        std::cos(2.0 * p.x) * std::sin(p.y) * (1.0 + std::sin(p.z)),
                                        std::cos(4.0 * p.x) * std::cos(p.y + p.z));
            });
            // Mirrored to the bit, whatever the sine's rounding.
            for_each_cell(box.cells, [&](int i, int j, int k) {
                const glm::vec4 from = start[box.index(cells - 1 - i, j, k)];
                if (2 * i >= cells - 1)
                    start[box.index(i, j, k)] = {2 * i == cells - 1 ? 0.0f : -from.x, from.y, from.z, 0.0f};
            });
            EXPECT_TRUE(wind.set_velocity(start));
            double worst = 0.0;
            for (int step = 1; step <= 200; ++step) {
                wind.step(0.3);
                if (step != 1 && step != 20 && step != 200)
                    continue;
                worst = 0.0;
                for_each_cell(box.cells, [&](int i, int j, int k) {
                    const glm::vec4 here = wind.field()[box.index(i, j, k)], there = wind.field()[box.index(cells - 1 - i, j, k)];
                    worst = std::max(worst, static_cast<double>(glm::length(here - glm::vec4(-there.x, there.y, there.z, 0.0f))));
                });
                const std::string name = std::string("walls.asymmetry.") + (kind == k_slip ? "free_slip_" : "no_slip_") +
                                         std::to_string(cells) + ".step_" + std::to_string(step);
                if (step == 200)
                    figures::report(name, worst);
                else
                    expect_at_most(name, worst, step == 1 ? 2e-6 : 2e-5);
            }
        }
}

} // namespace
} // namespace windrow
