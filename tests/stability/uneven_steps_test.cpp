// Steps whose length alternates by a factor of 1000 or more while motors push: the history of a short step meets a long one, and
// the other way round. Without motors: hard_cases_test.cpp.

#include "fluid/wind.h"
#include "tests/fields.h"
#include "tests/stability/watch.h"

#include <functional>
#include <gtest/gtest.h>
#include <string>

namespace {

using namespace windrow;
using namespace windrow::test;

constexpr double k_factor = 2.5; // as in opposed_motors_test.cpp

void expect_bounded(const std::string& name, int steps, float max_cfl, const std::function<double(int)>& dt_of) {
    for (int kind = 0; kind < 4; ++kind)
        for (const Scheme scheme : {Scheme::second_order, Scheme::stable_fluids}) {
            Wind wind = made({.cells = {20, 12, 16},
                              .sides = Sides::all(k_kinds[kind]),
                              .viscosity = 0.1f,
                              .scheme = scheme,
                              .max_cfl = max_cfl});
            drive(wind, {0.0, 0.0, 0.0}, {1.0f, 0.3f, 0.0f}, 10.0f);
            add(wind, DirectionalMotor{.position = {4.0, 0.0, 0.0}, .direction = {0.0f, 1.0f, 0.0f}, .law = Force{1.0f}});
            Watch watch(wind, 10.0); // the force pushes a sideward metre a second into air that crosses it in one
            for (int n = 0; n < shortened(steps); ++n)
                watch.step(dt_of(n));
            watch.judge(name + '_' + k_kind_names[kind] + (scheme == Scheme::stable_fluids ? "_stable_fluids" : ""),
                        {k_input_energy, k_factor});
        }
}

TEST(UnevenSteps, AlternatingByAThousand) {
    expect_bounded("steps_alternating", 1'500, 2.0f, [](int n) { return n % 2 == 0 ? 1e-3 : 1.0; });
}

TEST(UnevenSteps, LogUniform) {
    Random random(71);
    expect_bounded("steps_log_uniform", 1'000, 2.0f, [&](int) { return random.spread(1e-5, 10.0); });
    expect_bounded("steps_log_uniform_raw", 1'000, 1e6f, [&](int) { return random.spread(1e-5, 10.0); });
}

} // namespace
