// Speed beside error: the schemes on one flow with a closed form, cost and error of the same runs.
//
//     windrow_accuracy_bench [threads]
//
// Flow: Taylor-Green vortices carried by a mean wind through a periodic box of 2 pi x 2 pi x pi on N x N x N/2 cells,
// with nu = 0.01 (cases/flows.h), to t = pi, at CFL 1.
// Error: |u - exact|_2 / |exact - mean|_2 over the cell centres at the end. The schemes' runs alternate; times are the least of
// three runs a step, and cost is relative to the classic split with linear interpolation on the same grid.
#include "cases/cell_values.h"
#include "cases/flows.h"
#include "fluid/thread_pool.h"
#include "fluid/wind.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>

namespace {

using windrow::Interpolation;
using windrow::Scheme;

constexpr double k_viscosity = 0.01;

struct TimedMethod {
    const char* name;
    Scheme scheme;
    Interpolation interpolation;
};
constexpr TimedMethod k_methods[] = {
    {"stable_fluids linear", Scheme::stable_fluids, Interpolation::linear},
    {"stable_fluids cubic", Scheme::stable_fluids, Interpolation::cubic},
    {"second_order cubic", Scheme::second_order, Interpolation::cubic},
};

const windrow::cases::TaylorGreen2D k_flow{.mean = {1.0, 0.5, 0.0}, .viscosity = k_viscosity};

struct TimedError {
    double step_ms = 1e30;
    double error = 0.0;
    int steps = 0;
};

void run(const TimedMethod& method, int cells, const windrow::ParallelFor& parallel_for, TimedError& outcome) {
    const double pi = std::numbers::pi, h = 2.0 * pi / cells;
    auto wind = windrow::Wind::create({.cells = {cells, cells, cells / 2},
                                       .cell_size = static_cast<float>(h),
                                       .boundaries = windrow::Boundaries::all(windrow::BoundaryKind::periodic),
                                       .centre = 0.5 * h * glm::dvec3(cells, cells, cells / 2),
                                       .viscosity = static_cast<float>(k_viscosity),
                                       .relaxation_time = 0.0f,
                                       .scheme = method.scheme,
                                       .interpolation = method.interpolation,
                                       .parallel_for = parallel_for});
    if (!wind)
        std::exit(2);
    wind->set_velocity([](glm::dvec3 centre) { return glm::vec3(k_flow(centre, 0.0)); });
    outcome.steps = static_cast<int>(std::lround(pi / (0.5 * h)));
    const double dt = pi / outcome.steps;
    for (int step = 0; step < outcome.steps; ++step) {
        const auto start = std::chrono::steady_clock::now();
        wind->step(dt);
        outcome.step_ms = std::min(outcome.step_ms,
                                   std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
    }
    outcome.error = windrow::cases::velocity_error(
        wind->box(), wind->field(), [&](glm::dvec3 x) { return k_flow(x, pi); }, k_flow.mean);
}

} // namespace

int main(int argc, char** argv) {
    windrow::ThreadPool pool(argc > 1 ? std::atoi(argv[1]) : 0);
    std::printf("Taylor-Green vortices in a mean wind to t = pi, CFL 1; %d threads\n", pool.size());
    std::printf("%-14s %-22s %6s %10s %8s %12s %10s\n", "grid", "scheme", "steps", "ms a step", "cost", "ms to t = pi", "error");
    for (const int cells : {16, 32, 64, 128}) {
        TimedError outcomes[std::size(k_methods)];
        for (int round = 0; round < 3; ++round)
            for (std::size_t n = 0; n < std::size(k_methods); ++n)
                run(k_methods[n], cells, pool.parallel_for(), outcomes[n]);
        for (std::size_t n = 0; n < std::size(k_methods); ++n)
            std::printf("%3dx%3dx%3d    %-22s %6d %10.3f %8.2f %12.1f %10.5f\n", cells, cells, cells / 2, k_methods[n].name,
                        outcomes[n].steps, outcomes[n].step_ms, outcomes[n].step_ms / outcomes[0].step_ms,
                        outcomes[n].step_ms * outcomes[n].steps, outcomes[n].error);
    }
}
