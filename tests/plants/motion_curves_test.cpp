// The curves for the plots say what the rows say: rates and numbers of shells fall together, the source's shells do not.
#include "cli/plants/plants_command.h"
#include "tests/figure.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace windrow::cli {
namespace {

// First time at which a curve has done 90 % of its way [s].
double time_of_90(const PlotCurve& curve) {
    for (const glm::dvec2 point : curve.points)
        if (point.y >= 0.9)
            return point.x;
    return std::numeric_limits<double>::infinity();
}

TEST(MotionCurves, RatesFallTogetherWhereTheyMeet) {
    const int rates[] = {15, 30, 60, 144, 1000};
    const auto curves = spring_response_curves(springs::wheat, rates, 3.0);
    ASSERT_EQ(curves.size(), 5u);
    double worst = 0.0, highest = 0.0;
    for (std::size_t n = 1; n < curves.size(); ++n)
        for (std::size_t second = 1; second <= 3; ++second)
            worst = std::max(worst, std::abs(curves[n].points[second * static_cast<std::size_t>(rates[n])].y -
                                             curves[0].points[second * 15].y));
    for (const glm::dvec2 point : curves[4].points)
        highest = std::max(highest, point.y);
    WINDROW_EXPECT_FIGURE("curves/spring_rates", worst, 1e-6);
    EXPECT_GT(highest, 1.5); // wheat swings past
    EXPECT_TRUE(spring_response_curves({-1.0, 0.1}, rates, 1.0).empty());
}

TEST(MotionCurves, OurShellsFallTogetherAndTheSourcesDoNot) {
    const int shells[] = {20, 200};
    const auto curves = cascade_curves({}, shells, 12.0);
    ASSERT_EQ(curves.size(), 4u);
    double worst = 0.0;
    for (std::size_t n = 0; n < curves[0].points.size(); ++n)
        worst = std::max(worst, std::abs(curves[0].points[n].y - curves[2].points[n].y));
    WINDROW_EXPECT_FIGURE("curves/shells", worst, 1e-6);
    const double few = test::figure("curves/source_20_shells_90_percent_s", time_of_90(curves[1]));
    const double many = test::figure("curves/source_200_shells_90_percent_s", time_of_90(curves[3]));
    EXPECT_GT(many, 8.0 * few);
    EXPECT_TRUE(cascade_curves({.stages = 0}, shells, 1.0).empty());
}

} // namespace
} // namespace windrow::cli
