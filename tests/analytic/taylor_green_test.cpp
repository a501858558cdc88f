// The whole step against exact solutions of Navier and Stokes' equations in periodic boxes of 2 pi.
//
//   Taylor-Green, carried   u = U0 + F sin(x - U0 t) cos(y - V0 t), v = V0 - F cos(x - U0 t) sin(y - V0 t), F = exp(-2 nu t);
//                           U0 = 1, V0 = 0.5, nu = 0.01, T = pi, dt = CFL h / 2
//   Taylor-Green, at rest   the same with U0 = V0 = 0: only the amplitude changes
//   ABC                     curl u = u in three dimensions, so that u . grad u is a gradient: amplitude exp(-nu t)
//
// Error = |u - exact|_2 / |exact - mean|_2 over the cell centres. Order 2 at fixed CFL; stable fluids order 1, held back by its
// split in time.
#include "case_check.h"
#include "flows.h"

#include <numbers>

namespace windrow {
namespace {

using namespace flows;
using figures::expect_at_least;
using figures::expect_at_most;

struct StepScheme {
    const char* name;
    Scheme scheme;
    Interpolation interpolation;
};
constexpr StepScheme k_second_order{"second_order", Scheme::second_order, Interpolation::cubic};
constexpr StepScheme k_of_32_cells{"cubic_32", Scheme::second_order, Interpolation::cubic_32};
constexpr StepScheme k_split_linear{"stable_fluids_linear", Scheme::stable_fluids, Interpolation::linear};
constexpr StepScheme k_split_cubic{"stable_fluids_cubic", Scheme::stable_fluids, Interpolation::cubic};

struct FlowErrors {
    double error = 0.0;
    /// Projection of u - mean on the exact field, over that field's square: how far the amplitude is off 1.
    double amplitude_error = 0.0;
};

template <class Flow>
FlowErrors run(const Box& box, const StepScheme& method, const Flow& flow, glm::dvec3 mean, double end, int steps) {
    Wind wind = raw_wind(box, flow.viscosity, method.scheme, method.interpolation);
    EXPECT_TRUE(wind.set_velocity(velocities_of(box, [&](glm::dvec3 x) { return flow(x, 0.0); })));
    for (int step = 0; step < steps; ++step)
        EXPECT_EQ(wind.step(end / steps).substeps, 1);
    double product = 0.0, square = 0.0;
    const auto field = wind.field();
    visit_cells(box, [&](std::size_t n, glm::dvec3 x) {
        const glm::dvec3 exact = flow(x, end) - mean;
        product += glm::dot(glm::dvec3(field[n]) - mean, exact);
        square += glm::dot(exact, exact);
    });
    return {velocity_error(
                box, field, [&](glm::dvec3 x) { return flow(x, end); }, mean),
            std::abs(product / square - 1.0)};
}

FlowErrors carried_vortices(int cells, double cfl, const StepScheme& method) {
    const Box box = periodic_box({cells, cells, 1}, 2.0 * std::numbers::pi / cells);
    return run(box, method, TaylorGreen2D{.mean = {1.0, 0.5, 0.0}, .viscosity = 0.01}, {1.0, 0.5, 0.0}, std::numbers::pi,
               static_cast<int>(std::lround(cells / cfl)));
}

TEST(TaylorGreen, CarriedVorticesAreSecondOrderAtFixedCfl) {
    figures::expect_case("taylor_green_2d", {32, 64, 128});
}

TEST(TaylorGreen, CarriedVorticesAtOtherCfl) {
    expect_at_most("tg2d.second_order.cfl_0.25.error_64", carried_vortices(64, 0.25, k_second_order).error, 8e-4);
    expect_at_most("tg2d.second_order.cfl_4.error_64", carried_vortices(64, 4.0, k_second_order).error, 0.03);
    figures::expect_orders("tg2d.second_order.cfl_0.25", {64, 128}, 1.9,
                           [](int cells) { return carried_vortices(cells, 0.25, k_second_order).error; });
}

// Of 64 cells that a cubic reads 32: the order stays, and the error is that of the cubic and a twentieth.
TEST(TaylorGreen, CarriedVorticesReadFrom32Cells) {
    figures::expect_orders("tg2d.cubic_32.cfl_1", {32, 64, 128}, 1.9,
                           [](int cells) { return carried_vortices(cells, 1.0, k_of_32_cells).error; });
    expect_at_most("tg2d.cubic_32_over_cubic_64",
                   carried_vortices(64, 1.0, k_of_32_cells).error / carried_vortices(64, 1.0, k_second_order).error, 1.05);
}

TEST(TaylorGreen, CarriedVorticesWithTheClassicSplit) {
    for (const auto& [method, least] : {std::pair(k_split_linear, 0.7), std::pair(k_split_cubic, 0.9)})
        figures::expect_orders(std::string("tg2d.") + method.name + ".cfl_1", {32, 64, 128}, least,
                               [&, method = method](int cells) { return carried_vortices(cells, 1.0, method).error; });
}

// Errors of a flow over three grids at one CFL. The number of steps is even on each: after an odd one a first step without history
// shows differently (flicker_test.cpp).
template <class Flow>
void expect_orders(const std::string& flow_name, const StepScheme& method, const Flow& flow, glm::bvec3 long_axes, int coarsest,
                   double end, int coarsest_steps, double least) {
    const std::string name = flow_name + "." + method.name;
    figures::expect_orders(name, {coarsest, 2 * coarsest, 4 * coarsest}, least, [&](int cells) {
        const glm::ivec3 all = glm::mix(glm::ivec3(1), glm::ivec3(cells), long_axes);
        const FlowErrors found = run(periodic_box(all, 2.0 * std::numbers::pi / cells), method, flow, glm::dvec3(0.0), end,
                                     coarsest_steps * cells / coarsest);
        figures::report(name + ".amplitude_error_" + std::to_string(cells), found.amplitude_error);
        return found.error;
    });
}

// Least order of a method.
double min_order_of(const StepScheme& method) {
    return method.scheme == Scheme::second_order ? 1.9 : method.interpolation == Interpolation::cubic ? 0.9 : 0.7;
}

constexpr glm::bvec3 k_slab(true, true, false), k_cube(true, true, true);

TEST(TaylorGreen, AmplitudeOfStandingVortices) {
    for (const StepScheme& method : {k_second_order, k_split_linear, k_split_cubic})
        expect_orders("tg2d.standing", method, TaylorGreen2D{.viscosity = 0.01}, k_slab, 32, 0.625 * std::numbers::pi, 10,
                      min_order_of(method));
}

TEST(TaylorGreen, AmplitudeOfAbcFlow) {
    for (const StepScheme& method : {k_second_order, k_of_32_cells, k_split_linear, k_split_cubic})
        expect_orders("abc", method, ArnoldBeltramiChildress{.viscosity = 0.01}, k_cube, 16, 0.375 * std::numbers::pi, 6,
                      min_order_of(method));
}

// Viscosity alone is first order in time (operators.h). Where it is strong that shows on fine grids, in any scheme.
TEST(TaylorGreen, StrongViscosityShowsItsFirstOrder) {
    expect_orders("tg2d.viscosity_0.05", k_second_order, TaylorGreen2D{.viscosity = 0.05}, k_slab, 32, 0.625 * std::numbers::pi,
                  10, 0.9);
    expect_orders("abc.viscosity_0.05", k_second_order, ArnoldBeltramiChildress{.viscosity = 0.05}, k_cube, 16,
                  0.375 * std::numbers::pi, 6, 0.9);
}

// Steps of a game's frames. Order 2 asks that the trajectories extrapolate over the whole of a longer step, that a first step
// hands on half of its pressure, and that what is wrong in the history dies (history.glsl): each left out makes the order 1.
TEST(TaylorGreen, UnevenStepsAreSecondOrder) {
    struct StepSequence {
        const char* name;
        std::function<double(int, Random&)> length; ///< of step n, in any unit
        double least = 1.9;                         ///< order
    };
    const StepSequence sequences[] = {
        {"equal", [](int, Random&) { return 1.0; }},
        {"5_percent_alternating", [](int n, Random&) { return n % 2 == 0 ? 0.95 : 1.05; }},
        {"2_to_1_alternating", [](int n, Random&) { return n % 2 == 0 ? 1.0 : 2.0; }},
        {"2_to_1_in_threes", [](int n, Random&) { return n / 3 % 2 == 0 ? 1.0 : 2.0; }},
        {"random_within_2", [](int, Random& random) { return std::exp2(random.real(-0.5, 0.5)); }},
        // Extrapolation ends at a ratio of 2, or the energy could grow: beyond it the order is about 1.
        {"4_to_1_alternating", [](int n, Random&) { return n % 2 == 0 ? 1.0 : 4.0; }, 0.9},
        {"random_within_8", [](int, Random& random) { return std::exp2(random.real(-1.5, 1.5)); }, 1.1},
    };
    const TaylorGreen2D flow{.mean = {1.0, 0.5, 0.0}, .viscosity = 0.01};
    for (const StepSequence& sequence : sequences) {
        figures::expect_orders(std::string("tg2d.uneven.") + sequence.name, {64, 128}, sequence.least, [&](int cells) {
            const Box box = periodic_box({cells, cells, 1}, 2.0 * std::numbers::pi / cells);
            Wind wind = raw_wind(box, flow.viscosity, Scheme::second_order, Interpolation::cubic);
            EXPECT_TRUE(wind.set_velocity(velocities_of(box, [&](glm::dvec3 x) { return flow(x, 0.0); })));
            Random random(5);
            std::vector<double> lengths(static_cast<std::size_t>(cells));
            double sum = 0.0;
            for (int step = 0; step < cells; ++step)
                sum += lengths[static_cast<std::size_t>(step)] = sequence.length(step, random);
            for (const double length : lengths)
                wind.step(std::numbers::pi * length / sum);
            return velocity_error(
                box, wind.field(), [&](glm::dvec3 x) { return flow(x, std::numbers::pi); }, flow.mean);
        });
    }
}

} // namespace
} // namespace windrow
