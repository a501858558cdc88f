// The stress of rough ground: it takes energy, whatever the step, and holds in a box that walks over hills and houses.

#include "tests/shapes.h"
#include "tests/stability/watch.h"

#include <cmath>

namespace {

using namespace windrow;
using namespace windrow::test;

TEST(RoughGround, TakesEnergyFromAClosedBox) {
    double most = 0.0;
    for (const auto& start : {white_noise, smooth_noise, shear_layer})
        for (const double ratio : {1.0, 1.6, 30.0})
            for (const double cells_per_step : {0.3, 2.0, 40.0}) {
                Config config{.cells = {16, 12, 16},
                              .boundaries = Boundaries::all(BoundaryKind::free_slip),
                              .roughness = Roughness{.length = 0.2f},
                              .viscosity = 0.0f,
                              .relaxation_time = 0.0f};
                Wind wind = made(config);
                ASSERT_TRUE(wind.set_velocity(projected(start(config.cells, 4.0f, 3), wind.box())));
                const double before = energy_of(wind.field());
                for (int n = 0; n < (whole_sweeps() ? 1'000 : 100); ++n) {
                    (void)wind.step(cells_per_step / 10.0 / (n % 2 == 0 ? ratio : 1.0));
                    most = std::max(most, energy_of(wind.field()) / before);
                }
                if (cells_per_step > 1.0) {
                    EXPECT_LT(energy_of(wind.field()), 0.7 * before) << "the floor slows it";
                }
            }
    WINDROW_EXPECT_FIGURE("rough_ground/closed_box_energy", most, 1.001);
}

TEST(RoughGround, HoldsInAWalkOverHillsAndHouses) {
    Config config{.cells = {20, 16, 20},
                  .boundaries = Boundaries::open_over_floor(),
                  .centre = {0.0, 8.0, 0.0},
                  .ambient = {9.0f, 0.0f, 4.0f},
                  .profile = LogProfile{.roughness_length = 0.01f},
                  .gusts = {.intensity = 0.3f}};
    config.roughness.emplace();
    config.roughness->map =
        RoughnessMap{.lengths = heights_of({101, 101}, 2.0f,
                                           [](double x, double z) { return 0.3 * std::pow(std::sin(0.2 * x + 0.1 * z), 6.0); }),
                     .position = {-100.0, 0.0, -100.0}};
    Wind wind = made(config);
    ASSERT_TRUE(wind.obstacles().add(
        {.position = {-100.0, 0.0, -100.0}, .shape = Ground{heights_of({101, 101}, 2.0f, [](double x, double z) {
                                                return 2.5 + 2.0 * std::sin(0.11 * x) * std::cos(0.14 * z);
                                            })}}));
    for (int n = 0; n < 12; ++n)
        ASSERT_TRUE(wind.obstacles().add({.position = {9.0 * n - 50.0, 4.0, 7.0 * (n % 3)}, .shape = Block{{2.0f, 4.0f, 1.5f}}}));
    const ObstacleId train = *wind.obstacles().add({.position = {0.0, 6.0, 3.0}, .shape = Block{{6.0f, 1.5f, 1.5f}}});
    Random random(11);
    double time = 0.0;
    float fastest = 0.0f;
    for (int n = 0; n < (whole_sweeps() ? 10'000 : 400); ++n) {
        const double dt = random.spread(1e-4, 0.5);
        time += dt;
        ASSERT_TRUE(wind.follow({40.0 * std::sin(0.05 * time), 8.0, 30.0 * std::sin(0.033 * time)}));
        ASSERT_TRUE(wind.obstacles().move(train, {40.0 * std::sin(0.4 * time), 6.0, 3.0}));
        const Diagnostics report = wind.step(dt);
        ASSERT_EQ(report.repaired_cells, 0) << n;
        fastest = std::max(fastest, report.max_speed);
    }
    // The train's own 16 m/s, and the air that goes around it and over the crests at up to twice the gusty wind.
    WINDROW_EXPECT_FIGURE("rough_ground/fastest_in_a_walk", fastest, 60.0);
}

} // namespace
