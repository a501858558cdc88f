// The air behind a shelter belt over rough ground (shaders/numerics/lee.glsl), what plants lose no bit of, the step that a reader
// finds at the edge of plants, and the momentum of many plants.
//
// Behind nine narrow conifer belts the least wind was .29 to .71 of the open one, at 2 to 6 heights (Loeffler, Gordon & Gillespie
// 1992, Agroforestry Systems 17). Belts of 15 to 18 m in full leaf left .4 at 50 m and .7 at 150 m, and were quietest about 4 heights
// behind ("Aerodynamic parameters of windbreak based on its optical porosity", Contributions to Geophysics and Geodesy). Bounds here
// are narrower. The belt has k = 2, is as high as 600 roughness lengths, and is read at .38 of its height.
#include "tests/winds.h"

#include <array>
#include <cstring>

namespace windrow {
namespace {

using namespace test;

// A channel across a belt of `height` cells, half as wide, in the wind's own log profile.
Wind channel(int height, bool planted = true) {
    const auto h = static_cast<float>(height);
    Config config{.cells = {44 * height, 8 * height, 4},
                  .boundaries = Boundaries::open_over_floor(),
                  .centre = {17.0 * height, 0.0, 0.0},
                  .ambient = {5.0f, 0.0f, 0.0f},
                  .profile = LogProfile{.roughness_length = h / 600.0f, .reference_height = 2.0f * h},
                  .roughness = Roughness{.length = h / 600.0f},
                  .relaxation_time = 0.0f};
    config.boundaries.z_low.kind = config.boundaries.z_high.kind = BoundaryKind::periodic;
    Wind wind = made(config);
    EXPECT_TRUE(!planted ||
                wind.drag().add(BeltDrag{
                    .start = {0.0, 0.0, -2.0}, .end = {0.0, 0.0, 2.0}, .width = 0.5f * h, .height = h, .resistance = 2.0f}));
    return wind;
}

void expect_shelter(int height) {
    Wind wind = channel(height);
    const double h = height, dt = 0.025 * h;
    take_steps(wind, 700, dt);
    constexpr int k_quarters = 100, k_means = 20;
    std::vector<double> mean(k_quarters);
    for (int n = 0; n < k_means; ++n) {
        take_steps(wind, 10, dt);
        for (std::size_t i = 0; i < mean.size(); ++i)
            mean[i] += static_cast<double>(wind.velocity({0.25 * static_cast<double>(i) * h, 0.38 * h, 0.0}).x) / k_means;
    }
    const auto open = static_cast<double>(wind.velocity({-1e6, 0.38 * h, 0.0}).x);
    const auto least = std::min_element(mean.begin(), mean.end());
    const std::string name = "lee/" + std::to_string(height) + "_cells/";
    const double place = 0.25 * static_cast<double>(least - mean.begin()), at_4 = mean[16] / open, at_15 = mean[60] / open;
    EXPECT_GE(*least / open, 0.30);
    WINDROW_EXPECT_FIGURE(name + "least", *least / open, 0.42);
    EXPECT_GE(place, 2.5);
    WINDROW_EXPECT_FIGURE(name + "place", place, 5.0);
    EXPECT_GE(at_4, 0.33);
    WINDROW_EXPECT_FIGURE(name + "at_4", at_4, 0.45);
    EXPECT_GE(at_15, 0.75);
    WINDROW_EXPECT_FIGURE(name + "at_15", at_15, 0.88);
    for (const int at : {1, 2, 6, 10, 20})
        (void)figure(name + "curve_" + std::to_string(at), mean[static_cast<std::size_t>(4 * at)] / open);
}

TEST(Lee, OfABeltOfFourCellsIsThatOfAWindbreak) {
    expect_shelter(4);
}
TEST(Lee, LongOfABeltOfEightCellsIsThatOfAWindbreak) {
    expect_shelter(8);
}

// A deposit outside of the box leaves all bits; one that goes leaves no lee.
TEST(Lee, IsNoneWithoutPlants) {
    Wind without = channel(4, false), beyond = channel(4, false), gone = channel(4, false);
    ASSERT_TRUE(beyond.drag().add(PlantDrag{.position = {1e4, 0.0, 0.0}}));
    const auto plant = gone.drag().add(PlantDrag{.position = {10.0, 0.0, 0.0}});
    ASSERT_TRUE(plant);
    for (Wind* wind : {&without, &beyond})
        ASSERT_TRUE(wind->motors().add(DirectionalMotor{.position = {-6.0, 2.0, 0.0}}));
    for (int n = 0; n < 20; ++n) {
        for (Wind* wind : {&without, &beyond, &gone})
            (void)wind->step(1.0 / 30.0);
        ASSERT_EQ(std::memcmp(without.field().data(), beyond.field().data(), without.field().size_bytes()), 0);
    }
    const auto deepest = [&] {
        float most = 0.0f;
        for (const glm::vec4& u : gone.field())
            most = std::max(most, std::abs(u.w));
        return most;
    };
    EXPECT_GT(deepest(), 0.05f);
    ASSERT_TRUE(gone.drag().remove(*plant));
    (void)gone.step(1.0 / 30.0);
    EXPECT_EQ(deepest(), 0.0f);
}

// A reader takes no law of the wall among plants. In a log profile, with plants too thin to change it, the wind near the ground is
// that of the lowest centres there, and goes over to the law within a cell of their edge, by no more than .17 of either beyond it.
TEST(Lee, AReaderFindsNoLawAmongPlants) {
    const Config config{.cells = {16, 8, 8},
                        .boundaries = Boundaries::open_over_floor(),
                        .follow_axes = glm::bvec3(false), // no blend zone
                        .ambient = {6.0f, 0.0f, 0.0f},
                        .profile = LogProfile{.roughness_length = 0.03f},
                        .roughness = Roughness{.length = 0.03f},
                        .sleep_speed = 0.0f};
    Wind wind = made(config);
    ASSERT_TRUE(wind.drag().add(PlantDrag{.position = {4.0, 0.0, 0.0}, .radius = 4.0f, .height = 1.0f, .area = 1e-4f}));
    (void)wind.step(1.0 / 60.0);
    const double floor = wind.origin().y;
    const auto at = [&](double x, double height) { return static_cast<double>(wind.velocity({x, floor + height, 0.5}).x); };
    const double centre = at(5.5, 0.5), law = at(-4.5, 0.1);
    EXPECT_NEAR(at(-4.5, 0.5), centre, 1e-3);
    EXPECT_NEAR(law / centre, std::log(1.0 + 0.1 / 0.03) / std::log(1.0 + 0.5 / 0.03), 0.02);
    EXPECT_NEAR(at(5.5, 0.1), centre, 1e-3 * centre);
    double beyond = 0.0;
    for (double x = -2.0; x < 2.0; x += 0.05)
        beyond = std::max(beyond, std::max(at(x, 0.1) / centre - 1.0, 1.0 - at(x, 0.1) / law));
    WINDROW_EXPECT_FIGURE("lee/edge", beyond, 0.17);
}

// --- Momentum --------------------------------------------------------------------------------------------------------------------

// In a duct with walls that slip, a belt and two bushes: what the air loses between two planes over the sum of all loads, less 1.
double momentum_off(float cell) {
    constexpr double k_air = 1.2;
    const double h = static_cast<double>(cell), dt = 0.05 * h;
    const auto cells = [&](double metres) { return static_cast<int>(std::lround(metres / h)); };
    Boundaries duct;
    duct.y_low.kind = duct.y_high.kind = duct.z_low.kind = duct.z_high.kind = BoundaryKind::free_slip;
    Wind wind = made({.cells = {cells(40.0), cells(16.0), cells(16.0)},
                      .cell_size = cell,
                      .boundaries = duct,
                      .centre = {8.0, 0.0, 0.0},
                      .floor = -8.0,
                      .ambient = {4.0f, 0.0f, 0.0f},
                      .viscosity = 0.0f,
                      .relaxation_time = 0.0f});
    const std::array<DragDeposit, 3> plants{
        BeltDrag{.start = {-2.0, -8.0, -5.0}, .end = {-1.0, -8.0, 5.0}, .width = 2.0f, .height = 9.0f, .resistance = 0.4f},
        PlantDrag{.position = {3.0, -8.0, 3.0}, .radius = 2.0f, .height = 8.0f, .area = 8.0f},
        PlantDrag{.position = {5.0, -6.0, -3.0}, .radius = 2.5f, .base = 1.0f, .height = 9.0f, .area = 10.0f}};
    std::array<DragId, 3> ids{};
    EXPECT_TRUE(wind.drag().add(plants, ids));
    const auto loads = [&] {
        double sum = 0.0;
        for (const DragId id : ids)
            sum += static_cast<double>(wind.force_on(id)->force.x);
        return sum;
    };
    take_steps(wind, cells(480.0), dt);
    const Box box = wind.box();
    const int front = cells(6.0), behind = cells(34.0), steps = cells(160.0);
    const auto between = [&] {
        double sum = 0.0;
        for_each_cell(box.cells, [&](int i, int j, int k) {
            const double weight = i > front && i < behind ? 1.0 : i == front || i == behind ? 0.5 : 0.0;
            sum += weight * k_air * h * h * h * static_cast<double>(wind.field()[box.index(i, j, k)].x);
        });
        return sum;
    };
    double lost = 0.0, load = 0.0;
    const double before = between();
    std::vector<float> pressure(box.cell_count());
    for (int step = 0; step < steps; ++step) {
        load += 0.5 * loads() / steps;
        (void)wind.step(dt);
        load += 0.5 * loads() / steps;
        EXPECT_TRUE(wind.write_pressure(pressure));
        for (const auto& [plane, sign] : {std::pair{front, 1.0}, std::pair{behind, -1.0}})
            for (int k = 0; k < box.cells.z; ++k)
                for (int j = 0; j < box.cells.y; ++j) {
                    const std::size_t n = box.index(plane, j, k);
                    const auto u = static_cast<double>(wind.field()[n].x);
                    lost += sign * k_air * h * h * (u * u + static_cast<double>(pressure[n])) / steps;
                }
    }
    lost -= (between() - before) / (steps * dt);
    return std::abs(lost / load - 1.0);
}

TEST(PlantMomentum, IsTheSumOfTheLoads) {
    WINDROW_EXPECT_FIGURE("drag.plants_momentum", momentum_off(1.0f), 0.05);
}
TEST(PlantMomentum, LongIsTheSumOfTheLoadsInHalfTheCells) {
    WINDROW_EXPECT_FIGURE("drag.plants_momentum_halved", momentum_off(0.5f), 0.02);
}

} // namespace
} // namespace windrow
