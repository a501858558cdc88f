// Simplex noise of clouds: range, evenness, smoothness, and no visible lattice.
#include "tests/fields.h"
#include "tests/figure.h"
#include "vegetation/fur/strand_numerics.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace windrow::vegetation::fur {
namespace {

using windrow::test::Random;

double noise(glm::dvec3 at) {
    return static_cast<double>(numerics::windrow_simplex(1u, glm::vec3(at)));
}

TEST(Simplex, KeepsItsRangeAndMean) {
    Random random(1);
    constexpr int k_count = 400'000;
    double low = 0.0, high = 0.0, sum = 0.0, squares = 0.0;
    for (int n = 0; n < k_count; ++n) {
        const double value = noise(random.point(500.0));
        low = std::min(low, value);
        high = std::max(high, value);
        sum += value;
        squares += value * value;
    }
    WINDROW_EXPECT_FIGURE("shells/simplex/highest", std::max(high, -low), 1.0);
    EXPECT_GT(windrow::test::figure("shells/simplex/lowest_of_both_ends", std::min(high, -low)), 0.7);
    const double deviation = windrow::test::figure("shells/simplex/deviation", std::sqrt(squares / k_count));
    // 0 within four standard errors, were all samples independent.
    WINDROW_EXPECT_FIGURE("shells/simplex/mean", std::abs(sum / k_count),
                          4.0 * deviation / std::sqrt(static_cast<double>(k_count)));
}

// Value and slope across the borders of simplices, where kernels begin: both change by no more than a step's worth anywhere.
TEST(Simplex, ValueAndSlopeAreContinuous) {
    Random random(2);
    double jump = 0.0, slope_jump = 0.0, off = 0.0, steepest = 0.0;
    for (int line = 0; line < 300; ++line) {
        const glm::dvec3 from = random.point(20.0), along = random.direction();
        constexpr double k_step = 1e-3;
        glm::vec4 last = numerics::windrow_simplex_slope(1u, glm::vec3(from));
        for (int n = 1; n < 2000; ++n) {
            const glm::vec4 now = numerics::windrow_simplex_slope(1u, glm::vec3(from + n * k_step * along));
            jump = std::max(jump, static_cast<double>(std::abs(now.w - last.w)));
            slope_jump = std::max(slope_jump, static_cast<double>(glm::length(glm::vec3(now) - glm::vec3(last))));
            steepest = std::max(steepest, static_cast<double>(glm::length(glm::vec3(now))));
            last = now;
        }
        // The returned slope is that of the values: centred differences of 1/64 unit, second order.
        const glm::dvec3 at = from + along;
        constexpr double k_apart = 1.0 / 64.0;
        const double difference = (noise(at + k_apart * along) - noise(at - k_apart * along)) / (2.0 * k_apart);
        const glm::vec3 slope(numerics::windrow_simplex_slope(1u, glm::vec3(at)));
        off = std::max(off, std::abs(difference - glm::dot(glm::dvec3(slope), along)));
    }
    windrow::test::figure("shells/simplex/steepest", steepest);
    WINDROW_EXPECT_FIGURE("shells/simplex/jump_in_a_thousandth", jump, 1e-3 * steepest + 1e-5);
    // One kernel's slope changes by at most 42 a unit (t^2 r (72 r^2 - 12) of the noise's factor at r = 0.2); neighbours add to
    // it.
    WINDROW_EXPECT_FIGURE("shells/simplex/slope_jump_in_a_thousandth", slope_jump, 0.05);
    WINDROW_EXPECT_FIGURE("shells/simplex/slope_off_differences", off, 0.03);
}

// Correlation at a distance is the same in every direction, and the noise has the same spread on every plane.
TEST(Simplex, HasNoDirectionAndNoLattice) {
    Random random(3);
    double least = 1.0, most = -1.0;
    for (int n = 0; n < 60; ++n) {
        const glm::dvec3 along = n == 0   ? glm::dvec3(1.0, 0.0, 0.0)
                                 : n == 1 ? glm::dvec3(0.0, 1.0, 0.0)
                                 : n == 2 ? glm::normalize(glm::dvec3(1.0))
                                 : n == 3 ? glm::normalize(glm::dvec3(1.0, 1.0, 0.0))
                                          : random.direction();
        double both = 0.0, squares = 0.0;
        for (int k = 0; k < 20'000; ++k) {
            const glm::dvec3 at = random.point(200.0);
            const double a = noise(at), b = noise(at + 0.35 * along);
            both += a * b;
            squares += 0.5 * (a * a + b * b);
        }
        least = std::min(least, both / squares);
        most = std::max(most, both / squares);
    }
    windrow::test::figure("shells/simplex/correlation_at_0.35_least", least);
    // 20,000 samples give a correlation to 0.007; 60 directions spread by about five of that.
    WINDROW_EXPECT_FIGURE("shells/simplex/correlation_spread_over_directions", most - least, 0.08);

    // Planes through many depths: a lattice that showed would make quiet and loud ones.
    double quiet = 10.0, loud = 0.0;
    for (int plane = 0; plane < 48; ++plane)
        for (int axis = 0; axis < 3; ++axis) {
            double squares = 0.0;
            for (int k = 0; k < 8000; ++k) {
                glm::dvec3 at = random.point(300.0);
                at[axis] = 0.0625 * plane;
                const double value = noise(at);
                squares += value * value;
            }
            quiet = std::min(quiet, std::sqrt(squares / 8000));
            loud = std::max(loud, std::sqrt(squares / 8000));
        }
    WINDROW_EXPECT_FIGURE("shells/simplex/loudest_plane_over_quietest", loud / quiet, 1.3);
}

TEST(Simplex, NothingRepeats) {
    // Correlation with the same noise shifted by whole powers of two, where tables of 256 would repeat.
    Random random(4);
    double largest = 0.0;
    for (const double shift : {64.0, 128.0, 256.0, 512.0, 4096.0})
        for (int axis = 0; axis < 3; ++axis) {
            glm::dvec3 by(0.0);
            by[axis] = shift;
            double both = 0.0, squares = 0.0;
            for (int k = 0; k < 20'000; ++k) {
                const glm::dvec3 at = random.point(100.0);
                const double a = noise(at), b = noise(at + by);
                both += a * b;
                squares += a * a;
            }
            largest = std::max(largest, std::abs(both / squares));
        }
    WINDROW_EXPECT_FIGURE("shells/simplex/correlation_after_a_shift", largest, 0.035); // five standard errors of 1 / sqrt(20,000)
}

TEST(Simplex, OctavesKeepTheRange) {
    Random random(5);
    double highest = 0.0, squares = 0.0;
    constexpr int k_count = 100'000;
    for (int n = 0; n < k_count; ++n) {
        const double value = static_cast<double>(numerics::windrow_simplex_octaves(1u, glm::vec3(random.point(300.0)), 4, 0.5f));
        highest = std::max(highest, std::abs(value));
        squares += value * value;
    }
    WINDROW_EXPECT_FIGURE("shells/simplex/octaves_highest", highest, 1.0);
    windrow::test::figure("shells/simplex/octaves_deviation", std::sqrt(squares / k_count));
}

} // namespace
} // namespace windrow::vegetation::fur
