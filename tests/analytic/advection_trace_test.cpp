// The departure point: order 2 in the step.
//
// In solid rotation at a rate w(t) the linear sample of the wind is exact, so a wide Gaussian shows the trace's error alone.
//   steady     xd = x - dt/2 (u(x) + u(x - dt u(x)))                      angle error (w dt)^3 / 6 a step: order 2
//   unsteady   the same with 2 u - u_old at the foot (SETTLS)              order 2; with the wind frozen over the step, order 1
// Based on: Hortal 2002, ECMWF Technical Memorandum 292.
#include "figures.h"
#include "flows.h"

#include <numbers>

namespace windrow {
namespace {

using namespace flows;
using figures::expect_at_most;

enum class Trace { scalar, vector, frozen, settls };

struct Turn {
    /// rate = 2 pi (1 + unsteadiness (3 t^2 - 1)): one turn in unit time, faster at its end than at its start. (A rate that came
    /// back would hide a first-order error: the sum of a periodic function over its period is too good.)
    double unsteadiness = 0.0;
    double rate(double t) const { return 2.0 * std::numbers::pi * (1.0 + unsteadiness * (3.0 * t * t - 1.0)); }
};

// |value - start| / |start| of a Gaussian after one turn about the middle of a 2 m square.
double turn_error(int cells, int steps, Trace trace, const Turn& turn) {
    const BoundaryKind open = BoundaryKind::open, periodic = BoundaryKind::periodic;
    const Box box{.cells = {cells, cells, 1},
                  .cell_size = static_cast<float>(2.0 / cells),
                  .boundaries = sides_of({open, open}, {open, open}, {periodic, periodic})};
    Workspace work = workspace(box);
    const auto wind_at = [&](double t) {
        return velocities_of(box, [&](glm::dvec3 x) { return turn.rate(t) * glm::dvec3(1.0 - x.y, x.x - 1.0, 0.0); });
    };
    const auto start = velocities_of(box, [](glm::dvec3 x) {
        const double squared = (x.x - 1.35) * (x.x - 1.35) + (x.y - 1.0) * (x.y - 1.0);
        return glm::dvec3(0.0, 0.0, std::exp(-0.5 * squared / (0.13 * 0.13)));
    });
    std::vector<float> values(start.size()), next(start.size());
    Field field = start, moved = start;
    for (std::size_t n = 0; n < start.size(); ++n)
        values[n] = start[n].z;
    const double dt = 1.0 / steps;
    for (int step = 0; step < steps; ++step) {
        const Field wind = wind_at(step * dt), old = wind_at((step - 1) * dt);
        if (trace == Trace::scalar) {
            EXPECT_TRUE(advect(work, ScalarTransport{.carried = values, .velocity = wind, .dt = static_cast<float>(dt)}, next));
            std::swap(values, next);
        } else {
            Transport transport{.carried = field, .velocity = wind, .dt = static_cast<float>(dt)};
            if (trace == Trace::settls)
                transport.velocity_old = old;
            advect(work, transport, moved);
            std::swap(field, moved);
        }
    }
    double error = 0.0, size = 0.0;
    for (std::size_t n = 0; n < start.size(); ++n) {
        const double off = static_cast<double>(trace == Trace::scalar ? values[n] : field[n].z) - start[n].z;
        error += off * off;
        size += static_cast<double>(start[n].z) * start[n].z;
    }
    return std::sqrt(error / size);
}

TEST(AdvectionTrace, SteadyRotationIsSecondOrderInTheStep) {
    for (const Trace trace : {Trace::scalar, Trace::vector})
        figures::expect_orders(trace == Trace::scalar ? "trace.steady.scalar" : "trace.steady.vector", {48, 96, 192}, 1.9,
                               [&](int steps) { return turn_error(steps == 192 ? 256 : 128, steps, trace, {}); });
}

TEST(AdvectionTrace, SteadyRotationIsSecondOrderAtFixedCfl) {
    figures::expect_orders("trace.fixed_cfl", {64, 128, 256}, 1.9,
                           [](int cells) { return turn_error(cells, cells, Trace::vector, {}); });
}

TEST(AdvectionTrace, UnsteadyRotationIsSecondOrderWithTheLastWind) {
    const Turn turn{.unsteadiness = 0.3};
    figures::expect_orders("trace.unsteady", {64, 128, 256}, 1.9,
                           [&](int steps) { return turn_error(steps == 256 ? 256 : 128, steps, Trace::settls, turn); });
    const double f128 = turn_error(128, 128, Trace::frozen, turn), f256 = turn_error(256, 256, Trace::frozen, turn);
    figures::report("trace.frozen_wind.error_256_steps", f256);
    // What the last wind is for: without it the same run is of order 1.
    expect_at_most("trace.frozen_wind.order_128_256", figures::order(f128, f256), 1.4);
}

} // namespace
} // namespace windrow
