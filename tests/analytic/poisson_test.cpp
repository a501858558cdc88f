// The direct pressure solve, L phi = b, against an independent 7-point stencil in double.
//
// Residual |b - L phi| / |b| (b without its mean where no side is open). Rounding phi to float alone leaves up to
// 12 eps |phi| / |b| with eps = 6e-8 and |phi| / |b| as large as 1 / lambda_1. Where the lowest mode of a long or closed box
// carries much of b that is more than 1e-5; so larger boxes are held to 5e-7 of |b| + 12 |phi|, and in the error of phi and of
// grad phi against a conjugate gradient in double.
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

// Every pair of ends that an axis may have; the first five differ for the pressure, to which both walls are one.
constexpr BoundaryKind k_pairs[10][2] = {{k_open, k_open},         {k_slip, k_slip},  {k_open, k_slip},  {k_slip, k_open},
                                         {k_periodic, k_periodic}, {k_slip, k_rough}, {k_rough, k_slip}, {k_rough, k_rough},
                                         {k_open, k_rough},        {k_rough, k_open}};
constexpr std::array k_tiny = {glm::ivec3(1, 1, 1), glm::ivec3(1, 5, 7), glm::ivec3(2, 2, 2), glm::ivec3(3, 1, 4)};
constexpr std::array k_solved_sizes = {glm::ivec3(17, 9, 23), glm::ivec3(20, 6, 40), glm::ivec3(48, 5, 33),
                                       glm::ivec3(64, 1, 64)};

Boundaries mixed_kinds(int x, int y, int z) {
    return sides_of({k_pairs[x][0], k_pairs[x][1]}, {k_pairs[y][0], k_pairs[y][1]}, {k_pairs[z][0], k_pairs[z][1]});
}

struct SolvedNoise {
    double residual = 0.0; ///< |b - L phi| / |b|
    double scaled = 0.0;   ///< |b - L phi| / (|b| + 12 |phi|)
    Values phi, left;
    Stencil stencil;
};

// Solves with h = 1 for random b.
SolvedNoise solve_noise(const Box& box, Random& random) {
    Workspace work = workspace(box);
    SolvedNoise solved{.phi = {}, .left = {}, .stencil = Stencil::pressure(box)};
    auto values = scalars_of(box, [&](glm::dvec3) { return random.real(-1.0, 1.0); });
    Values b(values.begin(), values.end());
    if (solved.stencil.singular())
        Stencil::remove_mean(b);
    solve_poisson(work, values);
    solved.phi.assign(values.begin(), values.end());
    solved.left = solved.stencil.laplacian(solved.phi);
    for (std::size_t n = 0; n < b.size(); ++n)
        solved.left[n] = b[n] - solved.left[n];
    const double size = Stencil::norm(b), residual = Stencil::norm(solved.left);
    // A single cell without an open boundary has nothing to solve: b is its mean, phi is 0.
    solved.residual = size > 0.0 ? residual / size : residual + Stencil::norm(solved.phi);
    solved.scaled = residual / (size + 12.0 * Stencil::norm(solved.phi) + 1e-300);
    return solved;
}

TEST(Poisson, EveryMixOfSidesOfATinyBoxIsSolved) {
    Random random(1);
    double worst = 0.0;
    int count = 0;
    for (const glm::ivec3 cells : k_tiny)
        for (int n = 0; n < 1000; ++n, ++count)
            worst = std::max(
                worst, solve_noise({.cells = cells, .boundaries = mixed_kinds(n % 10, n / 10 % 10, n / 100)}, random).residual);
    figures::report("poisson.tiny_boxes", count);
    expect_at_most("poisson.tiny_residual", worst, 1e-5);
}

TEST(Poisson, EveryMixOfSidesOfALargerBoxIsSolved) {
    Random random(2);
    for (const glm::ivec3 cells : k_solved_sizes) {
        double worst = 0.0, worst_scaled = 0.0;
        for (int n = 0; n < 125; ++n) {
            const SolvedNoise solved = solve_noise({.cells = cells, .boundaries = mixed_kinds(n % 5, n / 5 % 5, n / 25)}, random);
            worst = std::max(worst, solved.residual);
            worst_scaled = std::max(worst_scaled, solved.scaled);
        }
        const std::string name = std::to_string(cells.x) + "x" + std::to_string(cells.y) + "x" + std::to_string(cells.z);
        figures::report("poisson.residual." + name, worst);
        expect_at_most("poisson.residual_scaled." + name, worst_scaled, 5e-7);
    }
}

// What the residual stands for: L e = left over. The gradient is the difference to each neighbour, all of them in the energy e .
// L e. In the two slender boxes a single lowest mode may hold nearly all of phi; there the gradient of the error is held against
// the error that rounding the exact phi to float would make.
TEST(Poisson, PhiAndItsGradientAgreeWithADoubleSolve) {
    Random random(3);
    double worst_phi = 0.0, worst_gradient = 0.0, worst_slender = 0.0, worst_over_rounding = 0.0;
    for (const glm::ivec3 cells : k_solved_sizes)
        for (int n = 0; n < 125; ++n) {
            const SolvedNoise solved = solve_noise({.cells = cells, .boundaries = mixed_kinds(n % 5, n / 5 % 5, n / 25)}, random);
            const Stencil& stencil = solved.stencil;
            const Values error = stencil.solve(0.0, solved.left, 1e-3);
            Values rounding(error.size());
            for (std::size_t m = 0; m < error.size(); ++m) {
                const double exact = solved.phi[m] - error[m];
                rounding[m] = static_cast<double>(static_cast<float>(exact)) - exact;
            }
            const auto slope = [&](const Values& v) { return std::sqrt(std::abs(Stencil::dot(v, stencil.laplacian(v)))); };
            worst_phi = std::max(worst_phi, Stencil::norm(error) / Stencil::norm(solved.phi));
            double& worst = cells.x >= 48 ? worst_slender : worst_gradient;
            worst = std::max(worst, slope(error) / slope(solved.phi));
            worst_over_rounding = std::max(worst_over_rounding, slope(error) / slope(rounding));
        }
    expect_at_most("poisson.phi_error", worst_phi, 2e-6);
    expect_at_most("poisson.gradient_error", worst_gradient, 1e-5);
    figures::report("poisson.gradient_error_slender", worst_slender);
    expect_at_most("poisson.gradient_error_over_rounding", worst_over_rounding, 20.0);
}

TEST(Poisson, ABoxWithoutAnOpenSideGivesMeanZero) {
    Random random(4);
    double worst = 0.0;
    for (const int y : {1, 4})
        for (const int x : {1, 4, 7})
            for (const glm::ivec3 cells : k_solved_sizes) {
                const Box box{.cells = cells, .boundaries = mixed_kinds(x, y, x)};
                Workspace work = workspace(box);
                // A large mean: it must leave no trace in phi.
                auto values = scalars_of(box, [&](glm::dvec3) { return 10.0 + random.real(-1.0, 1.0); });
                solve_poisson(work, values);
                double mean = 0.0;
                for (const float v : values)
                    mean += v / static_cast<double>(values.size());
                worst = std::max(worst, std::abs(mean) / rms(std::span<const float>(values)));
            }
    expect_at_most("poisson.mean_over_rms", worst, 1e-4);
}

TEST(Poisson, AManufacturedSolutionIsSecondOrder) {
    for (const char* const name :
         {"poisson_open", "poisson_closed", "poisson_periodic", "poisson_over_floor", "poisson_mixed", "poisson_on_grid"})
        figures::expect_case(name, {1, 3, 9});
}

// Six Gaussian jets over a floor, the other sides and the top open; b is the divergence of their wind. Box 32 x 16 x 32 m; the
// jets, 1.5 m wide, point along +x, -x, +z, -z, up and down, and stand off the middle so that nothing cancels.
Field six_jets(const Box& box) {
    struct GaussianJet {
        glm::dvec3 place, wind;
    };
    const GaussianJet jets[6] = {{{9, 6, 10}, {8, 0, 0}},   {{22, 5, 21}, {-6, 0, 0}}, {{12, 9, 23}, {0, 0, 7}},
                                 {{20, 10, 8}, {0, 0, -9}}, {{7, 4, 19}, {0, 5, 0}},   {{25, 11, 14}, {0, -4, 0}}};
    return velocities_of(box, [&](glm::dvec3 x) {
        glm::dvec3 wind(0.0);
        for (const GaussianJet& jet : jets)
            wind += std::exp(-0.5 * glm::dot(x - jet.place, x - jet.place) / (1.5 * 1.5)) * jet.wind;
        return wind;
    });
}

TEST(Poisson, SixJetsOverAFloor) {
    for (const auto& [cells, bound] : {std::pair(32, 1e-5), std::pair(64, 3e-5), std::pair(128, 2e-4)}) {
        const Box box{.cells = {cells, cells / 2, cells},
                      .cell_size = 32.0f / static_cast<float>(cells),
                      .boundaries = Boundaries::open_over_floor()};
        Workspace work = workspace(box);
        std::vector<float> values(box.cell_count());
        divergence(work, six_jets(box), values);
        const double h = box.cell_size;
        const Values b(values.begin(), values.end());
        solve_poisson(work, values);
        Values left = Stencil::pressure(box).laplacian(Values(values.begin(), values.end()));
        for (std::size_t n = 0; n < b.size(); ++n)
            left[n] = b[n] - left[n] / (h * h);
        expect_at_most("poisson.six_jets_residual_" + std::to_string(cells), Stencil::norm(left) / Stencil::norm(b), bound);
    }
}

} // namespace
} // namespace windrow
