// The path integral of a wake, as the shared text has it in float, against quadrature in double; and its sums over pieces.

#include "fluid/core/numerics.h"
#include "tests/winds.h"

namespace {

using namespace windrow::numerics;
using windrow::test::biweight;
using windrow::test::Random;

// Gauss-Legendre with five points a panel: exact for the polynomial of degree four inside the ball, so the panels only have to
// meet its rim, where the integrand has a kink in its second derivative.
double path_integral(glm::dvec3 p, glm::dvec3 start, glm::dvec3 end, double radius) {
    constexpr double k_node[5] = {-0.9061798459386640, -0.5384693101056831, 0.0, 0.5384693101056831, 0.9061798459386640};
    constexpr double k_weight[5] = {0.2369268850561891, 0.4786286704993665, 0.5688888888888889, 0.4786286704993665,
                                    0.2369268850561891};
    const double length = glm::length(end - start);
    const int panels = 2000;
    double sum = 0.0;
    for (int panel = 0; panel < panels; ++panel)
        for (int n = 0; n < 5; ++n) {
            const double t = (panel + 0.5 + 0.5 * k_node[n]) / panels;
            const glm::dvec3 off = p - glm::mix(start, end, t);
            sum += 0.5 * k_weight[n] / panels * biweight(glm::dot(off, off) / (radius * radius));
        }
    return sum * length;
}

TEST(WakePath, EqualsQuadratureForRandomPaths) {
    Random random(21);
    double worst = 0.0;
    int met = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        const float radius = static_cast<float>(random.spread(0.3, 5.0));
        const vec3 start = random.vector(16.0f), end = start + glm::vec3(random.direction() * random.spread(1e-3, 30.0));
        // Near the path, and sometimes beyond its ends.
        const vec3 p = glm::mix(start, end, random.uniform(-0.3f, 1.3f)) + random.vector(0.8f * radius);
        const double expected = path_integral(p, start, end, radius);
        met += expected > 0.0;
        worst = std::max(worst, std::abs(windrow_wake_path(p, start, end, radius) - expected) / radius);
    }
    EXPECT_GT(met, 1000);
    WINDROW_EXPECT_FIGURE("wake_path_error", worst, 2e-5); // per radius; positions of 30 m in float are good to 2e-6 m
}

TEST(WakePath, PiecesOfThePathAddUp) {
    Random random(22);
    double worst = 0.0;
    for (int trial = 0; trial < 20000; ++trial) {
        const float radius = static_cast<float>(random.spread(0.3, 5.0));
        const vec3 start = random.vector(16.0f), end = start + random.vector(10.0f);
        const vec3 middle = glm::mix(start, end, random.uniform(0.0f, 1.0f));
        const vec3 p = glm::mix(start, end, random.uniform(0.0f, 1.0f)) + random.vector(0.6f * radius);
        const double whole = windrow_wake_path(p, start, end, radius);
        const double pieces = double(windrow_wake_path(p, start, middle, radius)) + windrow_wake_path(p, middle, end, radius);
        worst = std::max(worst, std::abs(pieces - whole) / radius);
    }
    WINDROW_EXPECT_FIGURE("wake_path_pieces", worst, 2e-5);
}

TEST(WakePath, IsZeroWhereNothingPasses) {
    Random random(23);
    const vec3 start(3.0f, 4.0f, 5.0f);
    for (int trial = 0; trial < 1000; ++trial) {
        EXPECT_EQ(windrow_wake_path(start + random.vector(0.5f), start, start, 1.0f), 0.0f) << "a path of no length";
        const vec3 away = start + 2.001f * glm::vec3(random.direction());
        EXPECT_EQ(windrow_wake_path(away, start, start + random.vector(0.5f), 1.0f), 0.0f)
            << "farther than radius and path together";
    }
    // Through the middle of the ball, from before it to behind it: the integral of (1 - t^2)^2 over [-1, 1] is 16/15.
    EXPECT_NEAR(windrow_wake_path(vec3(0.0f), vec3(-9.0f, 0.0f, 0.0f), vec3(9.0f, 0.0f, 0.0f), 2.0f), 2.0f * 16.0f / 15.0f,
                1e-6f);
    EXPECT_NEAR(windrow_wake_path(vec3(0.0f), vec3(0.0f), vec3(0.0f, 0.0f, 9.0f), 2.0f), 16.0f / 15.0f, 1e-6f) << "half of it";
}

TEST(WakePath, StaysFiniteForAnyBody) {
    Random random(24);
    for (int trial = 0; trial < 20000; ++trial) {
        const vec3 start = vec3(random.direction() * random.spread(1e-6, 1e12)),
                   end = vec3(random.direction() * random.spread(1e-6, 1e12));
        const float radius = static_cast<float>(random.spread(1e-5, 1e6));
        const float path = windrow_wake_path(random.vector(100.0f), start, end, radius);
        ASSERT_TRUE(std::isfinite(path));
        ASSERT_GE(path, -1e-5f * radius);
        ASSERT_LE(path, 1.1f * radius) << "no path through a ball is longer than 16/15 of its radius";
    }
}

} // namespace
