// The raw step, one part however far the air flies in it, without forces, viscosity and settling, in a periodic box of
// 32 x 16 x 32: the energy must not grow and no speed may run away.
//
// GrowthBounds, relative to the projected start: energy 1.001 up to CFL 10 and 1.1 at CFL 50; largest |u| 1.1 for smooth and white
// starts and 1.5 for a shear layer, which rolls up rightly.

#include "tests/stability/watch.h"

#include <cstdint>

namespace {

using namespace windrow;
using namespace windrow::test;

constexpr glm::ivec3 k_hard_cells(32, 16, 32);

struct HardStart {
    const char* name;
    Field (*field)(glm::ivec3, float, std::uint32_t);
    double speed_bound;
};
constexpr HardStart k_hard_starts[] = {{"smooth", smooth_noise, 1.1}, {"white", white_noise, 1.1}, {"shear", shear_layer, 1.5}};

struct Growth {
    Worst worst;
    double energy_at_end = 0.0;
    double rise = 1.0; ///< largest energy over any that came before it
};

// All figures relative to the start's.
void grow(Growth& growth, const HardStart& start, int steps, const std::function<double(int step)>& cells_per_step,
          Scheme scheme = Scheme::second_order, std::uint32_t seed = 7) {
    Wind wind = made({.cells = k_hard_cells,
                      .boundaries = Boundaries::all(BoundaryKind::periodic),
                      .viscosity = 0.0f,
                      .relaxation_time = 0.0f,
                      .scheme = scheme,
                      .max_cfl = 1e6f,
                      .max_substeps = 1});
    EXPECT_TRUE(wind.set_velocity(projected(start.field(k_hard_cells, 1.0f, seed), wind.box())));
    float component = 0.0f;
    for (const glm::vec4& u : wind.field())
        component = std::max({component, std::abs(u.x), std::abs(u.y), std::abs(u.z)});
    Watch watch(wind);
    double least = 1.0;
    for (int n = 0; n < shortened(steps); ++n) {
        watch.step(cells_per_step(n) / component);
        least = std::min(least, watch.energy());
        growth.rise = std::max(growth.rise, watch.energy() / least);
    }
    EXPECT_EQ(watch.max_substeps(), 1);
    growth.energy_at_end = watch.energy();
    growth.worst.meet(watch);
}

void expect_bounded(const std::string& name, const HardStart& start, int steps,
                    const std::function<double(int step)>& cells_per_step, double energy_bound,
                    Scheme scheme = Scheme::second_order) {
    Growth growth;
    grow(growth, start, steps, cells_per_step, scheme);
    const std::string full = name + '_' + start.name;
    growth.worst.judge(full, {energy_bound, start.speed_bound});
    figure("stability/" + full + "/rise", growth.rise);
    figure("stability/" + full + "/energy_at_end", growth.energy_at_end);
}

void expect_bounded_at(const char* name, double cfl, int steps, double energy_bound) {
    for (const HardStart& start : k_hard_starts)
        expect_bounded(
            name, start, steps, [=](int) { return cfl; }, energy_bound);
}

TEST(HardCases, TenThousandStepsAtCflOneHalf) {
    expect_bounded_at("cfl_0.5", 0.5, 10'000, 1.001);
}

TEST(HardCases, TenThousandStepsAtCflTwo) {
    expect_bounded_at("cfl_2", 2.0, 10'000, 1.001);
}

TEST(HardCases, CflTen) {
    expect_bounded_at("cfl_10", 10.0, 3'000, 1.001);
}

TEST(HardCases, CflFifty) {
    expect_bounded_at("cfl_50", 50.0, 3'000, 1.1);
}

// 1e-4 to 1 s at 1 m/s and 1 m: the ratio of neighbouring steps reaches 10^4, which the history must bear.
TEST(HardCases, StepsOfAnyLengthMixed) {
    for (const HardStart& start : k_hard_starts) {
        Random random(17);
        expect_bounded(
            "dt_1e-4_to_1", start, 3'000, [&](int) { return random.spread(1e-4, 1.0); }, 1.001);
        expect_bounded(
            "dt_alternating", start, 1'000, [](int n) { return n % 2 == 0 ? 1e-3 : 1.0; }, 1.001);
        expect_bounded(
            "dt_1e-2_to_50", start, 1'000, [&](int) { return random.spread(1e-2, 50.0); }, 1.1);
    }
}

// Other ripples on the shear layer. At CFL 2, as far as a part of a step goes by default, the energy's bound holds for all of
// them; beyond it the raw step passes 1.001 and 1.5 for some (1.25 and 1.76 at CFL 5), so these bounds are wider.
TEST(HardCases, ShearLayersOfEverySort) {
    for (const auto& [cfl, energy_bound] : {std::pair{2.0, 1.001}, {5.0, 2.0}, {10.0, 1.15}, {50.0, 1.15}}) {
        Growth growth;
        for (std::uint32_t seed = 1; seed <= 8; ++seed)
            grow(
                growth, k_hard_starts[2], 300, [cells = cfl](int) { return cells; }, Scheme::second_order, seed);
        growth.worst.judge("shear_layers_cfl_" + std::to_string(static_cast<int>(cfl)), {energy_bound, 2.0});
    }
}

// The energy's bounds hold for the classic split as well; its speeds have none of their own but that of a shear layer.
TEST(HardCases, TheClassicSplitIsBoundedToo) {
    for (HardStart start : k_hard_starts) {
        start.speed_bound = 1.5;
        expect_bounded(
            "stable_fluids_cfl_2", start, 2'000, [](int) { return 2.0; }, 1.001, Scheme::stable_fluids);
        expect_bounded(
            "stable_fluids_cfl_50", start, 500, [](int) { return 50.0; }, 1.1, Scheme::stable_fluids);
    }
}

} // namespace
