// Projection onto divergence-free fields: u -= grad phi, L phi = div u, collocated and therefore approximate.
//
// Divergence and gradient span two cells, L one: D G acts on a mode as sin^2(theta), L as 4 sin^2(theta / 2). So a gradient is
// removed, a solenoidal field kept and the divergence brought to zero up to h^2, and these slopes are what is asked here.
// In Fourier's space and in one dimension the part of a gradient that stays is 1 - sin^2(theta) / (4 sin^2(theta / 2)) =
// sin^2(theta / 2).
#include "case_check.h"
#include "flows.h"

#include <numbers>

namespace windrow {
namespace {

using namespace flows;
using figures::expect_at_least;
using figures::expect_at_most;

Box cube(int cells, const Boundaries& boundaries = Boundaries::all(BoundaryKind::periodic)) {
    return {.cells = {cells, cells, cells},
            .cell_size = static_cast<float>(2.0 * std::numbers::pi / cells),
            .boundaries = boundaries};
}

double change(Workspace& work, const Field& before) {
    Field after = before;
    project(work, after);
    for (std::size_t n = 0; n < after.size(); ++n)
        after[n] -= before[n];
    return rms(after) / rms(before);
}

TEST(Projection, TaylorAndGreensFieldIsKept) {
    Workspace work = workspace(cube(64));
    const TaylorGreen2D flow;
    // Its central divergence is zero to rounding, not only to h^2.
    expect_at_most("projection.change_of_taylor_green_64",
                   change(work, velocities_of(work.box(), [&](glm::dvec3 x) { return flow(x, 0.0); })), 1e-5);
}

// Solenoidal, with unlike waves along its axes, so that the central divergence is not zero but of order h^2.
glm::dvec3 solenoidal(glm::dvec3 x) {
    return {2.0 * std::sin(x.x) * std::cos(2.0 * x.y) + std::cos(3.0 * x.z),
            -std::cos(x.x) * std::sin(2.0 * x.y) + std::sin(2.0 * x.x) * std::cos(x.z), 2.0 * std::cos(2.0 * x.x + x.y)};
}

// grad sin(x + 1) cos(2 y) sin(z + y)
glm::dvec3 gradient(glm::dvec3 x) {
    const double sx = std::sin(x.x + 1.0), cy = std::cos(2.0 * x.y), sz = std::sin(x.z + x.y), cz = std::cos(x.z + x.y);
    return {std::cos(x.x + 1.0) * cy * sz, sx * (-2.0 * std::sin(2.0 * x.y) * sz + cy * cz), sx * cy * cz};
}

TEST(Projection, ASolenoidalFieldIsKeptToSecondOrder) {
    figures::expect_case("solenoidal_stays", {32, 64, 128});
}

TEST(Projection, AGradientIsRemovedToSecondOrder) {
    figures::expect_case("gradient_vanishes", {32, 64, 128});
}

// A discrete gradient of one wave: what stays is sin^2(theta / 2) of it, all of it at the checkerboard, nothing at long waves.
TEST(Projection, ADiscreteGradientLeavesTheCompactWideDifference) {
    const Box box = periodic_box({32, 4, 6});
    Workspace work = workspace(box);
    double worst = 0.0;
    for (int k = 1; k < 16; ++k) {
        const double theta = 2.0 * std::numbers::pi * k / 32;
        Field field =
            velocities_of(box, [&](glm::dvec3 x) { return glm::dvec3(std::sin(theta) * std::cos(theta * x.x), 0.0, 0.0); });
        const double before = rms(field);
        project(work, field);
        worst = std::max(worst, std::abs(rms(field) / before - std::pow(std::sin(0.5 * theta), 2)));
    }
    expect_at_most("projection.discrete_gradient_factor_error", worst, 1e-5);
}

TEST(Projection, TheGradientHandedOutIsWhatWasTaken) {
    Random random(9);
    for (const Boundaries& boundaries :
         {Boundaries::all(BoundaryKind::periodic), Boundaries::open_over_floor(), Boundaries::all(BoundaryKind::no_slip)}) {
        const Box box{.cells = {17, 9, 23}, .cell_size = 0.3f, .boundaries = boundaries};
        Workspace work = workspace(box, {1.0f, 0.0f, 0.5f});
        const Field before = random_field(random, box);
        Field after = before, taken(before.size());
        project(work, after, taken);
        for (std::size_t n = 0; n < before.size(); ++n)
            taken[n] = before[n] - taken[n];
        expect_at_most("projection.gradient_handed_out_error", largest_apart(taken, after), 1e-6);
    }
}

// Left over after one projection of a smooth field that is half gradient: div u / rms(u) falls as h^2.
TEST(Projection, TheDivergenceFloorFallsWithTheCell) {
    const BoundaryKind open = BoundaryKind::open, wall = BoundaryKind::free_slip, periodic = BoundaryKind::periodic;
    const std::pair<const char*, Boundaries> boxes[] = {
        {"periodic", Boundaries::all(periodic)},
        {"channel", sides_of({periodic, periodic}, {wall, wall}, {periodic, periodic})},
        {"open", Boundaries::all(open)}};
    for (const auto& [name, boundaries] : boxes)
        figures::expect_orders(
            std::string("projection.floor_div.") + name, {48, 96}, 1.9, [&, boundaries = boundaries](int cells) {
                const Box box = cube(cells, boundaries);
                Workspace work = workspace(box);
                // Away from periodic boundaries the air is at rest at the sides: the flow through them is asked for below.
                const bool everywhere = boundaries == Boundaries::all(periodic);
                Field field = velocities_of(box, [&](glm::dvec3 x) {
                    const glm::dvec3 u = solenoidal(x) + gradient(x);
                    return everywhere ? u : u * std::pow(std::sin(0.5 * x.x) * std::sin(0.5 * x.y) * std::sin(0.5 * x.z), 4.0);
                });
                project(work, field);
                std::vector<float> left(box.cell_count());
                divergence(work, field, left);
                return rms(std::span<const float>(left)) / rms(field);
            });
}

// Air that blows through the sides: phi is 0 at the ghosts' centres, the air is free to leave. What project() leaves of a
// solenoidal wind plus a gradient must be the wind: to second order inside, and in the outermost cells, whose central difference
// has one side only, to first.
TEST(Projection, OpenSidesLetTheAirThroughToSecondOrder) {
    const BoundaryKind open = BoundaryKind::open, wall = BoundaryKind::free_slip, periodic = BoundaryKind::periodic;
    const std::pair<const char*, Boundaries> boxes[] = {
        {"open", sides_of({open, open}, {open, open}, {periodic, periodic})},
        {"over_floor", sides_of({open, open}, {wall, open}, {periodic, periodic})}};
    for (const auto& [name, boundaries] : boxes) {
        double inner[2], edge[2];
        for (int level = 0; level < 2; ++level) {
            const int cells = 64 << level;
            const Box box{.cells = {cells, cells, 1}, .cell_size = static_cast<float>(1.0 / cells), .boundaries = boundaries};
            Workspace work = workspace(box);
            const bool floor = boundaries.y_low.solid();
            const auto through = [&](glm::dvec3 x) { // solenoidal; over a floor its v is 0 at y = 0
                return floor ? glm::dvec3(std::sin(2.0 * x.x + 1.0) * std::cos(2.0 * x.y),
                                          -std::cos(2.0 * x.x + 1.0) * std::sin(2.0 * x.y), 0.0)
                             : glm::dvec3(std::sin(2.0 * x.y + 1.0), std::cos(3.0 * x.x), 0.0);
            };
            // pi phi = sin(kx x) sin(ky y), or sin(kx x) cos(ky y) over a floor, x and y from where it is 0, or from the floor
            const double h = 1.0 / cells, kx = std::numbers::pi / (1.0 + h),
                         ky = floor ? 0.5 * std::numbers::pi / (1.0 + 0.5 * h) : kx;
            Field field = velocities_of(box, [&](glm::dvec3 x) {
                const double sx = std::sin(kx * (x.x + 0.5 * h)), cx = std::cos(kx * (x.x + 0.5 * h));
                const double y = ky * (floor ? x.y : x.y + 0.5 * h);
                const double fy = floor ? std::cos(y) : std::sin(y), dy = floor ? -std::sin(y) : std::cos(y);
                return through(x) + glm::dvec3(kx * cx * fy, ky * sx * dy, 0.0) / std::numbers::pi;
            });
            project(work, field);
            double squares[2] = {};
            int count[2] = {};
            visit_cells(box, [&](std::size_t n, glm::dvec3 x) {
                const bool outermost = std::min({x.x, x.y, 1.0 - x.x, 1.0 - x.y}) < 1.0 / cells;
                const glm::dvec3 off = glm::dvec3(field[n]) - through(x);
                squares[outermost] += glm::dot(off, off);
                ++count[outermost];
            });
            inner[level] = std::sqrt(squares[0] / count[0]);
            edge[level] = std::sqrt(squares[1] / count[1]);
            figures::report(std::string("projection.") + name + ".inner_error_" + std::to_string(cells), inner[level]);
            figures::report(std::string("projection.") + name + ".outermost_error_" + std::to_string(cells), edge[level]);
        }
        expect_at_least(std::string("projection.") + name + ".inner_order_64_128", figures::order(inner[0], inner[1]), 1.9);
        expect_at_least(std::string("projection.") + name + ".outermost_order_64_128", figures::order(edge[0], edge[1]), 0.9);
    }
}

// Divergence and gradient are each other's adjoint (up to the sign) and L outweighs their product, so a projection can only take
// energy from the air. Where they are not adjoint, a smooth wind gains.
TEST(Projection, NoSideAddsEnergy) {
    Random random(15);
    const BoundaryKind open = BoundaryKind::open, wall = BoundaryKind::free_slip, periodic = BoundaryKind::periodic;
    const BoundaryKind pairs[5][2] = {{open, open}, {wall, wall}, {open, wall}, {wall, open}, {periodic, periodic}};
    double worst = 0.0;
    for (int n = 0; n < 125; ++n) {
        const auto& x = pairs[n % 5];
        const auto& y = pairs[n / 5 % 5];
        const auto& z = pairs[n / 25];
        const Box box{.cells = {20, 13, 16}, .boundaries = sides_of({x[0], x[1]}, {y[0], y[1]}, {z[0], z[1]})};
        Workspace work = workspace(box);
        for (int trial = 0; trial < 6; ++trial) {
            // Noise, and long waves across each component, which have no divergence inside and blow through the sides.
            const glm::dvec2 k[3] = {{random.real(-1.0, 1.0), random.real(-1.0, 1.0)},
                                     {random.real(-1.0, 1.0), random.real(-1.0, 1.0)},
                                     {random.real(-1.0, 1.0), random.real(-1.0, 1.0)}};
            const double phase = random.real(-3.0, 3.0);
            Field field = trial == 0 ? random_field(random, box) : velocities_of(box, [&](glm::dvec3 p) {
                return glm::dvec3(std::sin(k[0].x * p.y + k[0].y * p.z + phase), std::sin(k[1].x * p.x + k[1].y * p.z - phase),
                                  std::cos(k[2].x * p.x + k[2].y * p.y + phase));
            });
            const double before = rms(field);
            project(work, field);
            worst = std::max(worst, rms(field) / before);
        }
    }
    expect_at_most("projection.largest_energy_ratio", worst * worst, 1.0 + 1e-6);
}

// In a closed box no air comes or goes: the divergence of any field whatever sums to nothing.
TEST(Projection, NoAirPassesAWall) {
    Random random(14);
    for (const Boundaries& boundaries :
         {Boundaries::all(BoundaryKind::free_slip), Boundaries::all(BoundaryKind::no_slip),
          sides_of({BoundaryKind::periodic, BoundaryKind::periodic}, {BoundaryKind::no_slip, BoundaryKind::free_slip},
                   {BoundaryKind::free_slip, BoundaryKind::free_slip})}) {
        const Box box{.cells = {17, 9, 23}, .boundaries = boundaries};
        Workspace work = workspace(box);
        std::vector<float> values(box.cell_count());
        divergence(work, random_field(random, box), values);
        double sum = 0.0, size = 0.0;
        for (const float v : values) {
            sum += v;
            size += std::abs(static_cast<double>(v));
        }
        expect_at_most("projection.net_flux_through_walls", std::abs(sum) / size, 1e-7);
    }
}

} // namespace
} // namespace windrow
