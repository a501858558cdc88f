// The whole step against exact solutions of Navier and Stokes' equations in periodic boxes of 2 pi (flows.h).
//
// Error = |u - exact|_2 / |exact - mean|_2 over the cell centres. At a fixed CFL number the second-order step is of order 2. At a
// fixed dt that goes to 0 its error in time is out of sight. What the weights take off in a step is h^4 s (1 - s) (1 + s) (2 - s)
// / 24 of the fourth derivative, s = |u| dt / h (cubic_factor.h), in T / dt steps |u| h^3 T / 12 of it: order 3. Numbers of steps
// are even: after an odd one a first step without history shows differently.
#include "cases/flows.h"
#include "cases/whole_step.h"

#include <algorithm>

namespace windrow::cases {
namespace {

template <class Flow>
VerifyRow run_flow(const VerifySetting& setting, const Box& box, const Flow& flow, double end, int steps) {
    const auto wind = wind_of(raw_config(box, flow.viscosity, setting), setting);
    wind->set_velocity([&](glm::dvec3 x) { return glm::vec3(flow(x, 0.0)); });
    VerifyRow row{.cells = box.cells};
    for (int step = 0; step < steps; ++step)
        row.cfl = std::max(row.cfl, static_cast<double>(wind->step(end / steps).cfl));
    row.error = velocity_error(
        box, wind->field(), [&](glm::dvec3 x) { return flow(x, end); }, flow.mean);
    return row;
}

// In each of the three planes, since each axis of the box is solved in its own way; the worst of them. No bound.
VerifyRow taylor_green_2d(const VerifySetting& setting, int size, int steps) {
    VerifyRow worst{.cells = {size, size, 1}};
    for (int normal = 0; normal < 3; ++normal) {
        TaylorGreen2D flow{.viscosity = 0.01, .a = (normal + 1) % 3, .b = (normal + 2) % 3};
        flow.mean[flow.a] = 1.0;
        flow.mean[flow.b] = 0.5;
        glm::ivec3 cells(size);
        cells[normal] = 1;
        const VerifyRow row = run_flow(setting, periodic_box(cells, 2.0 * k_pi / size), flow, k_pi, steps);
        worst.cfl = std::max(worst.cfl, row.cfl);
        worst.error = worse(worst.error, row.error);
    }
    return worst;
}

VerifyRow abc_flow(const VerifySetting& setting, int size, double viscosity, glm::dvec3 mean) {
    return run_flow(setting, periodic_box(glm::ivec3(size), 2.0 * k_pi / size),
                    ArnoldBeltramiChildress{.mean = mean, .viscosity = viscosity}, 0.375 * k_pi, 6 * size / 16);
}

VerifyRow bounded(VerifyRow row, double bound) {
    row.bound = bound;
    return row;
}

} // namespace

std::vector<VerifyCase> flow_cases() {
    return {
        {.name = "taylor_green_2d",
         .what = "Fading vortices in a mean wind that blows across the cells, in each of the three planes; the worst error of "
                 "the velocity without its mean.",
         .source = "Taylor & Green 1937, Proc. R. Soc. A 158; the mean wind is Galilean invariance",
         .reason = "the step is of order 2 in time and space; the bound is what it gave before steps of any length, 2.1e-3 at 64 "
                   "cells, and a fifth more, falling as h^2",
         .guards = true,
         .min_order = 1.9,
         .sizes = {32, 64, 128, 256},
         .run = [](const VerifySetting& setting,
                   int size) { return bounded(taylor_green_2d(setting, size, size), falling_bound(2.5e-3, 64, 2.0, size)); }},
        {.name = "taylor_green_2d_small_dt",
         .what = "The vortices of taylor_green_2d in 1024 steps at each resolution, so small that the error of space shows; the "
                 "worst error of the velocity without its mean.",
         .source = "Taylor & Green 1937, Proc. R. Soc. A 158; the mean wind is Galilean invariance",
         .reason = "at a dt that goes to 0 the cubic weights take |u| h^3 / 12 of the fourth derivative a second, order 3, while "
                   "gradient and divergence, of order 2, hardly show in these waves; measured are 4.7e-4 at 64 cells, of which a "
                   "fifth more is admitted, falling as h^2.9",
         .guards = true,
         .min_order = 2.9,
         .sizes = {16, 32, 64},
         .run = [](const VerifySetting& setting,
                   int size) { return bounded(taylor_green_2d(setting, size, 1024), falling_bound(5.6e-4, 64, 2.9, size)); }},
        {.name = "abc_flow",
         .what = "A flow in three dimensions that is its own curl and fades in place; error of the velocity.",
         .source = "Dombre et al. 1986, J. Fluid Mech. 167: u x curl u = 0, so that viscosity alone acts, as exp(-nu t)",
         .reason = "the step is of order 2; the bound is what it gave before steps of any length, 6.8e-3 at 16 cells, and "
                   "a fifth more, falling as h^1.9",
         .guards = true,
         .min_order = 1.9,
         .sizes = {16, 32, 64},
         .run =
             [](const VerifySetting& setting, int size) {
                 return bounded(abc_flow(setting, size, 0.01, {0.0, 0.0, 0.0}), falling_bound(8.2e-3, 16, 1.9, size));
             }},
        {.name = "abc_flow_carried",
         .what = "A flow in three dimensions that is its own curl, without viscosity, carried across the cells by a mean wind; "
                 "error of the velocity without its mean.",
         .source =
             "Dombre et al. 1986, J. Fluid Mech. 167: a steady flow of Euler's equations; the mean wind is Galilean invariance",
         .reason =
             "the step is of order 2; measured are 1.24e-2 at 16 cells, of which a fifth more is admitted, falling as h^1.9",
         .guards = true,
         .min_order = 1.9,
         .sizes = {16, 32, 64},
         .run =
             [](const VerifySetting& setting, int size) {
                 return bounded(abc_flow(setting, size, 0.0, {0.5, -0.3, 0.4}), falling_bound(1.5e-2, 16, 1.9, size));
             }},
    };
}

} // namespace windrow::cases
