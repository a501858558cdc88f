// The raw step, one part however far the air flies in it, without forces, viscosity and settling, in a periodic box of
// 32 x 16 x 32: the energy must not grow and no speed may run away.
//
// Bounds, relative to the projected start: energy 1.001 up to CFL 10 and 1.1 at CFL 50; largest |u| 1.1 for smooth and white
// starts and 1.5 for a shear layer, which rolls up rightly.

#include "fluid/wind.h"
#include "tests/fields.h"
#include "tests/figure.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <gtest/gtest.h>
#include <string>
#include <utility>

namespace {

using namespace windrow;
using namespace windrow::test;

constexpr glm::ivec3 k_cells(32, 16, 32);

struct Start {
    const char* name;
    Field (*field)(glm::ivec3, float, std::uint32_t);
    double speed_bound;
};
constexpr Start k_starts[] = {{"smooth", smooth_noise, 1.1}, {"white", white_noise, 1.1}, {"shear", shear_layer, 1.5}};

struct Growth {
    double energy = 0.0, speed = 0.0, energy_at_end = 0.0;
    double rise = 1.0; ///< largest energy over any that came before it
};

// Largest energy and speed of all steps, relative to the start's.
Growth growth(const Start& start, int steps, const std::function<double(int step)>& cells_per_step,
              Scheme scheme = Scheme::second_order, std::uint32_t seed = 7) {
    auto wind = Wind::create({.cells = k_cells,
                              .sides = Sides::all(SideKind::periodic),
                              .viscosity = 0.0f,
                              .settling_time = 0.0f,
                              .scheme = scheme,
                              .max_cfl = 1e6f,
                              .max_substeps = 1});
    EXPECT_TRUE(wind) << wind.error();
    EXPECT_TRUE(wind->set_velocity(projected(start.field(k_cells, 1.0f, seed), wind->box())));
    const double energy = energy_of(wind->field()), speed = largest_speed(wind->field());
    float component = 0.0f;
    for (const glm::vec4& u : wind->field())
        component = std::max({component, std::abs(u.x), std::abs(u.y), std::abs(u.z)});
    Growth largest;
    double least = 1.0;
    for (int n = 0; n < steps; ++n) {
        const Diagnostics report = wind->step(cells_per_step(n) / component);
        EXPECT_EQ(report.substeps, 1);
        largest.energy_at_end = report.energy / energy;
        // NaN would lose every comparison: let it win.
        if (!(largest.energy_at_end <= largest.energy))
            largest.energy = largest.energy_at_end;
        least = std::min(least, largest.energy_at_end);
        largest.rise = std::max(largest.rise, largest.energy_at_end / least);
        if (const double ratio = largest_speed(wind->field()) / speed; !(ratio <= largest.speed))
            largest.speed = ratio;
    }
    return largest;
}

void expect_bounded(const std::string& name, const Start& start, const Growth& found, double energy_bound) {
    const std::string full = name + '_' + start.name;
    WINDROW_EXPECT_FIGURE(full + "_energy", found.energy, energy_bound);
    WINDROW_EXPECT_FIGURE(full + "_speed", found.speed, start.speed_bound);
    figure(full + "_rise", found.rise);
    figure(full + "_energy_at_end", found.energy_at_end);
}

TEST(HardCases, TenThousandStepsAtCflOneHalf) {
    for (const Start& start : k_starts)
        expect_bounded("cfl_0.5", start, growth(start, 10'000, [](int) { return 0.5; }), 1.001);
}

TEST(HardCases, TenThousandStepsAtCflTwo) {
    for (const Start& start : k_starts)
        expect_bounded("cfl_2", start, growth(start, 10'000, [](int) { return 2.0; }), 1.001);
}

TEST(HardCases, CflTen) {
    for (const Start& start : k_starts)
        expect_bounded("cfl_10", start, growth(start, 3'000, [](int) { return 10.0; }), 1.001);
}

TEST(HardCases, CflFifty) {
    for (const Start& start : k_starts)
        expect_bounded("cfl_50", start, growth(start, 3'000, [](int) { return 50.0; }), 1.1);
}

// 1e-4 to 1 s at 1 m/s and 1 m: the ratio of neighbouring steps reaches 10^4, which the history must bear.
TEST(HardCases, StepsOfAnyLengthMixed) {
    for (const Start& start : k_starts) {
        Random random(17);
        expect_bounded("dt_1e-4_to_1", start, growth(start, 3'000, [&](int) { return random.spread(1e-4, 1.0); }), 1.001);
        expect_bounded("dt_alternating", start, growth(start, 1'000, [](int n) { return n % 2 == 0 ? 1e-3 : 1.0; }), 1.001);
        expect_bounded("dt_1e-2_to_50", start, growth(start, 1'000, [&](int) { return random.spread(1e-2, 50.0); }), 1.1);
    }
}

// Other ripples on the shear layer. At CFL 2, as far as a part of a step goes by default, the energy's bound holds for all of
// them; beyond it the raw step passes 1.001 and 1.5 for some (CFL 5: 1.08 and 1.76 were seen), so these bounds are wider.
TEST(HardCases, ShearLayersOfEverySort) {
    for (const auto& [cfl, energy_bound] : {std::pair{2.0, 1.001}, {5.0, 1.15}, {10.0, 1.15}, {50.0, 1.15}}) {
        Growth worst;
        for (std::uint32_t seed = 1; seed <= 8; ++seed) {
            const Growth found = growth(
                k_starts[2], 300, [cells = cfl](int) { return cells; }, Scheme::second_order, seed);
            worst.energy = std::max(worst.energy, found.energy);
            worst.speed = std::max(worst.speed, found.speed);
        }
        const std::string name = "shear_layers_cfl_" + std::to_string(static_cast<int>(cfl));
        WINDROW_EXPECT_FIGURE(name + "_energy", worst.energy, energy_bound);
        WINDROW_EXPECT_FIGURE(name + "_speed", worst.speed, 2.0);
    }
}

// The energy's bounds hold for the classic split as well; its speeds have none of their own but that of a shear layer.
TEST(HardCases, TheClassicSplitIsBoundedToo) {
    for (Start start : k_starts) {
        start.speed_bound = 1.5;
        expect_bounded("stable_fluids_cfl_2", start,
                       growth(
                           start, 2'000, [](int) { return 2.0; }, Scheme::stable_fluids),
                       1.001);
        expect_bounded("stable_fluids_cfl_50", start,
                       growth(
                           start, 500, [](int) { return 50.0; }, Scheme::stable_fluids),
                       1.1);
    }
}

} // namespace
