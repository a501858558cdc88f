// Taylor and Green's vortices in three dimensions: box 2 pi, u = sin x cos y cos z, v = -cos x sin y cos z, w = 0, nu = 1/200, up
// to T = 3, where the vortices have stretched into sheets but the flow is still smooth. dt = T / ceil(T / h): CFL 1 at most.
//
// Reference: pseudo-spectral, spectral_flow.h, at the cell centres. Error = |u - u_ref|_2 / |u_ref|_2, order 2 and more.
// 64^3 points are themselves 0.003 from converged, so the bounds are held against 80^3.
#include "case_check.h"
#include "cases/spectral_solutions.h"
#include "flows.h"

#include <numbers>

namespace windrow {
namespace {

using namespace flows;
using figures::expect_at_least;
using figures::expect_at_most;
using reference::SpectralFlow;

constexpr double k_viscosity = cases::k_sheets_viscosity, k_end = cases::k_sheets_end;
constexpr auto vortices = cases::taylor_green_3d_start;

cases::SpectralSolution solved(int points, int steps) {
    return cases::solved(glm::ivec3(points), k_viscosity, vortices, {}, k_end, steps);
}

// The reference against exact flows and against itself, before it judges anything.
TEST(SpectralReference, KeepsAbcFlowExactly) {
    const ArnoldBeltramiChildress abc{.viscosity = 0.1};
    SpectralFlow flow(glm::ivec3(16), abc.viscosity);
    flow.start([&](glm::dvec3 x) { return abc(x, 0.0); });
    flow.run(1.0, 20);
    const auto computed = flow.at_cell_centres({8, 16, 8});
    std::size_t n = 0;
    double worst = 0.0;
    for_each_cell({8, 16, 8}, [&](int i, int j, int k) {
        const glm::dvec3 off =
            computed[n++] - abc(2.0 * std::numbers::pi * glm::dvec3((i + 0.5) / 8.0, (j + 0.5) / 16.0, (k + 0.5) / 8.0), 1.0);
        worst = std::max(worst, glm::length(off));
    });
    expect_at_most("spectral.abc_error", worst, 1e-10);
}

TEST(SpectralReference, CarriesTaylorGreenAtFourthOrder) {
    const TaylorGreen2D exact{.mean = {1.0, 0.5, 0.0}, .viscosity = 0.05};
    double errors[2];
    for (int level = 0; level < 2; ++level) {
        SpectralFlow flow({24, 24, 1}, exact.viscosity);
        flow.start([&](glm::dvec3 x) { return exact(x, 0.0); });
        flow.run(2.0, 20 << level);
        const auto computed = flow.at_cell_centres({12, 24, 1});
        double squares = 0.0;
        for (int j = 0; j < 24; ++j)
            for (int i = 0; i < 12; ++i) {
                const glm::dvec3 off = computed[j * 12 + i] -
                                       exact(2.0 * std::numbers::pi * glm::dvec3((i + 0.5) / 12.0, (j + 0.5) / 24.0, 0.0), 2.0);
                squares += glm::dot(off, off);
            }
        errors[level] = std::sqrt(squares / (12 * 24));
    }
    expect_at_most("spectral.tg2d_error", errors[1], 1e-6);
    expect_at_least("spectral.tg2d_order_in_time", figures::order(errors[0], errors[1]), 3.8);
}

TEST(SpectralReference, LongHasConvergedAtTheEnd) {
    const glm::ivec3 cells(32);
    expect_at_most("spectral.tg3d_change_at_half_as_many_steps",
                   relative_error(solved(48, 30)->at_cell_centres(cells), solved(48, 60)->at_cell_centres(cells)), 1e-4);
    // 96^3 and 108^3 move the reference by less than a tenth of this once more.
    const auto u = cases::taylor_green_3d_end().at_cell_centres(cells);
    expect_at_most("spectral.tg3d_change_from_64_to_80_cubed", relative_error(solved(64, 30)->at_cell_centres(cells), u), 4e-3);
    // Mirrors of the start: u(-x) = -u(x), w odd in z, and x and y exchanged.
    double worst = 0.0;
    const auto at = [&](int i, int j, int k) { return u[(static_cast<std::size_t>(k) * 32 + j) * 32 + i]; };
    for_each_cell(cells, [&](int i, int j, int k) {
        const glm::dvec3 here = at(i, j, k), across = at(31 - i, j, k), below = at(i, j, 31 - k);
        worst = std::max({worst, glm::length(here - glm::dvec3(-across.x, across.y, across.z)),
                          glm::length(here - glm::dvec3(below.x, below.y, -below.z))});
    });
    expect_at_most("spectral.tg3d_asymmetry", worst, 1e-9);
}

double split_error(int cells) {
    const Box box = periodic_box(glm::ivec3(cells), 2.0 * std::numbers::pi / cells);
    Wind wind = raw_wind(box, k_viscosity, Scheme::stable_fluids, Interpolation::cubic);
    EXPECT_TRUE(wind.set_velocity(velocities_of(box, vortices)));
    const int steps = static_cast<int>(std::ceil(k_end / static_cast<double>(box.cell_size)));
    const Diagnostics last = take_steps(wind, steps, k_end / steps);
    EXPECT_EQ(last.substeps, 1);
    figures::report("tg3d.stable_fluids.h_div_over_rms_" + std::to_string(cells),
                    last.divergence_rms * static_cast<double>(box.cell_size) / rms(wind.field()));
    return relative_error(wind.field(), cases::taylor_green_3d_end().at_cell_centres(glm::ivec3(cells)));
}

TEST(TaylorGreen3D, ErrorAgainstTheSpectralReference) {
    expect_at_most("tg3d.stable_fluids.finest", figures::expect_orders("tg3d.stable_fluids", {32, 64}, 0.9, split_error), 0.05);
    // 0.0326 before steps might be of any length, of which 8 % more is admitted: what the start and the damped history cost.
    figures::expect_case("taylor_green_3d", {32, 64});
}

} // namespace
} // namespace windrow
