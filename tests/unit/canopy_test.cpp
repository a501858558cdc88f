// Plants that slow the wind: the exact law, its rows, its momentum, and that it is off unless asked for.
#include "tests/winds.h"

#include <optional>

namespace windrow {
namespace {

using namespace test;

Boundaries floor_and_lid() {
    Boundaries boundaries = Boundaries::all(BoundaryKind::periodic);
    boundaries.y_low.kind = boundaries.y_high.kind = BoundaryKind::free_slip;
    return boundaries;
}

// Six rows of 0.5 m over a floor at height 0, the canopy 1.2 m high: two rows whole, one to two fifths.
Config field_of_plants() {
    return {.cells = {5, 6, 7},
            .cell_size = 0.5f,
            .boundaries = floor_and_lid(),
            .centre = {0.0, 1.5, 0.0},
            .canopy = Canopy{.height = 1.2f, .drag = 0.7f},
            .relaxation_time = 0.0f,
            .stages = k_sources_only};
}

double share_of_row(int j) {
    return std::clamp(2.4 - j, 0.0, 1.0);
}

TEST(Canopy, SlowsByTheExactLawInItsRowsWhateverTheStep) {
    const glm::dvec3 start(6.0, -2.0, 3.0);
    double worst = 0.0;
    for (const int steps : {1, 3, 60}) {
        Wind wind = made(field_of_plants());
        wind.set_velocity([&](glm::dvec3) { return glm::vec3(start); });
        take_steps(wind, steps, 2.0 / steps);
        for (int j = 0; j < 6; ++j) {
            const glm::dvec3 truth = start / (1.0 + 0.7 * 2.0 * share_of_row(j) * glm::length(start));
            const glm::dvec3 found(wind.field()[wind.box().index(2, j, 3)]);
            worst = std::max(worst, glm::length(found - truth) / glm::length(start));
        }
    }
    WINDROW_EXPECT_FIGURE("canopy.law", worst, 2e-6);
}

TEST(Canopy, IsStableAtAnyStep) {
    Config config{.cells = {8, 8, 8}, .boundaries = floor_and_lid(), .canopy = Canopy{.height = 5.0f, .drag = 1000.0f}};
    Wind wind = made(config);
    wind.set_velocity([](glm::dvec3 x) { return glm::vec3(1000.0 * std::sin(x.z), 0.0, 300.0); });
    double energy = std::numeric_limits<double>::infinity();
    for (const double dt : {1e-3, 1e3, 0.1, 1e6, 1.0 / 30.0}) {
        const Diagnostics done = wind.step(dt);
        ASSERT_TRUE(std::isfinite(done.energy));
        EXPECT_LE(done.energy, energy * 1.0001);
        energy = done.energy;
    }
}

// What the air loses in whole steps is what the plants took: their impulse by the law from the air that each step meets.
TEST(Canopy, TakesTheMomentumThatTheAirLoses) {
    Config config{
        .cells = {24, 12, 24}, .boundaries = floor_and_lid(), .centre = {0.0, 6.0, 0.0}, .canopy = Canopy{.height = 3.5f}};
    config.viscosity = 0.0f;
    config.relaxation_time = 0.0f;
    Wind wind = made(config);
    wind.set_velocity([](glm::dvec3 x) {
        return glm::vec3(4.0 + 2.0 * std::tanh(x.y - 3.5) + 0.3 * std::sin(x.z * 0.2618), 0.2 * std::sin(x.x * 0.2618), 0.0);
    });
    const glm::dvec3 first = sum_of(wind.field());
    constexpr double k_dt = 1.0 / 30.0;
    glm::dvec3 taken(0.0);
    for (int step = 0; step < 150; ++step) {
        for_each_cell(config.cells, [&](int i, int j, int k) {
            const glm::dvec3 u(wind.field()[wind.box().index(i, j, k)]);
            const double way = 0.6 * k_dt * std::clamp(3.5 - j, 0.0, 1.0);
            taken += u - u / (1.0 + way * glm::length(u));
        });
        wind.step(k_dt);
    }
    const glm::dvec3 lost = first - sum_of(wind.field());
    EXPECT_GT(lost.x, 0.05 * first.x); // it was no small thing
    WINDROW_EXPECT_FIGURE("canopy.momentum", std::abs(lost.x / taken.x - 1.0), 0.02);
}

TEST(Canopy, StandsOnTheFloorOrAtHeightZero) {
    Config config = field_of_plants();
    config.canopy = Canopy{.height = 0.5f, .drag = 1.0f};
    const auto slowed_row = [](Wind& wind) {
        wind.set_velocity([](glm::dvec3) { return glm::vec3(1.0f, 0.0f, 0.0f); });
        wind.step(1.0);
        int found = -1;
        for (int j = 0; j < 6; ++j)
            if (wind.field()[wind.box().index(1, j, 1)].x < 0.99f)
                found = j;
        return found;
    };
    Wind on_floor = made(config);
    ASSERT_TRUE(on_floor.set_floor(40.0));
    EXPECT_EQ(slowed_row(on_floor), 0);
    config.boundaries.y_low.kind = config.boundaries.y_high.kind = BoundaryKind::open;
    config.centre.y = 0.5; // two rows below height 0
    config.follow_axes = glm::bvec3(false, true, false);
    Wind in_the_open = made(config);
    EXPECT_EQ(slowed_row(in_the_open), 2);
    ASSERT_TRUE(in_the_open.follow({0.0, 100.0, 0.0}));
    EXPECT_EQ(slowed_row(in_the_open), -1);
}

TEST(Canopy, OfNoHeightOrDragChangesNoBit) {
    const auto field_with = [](std::optional<Canopy> canopy) {
        Wind wind = made(
            {.cells = {8, 6, 8}, .boundaries = Boundaries::open_over_floor(), .ambient = {2.0f, 0.0f, 1.0f}, .canopy = canopy});
        EXPECT_TRUE(wind.motors().add(DirectionalMotor{}));
        take_steps(wind, 5, 1.0 / 30.0);
        return copy(wind.field());
    };
    const auto without = field_with(std::nullopt);
    EXPECT_EQ(field_with(Canopy{.height = 0.0f}), without);
    EXPECT_EQ(field_with(Canopy{.drag = 0.0f}), without);
    EXPECT_NE(field_with(Canopy{}), without);
}

TEST(Canopy, WindAmongPlantsDoesNotSleepStillAirDoes) {
    Config config{
        .cells = {8, 6, 8}, .boundaries = Boundaries::open_over_floor(), .ambient = {2.0f, 0.0f, 0.0f}, .canopy = Canopy{}};
    Wind windy = made(config);
    config.ambient = glm::vec3(0.0f);
    Wind still = made(config);
    for (int step = 0; step < 20; ++step) {
        windy.step(0.1);
        still.step(0.1);
    }
    EXPECT_LT(windy.velocity({0.0, -2.9, 0.0}).x, 1.9f);
    EXPECT_FALSE(windy.step(0.1).asleep);
    EXPECT_TRUE(still.step(0.1).asleep);
}

} // namespace
} // namespace windrow
