// Fields that a film shows beside the wind: divergence around obstacles, pressure, and a scalar that the wind carries.
#include "fluid/operators.h"
#include "fluid/tracer.h"
#include "fluid/wind.h"
#include "tests/figure.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <numbers>

namespace windrow {
namespace {

// A uniform wind through a block has its flux stopped at the windward face, 1/h a cell there, and let go at the lee.
TEST(AirFields, DivergenceSeesObstacles) {
    const Box box{.cells = {16, 12, 12}, .cell_size = 0.5f};
    auto work = Workspace::create({.box = box, .ambient = {2.0f, 0.0f, 0.0f}});
    ASSERT_TRUE(work);
    std::vector<glm::vec4> u(box.cell_count(), glm::vec4(2.0f, 0.0f, 0.0f, 0.0f));
    std::vector<float> found(box.cell_count(), 9.0f);
    divergence(*work, u, found);
    EXPECT_EQ(*std::max_element(found.begin(), found.end()), 0.0f);
    ASSERT_TRUE(
        work->set_obstacles(std::vector{PlacedObstacle{.shape = Block{{1.0f, 1.0f, 1.0f}}, .position = {4.0f, 3.0f, 3.0f}}}));
    divergence(*work, u, found);
    EXPECT_NEAR(found[box.index(5, 6, 6)], -2.0f / 0.5f, 1e-5f) << "before the block: nothing leaves";
    EXPECT_NEAR(found[box.index(10, 6, 6)], 2.0f / 0.5f, 1e-5f) << "behind it: nothing enters";
    EXPECT_EQ(found[box.index(7, 6, 6)], 0.0f) << "inside";
    EXPECT_EQ(found[box.index(3, 6, 6)], 0.0f);
    EXPECT_EQ(found[box.index(7, 9, 6)], 0.0f) << "past its side";
}

// What the projection leaves around a house is what the wind reports.
TEST(AirFields, DivergenceOfAWindIsThatOfItsReport) {
    auto wind = Wind::create({.cells = {24, 12, 16},
                              .boundaries = Boundaries::open_over_floor(),
                              .centre = {0.0, 6.0, 0.0},
                              .ambient = {4.0f, 0.0f, 0.0f}});
    ASSERT_TRUE(wind);
    ASSERT_TRUE(wind->obstacles().add({.position = {0.3, 2.0, 0.2}, .shape = Block{{2.0f, 2.0f, 2.4f}}}));
    Diagnostics last;
    for (int n = 0; n < 30; ++n)
        last = wind->step(0.05);
    auto work = Workspace::create({.box = wind->box(), .ambient = wind->ambient()});
    ASSERT_TRUE(work && work->set_obstacles(wind->obstacles().in_reach()));
    std::vector<float> found(wind->box().cell_count());
    divergence(*work, wind->field(), found);
    double squares = 0.0;
    for (const float value : found)
        squares += static_cast<double>(value) * static_cast<double>(value);
    EXPECT_NEAR(std::sqrt(squares / static_cast<double>(found.size())) / last.divergence_rms, 1.0, 1e-3);
}

// Taylor and Green's vortices, -(U^2 / 4)(cos 2kx + cos 2kz): of order 2.
double error_of_pressure(int cells) {
    const float size = 2.0f * std::numbers::pi_v<float>;
    auto wind = Wind::create({.cells = {cells, 2, cells},
                              .cell_size = size / static_cast<float>(cells),
                              .boundaries = Boundaries::all(BoundaryKind::periodic),
                              .viscosity = 0.0f,
                              .relaxation_time = 0.0f});
    EXPECT_TRUE(wind) << wind.error();
    wind->set_velocity(
        [](glm::dvec3 x) { return glm::vec3(std::sin(x.x) * std::cos(x.z), 0.0, -std::cos(x.x) * std::sin(x.z)); });
    for (int n = 0; n < 8; ++n)
        (void)wind->step(1.0 / cells);
    std::vector<float> found(wind->box().cell_count());
    EXPECT_TRUE(wind->write_pressure(found));
    double error = 0.0;
    for (int k = 0; k < cells; ++k)
        for (int i = 0; i < cells; ++i) {
            const glm::dvec3 x = wind->view().window().centre(i, 0, k);
            const double exact = 0.25 * (std::cos(2.0 * x.x) + std::cos(2.0 * x.z));
            error = std::max(error, std::abs(static_cast<double>(found[wind->box().index(i, 0, k)]) - exact));
        }
    return error;
}

TEST(AirFields, PressureOfVortices) {
    const double coarse = test::figure("pressure/vortices/16_cells", error_of_pressure(16));
    const double middle = test::figure("pressure/vortices/32_cells", error_of_pressure(32));
    const double fine = test::figure("pressure/vortices/64_cells", error_of_pressure(64));
    EXPECT_GT(std::log2(coarse / middle), 1.7);
    EXPECT_GT(std::log2(middle / fine), 1.7);
    EXPECT_LT(fine, 0.02) << "of 0.5";
}

// The pressure over the faces of a block is the force that the air reports; outside of the box it is 0.
TEST(AirFields, PressureAroundABlockIsItsForce) {
    auto wind = Wind::create({.cells = {32, 24, 24}, .ambient = {5.0f, 0.0f, 0.0f}});
    ASSERT_TRUE(wind);
    const auto block = wind->obstacles().add({.position = {0.0, 0.0, 0.0}, .shape = Block{{2.0f, 3.0f, 3.0f}}});
    ASSERT_TRUE(block);
    for (int n = 0; n < 80; ++n)
        (void)wind->step(0.05);
    std::vector<float> p(wind->box().cell_count());
    ASSERT_TRUE(wind->write_pressure(p));
    const auto at = [&](int i, int j, int k) { return static_cast<double>(p[wind->box().index(i, j, k)]); };
    double drag = 0.0;
    for (int j = 9; j < 15; ++j)
        for (int k = 9; k < 15; ++k)
            drag += at(13, j, k) - at(18, j, k);
    drag *= 1.2;
    const double force = static_cast<double>(wind->force_on(*block)->force.x);
    EXPECT_NEAR(drag / force, 1.0, 0.15) << drag << " N, " << force << " N";
    EXPECT_NEAR(at(13, 12, 12), 0.5 * 25.0, 0.5 * 25.0 * 0.25) << "half the square of the speed where the air stops";
    EXPECT_EQ(at(16, 12, 12), 0.0) << "inside";
    std::vector<float> few(3);
    EXPECT_EQ(wind->write_pressure(few).error(),
              "write_pressure got room for 3 cells, but the box has 18432: give one array of box().cell_count().");
}

// Walls that open let the smoke out, and it takes a new mean wind.
TEST(Tracer, HasTheBoundariesOfItsWind) {
    Boundaries walls;
    walls.x_low.kind = walls.x_high.kind = BoundaryKind::free_slip;
    auto wind = Wind::create({.cells = {12, 6, 8}, .boundaries = walls, .ambient = {4.0f, 0.0f, 0.0f}});
    ASSERT_TRUE(wind);
    auto smoke = Tracer::create(wind->view());
    ASSERT_TRUE(smoke);
    smoke->blow({0.0, 0.0, 0.0}, 2.0f);
    ASSERT_TRUE(wind->set_boundaries({}) && wind->set_ambient({4.0f, 0.0f, 1.0f}));
    wind->reset();
    for (int n = 0; n < 60; ++n) {
        (void)wind->step(0.1);
        ASSERT_TRUE(smoke->step(wind->view(), {}, 0.1));
    }
    double left = 0.0;
    for (const float value : smoke->cells())
        left += static_cast<double>(value);
    EXPECT_LE(left, 0.05);
}

// A puff in a uniform wind goes where the wind goes, in a box that follows it.
TEST(Tracer, GoesWithTheWindAndTheBox) {
    auto wind = Wind::create({.cells = {24, 12, 16}, .ambient = {4.0f, 0.0f, 1.0f}});
    ASSERT_TRUE(wind);
    auto smoke = Tracer::create(wind->view());
    ASSERT_TRUE(smoke);
    smoke->blow({-4.0, 0.5, -1.0}, 1.5f);
    const auto middle = [&] {
        glm::dvec3 sum(0.0);
        double all = 0.0;
        for (int k = 0; k < 16; ++k)
            for (int j = 0; j < 12; ++j)
                for (int i = 0; i < 24; ++i) {
                    const double value = static_cast<double>(smoke->cells()[wind->box().index(i, j, k)]);
                    sum += value * wind->view().window().centre(i, j, k);
                    all += value;
                }
        return glm::dvec4(sum / all, all);
    };
    const glm::dvec4 begin = middle();
    EXPECT_LT(glm::length(glm::dvec3(begin) - glm::dvec3(-4.0, 0.5, -1.0)), 0.1);
    for (int n = 1; n <= 60; ++n) {
        ASSERT_TRUE(wind->follow(glm::dvec3(4.0, 0.0, 1.0) * (n / 40.0)));
        (void)wind->step(1.0 / 40.0);
        ASSERT_TRUE(smoke->step(wind->view(), wind->obstacles().in_reach(), 1.0 / 40.0));
    }
    const glm::dvec4 end = middle();
    // Cubic reads keep the middle; the clamp of overshoots acts on one flank more.
    EXPECT_LT(glm::length(glm::dvec3(end) - glm::dvec3(2.0, 0.5, 0.5)), 0.25) << "1.5 s at (4, 0, 1) m/s";
    test::figure("tracer/growth_of_a_puff", end.w / begin.w); // the clamp of overshoots keeps no sum
    for (const float value : smoke->cells())
        EXPECT_TRUE(value >= 0.0f && value <= 1.0f);
    auto other = Wind::create({});
    EXPECT_FALSE(smoke->step(other->view(), {}, 0.1));
}

} // namespace
} // namespace windrow
