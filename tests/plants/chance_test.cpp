// Random traits of a plant are even and shared by all its vertices; and the bend that depends on the view.
#include "coupling/blade.h"
#include "coupling/plant_numerics.h"
#include "tests/fields.h"
#include "tests/figure.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <set>
#include <utility>
#include <vector>

namespace windrow {
namespace {

using test::Random;

// The same steps on single words, without vectors: what a GPU must find too.
PlantKey hash_by_words(PlantKey key) {
    std::uint32_t x = key.x * 1664525u + 1013904223u, y = key.y * 1664525u + 1013904223u;
    for (int round = 0; round < 2; ++round) {
        x += y * 1664525u;
        y += x * 1664525u;
        x ^= x >> 16;
        y ^= y >> 16;
    }
    const auto last = [](std::uint32_t v) {
        v *= 0x7feb352du;
        v ^= v >> 15;
        v *= 0x846ca68bu;
        return v ^ (v >> 16);
    };
    return {last(x), last(y)};
}

double chi_squared(const std::vector<int>& bins, double expected) {
    double sum = 0.0;
    for (const int count : bins)
        sum += (count - expected) * (count - expected) / expected;
    return sum;
}

TEST(PlantChance, DoesNotRepeatOverAMeadow) {
    // Cells of a field of 500 m at 8 blades a metre would be 16 million; a corner of it shows what a weak hash repeats (a seed x
    // + 100 y repeats for 90 % of the cells at 1000 a side).
    std::set<std::pair<std::uint32_t, std::uint32_t>> seen;
    for (std::uint32_t x = 0; x < 1000; ++x)
        for (std::uint32_t y = 0; y < 1000; ++y) {
            const PlantKey hash = numerics::windrow_plant_hash({x, y});
            ASSERT_EQ(hash, hash_by_words({x, y}));
            seen.emplace(hash.x, hash.y);
        }
    EXPECT_EQ(seen.size(), 1'000'000u);
    EXPECT_NE(place_key(1.0f, 2.0f), place_key(2.0f, 1.0f));
    EXPECT_EQ(place_key(0.0f, -0.0f), place_key(-0.0f, 0.0f));
}

TEST(PlantChance, YawsAndStiffnessesAreEven) {
    std::vector<int> yaws(16), factors(16);
    double product = 0.0, spread = 0.0, neighbours = 0.0, last = 0.0;
    constexpr int k_blades = 100'000;
    for (int n = 0; n < k_blades; ++n) {
        const PlantKey key = place_key(0.17f * static_cast<float>(n % 400), 0.17f * static_cast<float>(n / 400));
        const double yaw = static_cast<double>(plant_yaw(key)) / 6.283185307179586;
        const double factor = (static_cast<double>(plant_stiffness(key, 0.5f)) - 0.5);
        ASSERT_GE(yaw, 0.0);
        ASSERT_LT(yaw, 1.0);
        ++yaws[static_cast<std::size_t>(yaw * 16.0)];
        ++factors[static_cast<std::size_t>(std::min(factor * 16.0, 15.0))];
        product += (yaw - 0.5) * (factor - 0.5);
        neighbours += (yaw - 0.5) * (last - 0.5);
        spread += (yaw - 0.5) * (yaw - 0.5);
        last = yaw;
    }
    // 30.58: 1 % of random fields have a chi squared of 15 degrees of freedom beyond it.
    WINDROW_EXPECT_FIGURE("plants/chance/yaw_chi_squared", chi_squared(yaws, k_blades / 16.0), 30.58);
    WINDROW_EXPECT_FIGURE("plants/chance/stiffness_chi_squared", chi_squared(factors, k_blades / 16.0), 30.58);
    // 4 sigma of no correlation.
    WINDROW_EXPECT_FIGURE("plants/chance/yaw_to_stiffness_correlation", std::abs(product / spread), 4.0 / std::sqrt(k_blades));
    WINDROW_EXPECT_FIGURE("plants/chance/yaw_to_neighbour_correlation", std::abs(neighbours / spread), 4.0 / std::sqrt(k_blades));
}

TEST(PlantChance, AllVerticesOfABladeShareItsYaw) {
    const auto grass = Blades::create({.rest_bend = 0.0f, .rest_bend_spread = 0.0f});
    ASSERT_TRUE(grass);
    Random random(1);
    double off = 0.0;
    for (int n = 0; n < 1000; ++n) {
        const PlantKey key{random.bits(), random.bits()};
        const glm::vec3 facing = grass->vertex(key, glm::vec3(0.0f), 0.0f, 0.0f).normal;
        for (int row = 1; row <= 8; ++row)
            for (const float side : {-1.0f, 1.0f})
                ASSERT_EQ(grass->vertex(key, glm::vec3(0.0f), static_cast<float>(row) / 8.0f, side).normal, facing);
        const double yaw = static_cast<double>(plant_yaw(key));
        off = std::max(off, glm::length(glm::dvec3(facing) - glm::dvec3(std::cos(yaw), 0.0, std::sin(yaw))));
    }
    WINDROW_EXPECT_FIGURE("plants/chance/yaw_vector_error", off, 1e-6);
}

TEST(ViewBend, IsNothingSeenLevelAndMostSeenFromAbove) {
    const glm::vec3 up{0.0f, 1.0f, 0.0f};
    EXPECT_EQ(numerics::windrow_view_fraction({1.0f, 0.0f, 0.0f}, up), 0.0f);
    EXPECT_EQ(numerics::windrow_view_fraction({0.0f, 1.0f, 0.0f}, up), 0.0f);
    EXPECT_EQ(numerics::windrow_view_fraction({0.0f, -1.0f, 0.0f}, up), 1.0f);
    float before = -1.0f;
    for (int n = 0; n <= 90; ++n) {
        const float down = static_cast<float>(n) * 3.14159265f / 180.0f;
        const float share = numerics::windrow_view_fraction({std::cos(down), -std::sin(down), 0.0f}, up);
        ASSERT_GT(share, before);
        before = share;
    }
    const auto grass = Blades::create({.rest_bend = 0.2f, .rest_bend_spread = 0.0f, .view_bend = 0.7f});
    ASSERT_TRUE(grass);
    const auto lean = [&](glm::vec3 view) {
        return std::acos(static_cast<double>(grass->vertex({1, 1}, glm::vec3(0.0f), 1.0f, 0.0f, view).tangent.y));
    };
    EXPECT_NEAR(lean({1.0f, 0.0f, 0.0f}), 0.2, 1e-5);
    EXPECT_NEAR(lean({0.0f, -1.0f, 0.0f}), 0.9, 1e-5);
}

// Fraction of a square metre that 400 blades cover, seen from straight above: the strips, drawn into 512 x 512 points.
double coverage(float view_bend) {
    const auto grass = Blades::create({.rest_bend = 0.2f, .rest_bend_spread = 0.1f, .view_bend = view_bend});
    EXPECT_TRUE(grass);
    constexpr int k_side = 512, k_rows = 12;
    std::vector<bool> covered(k_side * k_side);
    const auto draw = [&](glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) { // a triangle by its bounding box
        const glm::dvec2 low = glm::min(a, glm::min(b, c)), high = glm::max(a, glm::max(b, c));
        const auto sign = [](glm::dvec2 p, glm::dvec2 q, glm::dvec2 r) {
            return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
        };
        for (int y = std::max(0, static_cast<int>(low.y)); y <= std::min(k_side - 1, static_cast<int>(high.y)); ++y)
            for (int x = std::max(0, static_cast<int>(low.x)); x <= std::min(k_side - 1, static_cast<int>(high.x)); ++x) {
                const glm::dvec2 p(x + 0.5, y + 0.5);
                const double s = sign(a, b, p), t = sign(b, c, p), u = sign(c, a, p);
                if ((s >= 0.0 && t >= 0.0 && u >= 0.0) || (s <= 0.0 && t <= 0.0 && u <= 0.0))
                    covered[static_cast<std::size_t>(y * k_side + x)] = true;
            }
    };
    for (std::uint32_t n = 0; n < 400; ++n) {
        const PlantKey key{n, 7};
        const glm::dvec2 root((n % 20 + 0.5) / 20.0, (n / 20 + 0.5) / 20.0);
        const auto point = [&](int row, float side) {
            const glm::vec3 p =
                grass->vertex(key, glm::vec3(0.0f), static_cast<float>(row) / k_rows, side, {0.0f, -1.0f, 0.0f}).position;
            return (root + glm::dvec2(p.x, p.z)) * static_cast<double>(k_side);
        };
        for (int row = 0; row < k_rows; ++row) {
            draw(point(row, -1.0f), point(row, 1.0f), point(row + 1, 1.0f));
            draw(point(row, -1.0f), point(row + 1, 1.0f), point(row + 1, -1.0f));
        }
    }
    return static_cast<double>(std::count(covered.begin(), covered.end(), true)) / static_cast<double>(covered.size());
}

TEST(ViewBend, CoversMoreGroundSeenFromAbove) {
    const double without = coverage(0.0f), with = coverage(0.7f);
    test::figure("plants/view_bend/coverage_without_percent", 100.0 * without);
    test::figure("plants/view_bend/coverage_with_0.7_rad_percent", 100.0 * with);
    EXPECT_GT(with, without);
}

} // namespace
} // namespace windrow
