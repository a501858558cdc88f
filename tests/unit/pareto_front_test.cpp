// The front of `windrow pareto`: nothing beaten is on it, and whatever is off it is beaten.
#include "cli/pareto/pareto_command.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <vector>

namespace windrow::cli {

using namespace cases;

namespace {

constexpr double k_infinite = std::numeric_limits<double>::infinity();
const double k_nan = std::numeric_limits<double>::quiet_NaN();

// Few values, so that there are many ties.
std::vector<CostError> random_points(std::mt19937& engine, int values, std::size_t count) {
    std::vector<CostError> points;
    const auto draw = [&] { return 1.0 + static_cast<double>(engine() % static_cast<unsigned>(values)); };
    for (std::size_t n = 0; n < count; ++n)
        points.push_back({draw(), draw()});
    return points;
}

TEST(ParetoFront, HoldsJustWhatNothingBeats) {
    std::mt19937 engine(11);
    for (int turn = 0; turn < 400; ++turn) {
        const auto points = random_points(engine, turn % 2 == 0 ? 6 : 100000, static_cast<std::size_t>(turn % 50));
        const auto front = front_of(points);
        for (std::size_t n = 0; n < points.size(); ++n) {
            const bool beaten = std::any_of(points.begin(), points.end(), [&](const CostError& other) {
                return other.cost <= points[n].cost && other.error <= points[n].error &&
                       (other.cost < points[n].cost || other.error < points[n].error);
            });
            EXPECT_EQ(std::count(front.begin(), front.end(), n), beaten ? 0 : 1);
            EXPECT_EQ(beaten_by(points, n).has_value(), beaten);
        }
        for (std::size_t n = 1; n < front.size(); ++n) {
            EXPECT_LE(points[front[n - 1]].cost, points[front[n]].cost);
            EXPECT_GE(points[front[n - 1]].error, points[front[n]].error);
        }
    }
}

TEST(ParetoFront, WhatBeatsAPointIsTheBestThatDoes) {
    const std::vector<CostError> points = {{1.0, 9.0}, {2.0, 4.0}, {3.0, 2.0}, {3.5, 2.0}, {4.0, 5.0}};
    EXPECT_EQ(front_of(points), (std::vector<std::size_t>{0, 1, 2}));
    EXPECT_EQ(beaten_by(points, 4), 2u);
    EXPECT_EQ(beaten_by(points, 3), 2u);
    EXPECT_EQ(beaten_by(points, 0), std::nullopt);
}

TEST(ParetoFront, EqualPointsAreOnItTogether) {
    const std::vector<CostError> points = {{2.0, 3.0}, {2.0, 3.0}, {2.0, 4.0}};
    EXPECT_EQ(front_of(points), (std::vector<std::size_t>{0, 1}));
}

TEST(ParetoFront, WhatIsNotFiniteIsOnNone) {
    const std::vector<CostError> points = {{1.0, k_nan}, {1.0, k_infinite}, {2.0, 5.0}, {k_nan, 1.0}};
    EXPECT_EQ(front_of(points), (std::vector<std::size_t>{2}));
    EXPECT_EQ(beaten_by(points, 0), 2u);
    EXPECT_TRUE(front_of(std::vector<CostError>{{1.0, k_nan}}).empty());
    EXPECT_TRUE(front_of({}).empty());
}

} // namespace
} // namespace windrow::cli
