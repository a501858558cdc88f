// Motors in rows of unequal thickness: those thicker than a cell take the mean over their thickness.
#include "figures.h"
#include "tests/winds.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <string>

namespace windrow {
namespace {

using namespace test;
using figures::expect_at_most;

// A force gives its volume's momentum, near the ground and aloft, where a row is thicker than the ball.
TEST(MotorsInRows, AForceKeepsItsImpulse) {
    Boundaries walls = Boundaries::all(BoundaryKind::periodic);
    walls.y_low = walls.y_high = {BoundaryKind::free_slip};
    for (const double height : {2.0, 9.0, 25.0}) {
        Config config{.cells = {24, 24, 24}, .boundaries = walls, .centre = {0.0, 22.0, 0.0}, .stages = k_sources_only};
        config.rows.emplace(Rows{.first = 0.5f, .uniform = 4, .top = 44.0f});
        Wind wind = made(config);
        ASSERT_NEAR(wind.origin().y, 0.0, 1e-6);
        added(wind.motors(),
              DirectionalMotor{
                  .position = {0.0, height, 0.0}, .region = Sphere{2.0f}, .law = Force{10.0f}, .turbulence = k_steady});
        (void)wind.step(0.1);
        double momentum = 0.0;
        for_each_cell(config.cells, [&](int i, int j, int k) {
            momentum += double(wind.box().volume(j)) * double(wind.field()[wind.box().index(i, j, k)].x);
        });
        const double wanted = 10.0 * 0.1 * 32.0 * std::numbers::pi * 8.0 / 105.0;
        expect_at_most("rows.impulse.at_" + std::to_string(static_cast<int>(height)) + "_m", std::abs(momentum / wanted - 1.0),
                       0.02);
    }
}

// A ball that pushes blows in a row that is thicker than itself as in rows of a metre, whose mean over that row is the truth. A ball that
// is widened along all axes to what the row can hold is a tenth as fast there.
TEST(MotorsInRows, AForceAloftBlowsAsInFineRows) {
    for (const float radius : {2.0f, 4.0f})
        for (const double height : {12.0, 20.0, 35.0}) {
            Config config{.cells = {32, 48, 32},
                          .boundaries = Boundaries::open_over_floor(),
                          .centre = {0.0, 24.0, 0.0},
                          .relaxation_time = 0.0f};
            Wind fine = made(config);
            config.cells.y = 24;
            config.rows.emplace(Rows{.first = 0.5f, .uniform = 4, .top = 48.0f});
            Wind wind = made(config);
            for (Wind* const each : {&fine, &wind}) {
                added(each->motors(),
                      DirectionalMotor{
                          .position = {0.0, height, 0.0}, .region = Sphere{radius}, .law = Force{10.0f}, .turbulence = k_steady});
                take_steps(*each, 5, 0.05);
            }
            const auto at = [](const Wind& of, int row) { return double(of.field()[of.box().index(16, row, 16)].x); };
            const RowTable& rows = *wind.box().rows;
            int row = 0;
            while (wind.origin().y + rows.face(row + 1) < height)
                ++row;
            const double low = wind.origin().y + rows.face(row), high = low + rows.thickness(row);
            double mean = 0.0;
            for (int j = 0; j < 48; ++j) {
                const double from = fine.origin().y + j;
                mean += std::max(std::min(from + 1.0, high) - std::max(from, low), 0.0) / (high - low) * at(fine, j);
            }
            expect_at_most("rows.aloft.radius_" + std::to_string(int(radius)) + ".at_" + std::to_string(int(height)) + "_m",
                           std::abs(at(wind, row) / mean - 1.0), 0.12);
        }
}

} // namespace
} // namespace windrow
