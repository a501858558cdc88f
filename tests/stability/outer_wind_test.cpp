// A wind inside another one over many steps of any length: what comes in through its sides never makes it faster than the outer wind.
#include "tests/tier.h"
#include "tests/winds.h"

#include <memory>
#include <random>

namespace windrow {
namespace {

struct Weather {
    const char* name;
    float wind = 6.0f, gusts = 0.0f;
};
void PrintTo(const Weather& value, std::ostream* out) {
    *out << value.name;
}

class OuterWindBounds : public testing::TestWithParam<Weather> {};

// Bodies stand across the sides of the inner box, one moves through it, and steps have random lengths.
TEST_P(OuterWindBounds, TheInnerWindIsNoFaster) {
    const Config around{.cells = {24, 8, 20},
                        .cell_size = 2.0f,
                        .boundaries = Boundaries::open_over_floor(),
                        .ambient = {GetParam().wind, 0.0f, 0.3f * GetParam().wind},
                        .gusts = {.intensity = GetParam().gusts, .length = 12.0f}};
    const auto outer = std::make_shared<Wind>(test::made(around));
    auto inner = Wind::create({.cells = {16, 8, 16}, .boundaries = Boundaries::open_over_floor()}, outer);
    ASSERT_TRUE(inner) << inner.error();
    ObstacleId moving[2];
    for (Wind* wind : {outer.get(), &*inner}) {
        ASSERT_TRUE(wind->obstacles().add({.position = {-8.0, 2.0, 1.0}, .shape = Block{glm::vec3(2.5f)}}));
        ASSERT_TRUE(wind->obstacles().add({.position = {3.0, 3.0, 8.0}, .shape = Cylinder{2.2f, 3.0f}}));
        const auto added = wind->obstacles().add({.position = {-14.0, 2.5, -3.0}, .shape = Sphere{2.2f}});
        ASSERT_TRUE(added);
        moving[wind == outer.get() ? 0 : 1] = *added;
    }
    std::mt19937 random(7);
    double time = 0.0, fastest_outer = 0.0, fastest_inner = 0.0;
    std::int64_t limited = 0, repaired = 0;
    const int steps = test::sampled(900, 150);
    for (int n = 0; n < steps; ++n) {
        const double dt = std::exp(std::uniform_real_distribution(std::log(0.004), std::log(0.1))(random));
        time += dt;
        for (Wind* wind : {outer.get(), &*inner}) {
            ASSERT_TRUE(
                wind->obstacles().move(moving[wind == outer.get() ? 0 : 1], {-14.0 + 3.0 * std::fmod(time, 9.0), 2.5, -3.0}));
            const Diagnostics report = wind->step(dt);
            limited += report.limited_cells;
            repaired += report.repaired_cells;
            double& fastest = wind == outer.get() ? fastest_outer : fastest_inner;
            fastest = std::max(fastest, double(report.max_speed));
        }
    }
    WINDROW_EXPECT_FIGURE(std::string("stability/outer_wind/") + GetParam().name, fastest_inner / fastest_outer, 1.2);
    EXPECT_EQ(limited, 0);
    EXPECT_EQ(repaired, 0);
}

INSTANTIATE_TEST_SUITE_P(Of, OuterWindBounds,
                         testing::Values(Weather{"breeze", 6.0f}, Weather{"storm", 30.0f}, Weather{"gusty_breeze", 6.0f, 0.3f},
                                         Weather{"gusty_storm", 30.0f, 0.3f}),
                         [](const auto& suite) { return std::string(suite.param.name); });

} // namespace
} // namespace windrow
