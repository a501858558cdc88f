// The lee of a solid wall in a gusty wind: slow air that turns back, stronger gusts than in the open, and grass that bends less.
//
// McNaughton 1989, Philosophical Transactions of the Royal Society B 324: a turbulent wake begins at the top of a shelter belt and
// reaches the ground some eight heights behind it.
#include "coupling/blade.h"
#include "fluid/wind.h"
#include "tests/figure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <string>
#include <utility>
#include <vector>

namespace windrow {
namespace {

constexpr double k_height = 4.0;              // [m] of the wall, across the wind at x = 0
constexpr double k_front = -6.0, k_lee = 2.0; // heights from the wall
/// Heights behind the wall, and the greatest bend of grass there over that before the wall.
constexpr std::pair<double, double> k_calm[] = {{0.5, 0.6}, {1.0, 0.75}, {k_lee, 0.9}};
constexpr std::array k_levels{0.125, 0.375, 0.625, 0.875, 1.125, 1.625};

/// Mean and standard deviation of the wind along x at places, and the mean bend of grass there.
struct Station {
    double x;
    std::array<double, k_levels.size()> sum{}, squares{};
    double bend = 0.0;
    int count = 0, blades = 0;

    void read(const Wind& wind, const Blades& grass) {
        for (double z = -6.0; z <= 6.0; z += 3.0) {
            for (std::size_t level = 0; level < k_levels.size(); ++level) {
                const auto u = static_cast<double>(wind.velocity({x, k_levels[level] * k_height, z}).x);
                sum[level] += u;
                squares[level] += u * u;
            }
            ++count;
            for (std::uint32_t blade = 0; blade < 4; ++blade, ++blades)
                bend += static_cast<double>(glm::length(grass.load({blade, 7u}, wind.velocity({x, 0.4, z}))));
        }
    }
    [[nodiscard]] double mean(std::size_t level) const { return sum[level] / count; }
    [[nodiscard]] double rms(std::size_t level) const { return std::sqrt(squares[level] / count - mean(level) * mean(level)); }
};

TEST(Shelter, GustsAndGrassBehindAWall) {
    auto wind = Wind::create({.cells = {64, 16, 40},
                              .boundaries = Boundaries::open_over_floor(),
                              .centre = {4.0, 8.0, 0.0},
                              .follow_axes = glm::bvec3(false),
                              .ambient = {8.0f, 0.0f, 0.0f},
                              .profile = LogProfile{.roughness_length = 0.05f, .reference_height = 10.0f},
                              .gusts = {.intensity = 0.12f, .length = 12.0f},
                              .relaxation_time = 60.0f});
    ASSERT_TRUE(wind) << wind.error();
    const auto wall = wind->obstacles().add(
        {.position = {0.0, 0.5 * k_height, 0.0}, .shape = Block{{0.5f, static_cast<float>(0.5 * k_height), 14.0f}}});
    ASSERT_TRUE(wall) << wall.error();
    const auto grass = Blades::create({});
    ASSERT_TRUE(grass) << grass.error();
    Station front{.x = k_front * k_height};
    std::vector<Station> behind;
    for (const auto& [heights, bend] : k_calm)
        behind.push_back({.x = heights * k_height});
    const Station& lee = behind.back();
    constexpr double k_step = 1.0 / 15.0;
    constexpr int k_begin = 15 * 12, k_end = 15 * 60;
    for (int step = 0; step < k_end; ++step) {
        (void)wind->step(k_step);
        if (step >= k_begin && step % 3 == 0) {
            front.read(*wind, *grass);
            for (Station& station : behind)
                station.read(*wind, *grass);
        }
    }
    double strongest = 0.0; // [m/s]
    std::puts("height over H, mean before, behind [m/s], ratio; RMS before, behind [m/s], ratio");
    for (std::size_t level = 0; level < k_levels.size(); ++level) {
        const double calm = lee.mean(level) / front.mean(level), gusts = lee.rms(level) / front.rms(level);
        std::printf("%.3f  %.2f %.2f %.2f  %.2f %.2f %.2f\n", k_levels[level], front.mean(level), lee.mean(level), calm,
                    front.rms(level), lee.rms(level), gusts);
        test::figure("shelter/rms_ratio/" + std::to_string(static_cast<int>(1000.0 * k_levels[level])), gusts);
        if (k_levels[level] < 1.0) {
            WINDROW_EXPECT_FIGURE("shelter/mean_ratio", std::abs(calm), 0.75);
        }
        strongest = std::max(strongest, lee.rms(level));
    }
    // The wake's gusts come from the shear at the wall's top, not from those of the wind.
    const double top = 0.5 * (front.mean(3) + front.mean(4));
    WINDROW_EXPECT_FIGURE("shelter/strongest_rms_over_speed_at_top", strongest / top, 0.45);
    EXPECT_GT(strongest / top, 0.15);
    for (std::size_t n = 0; n < behind.size(); ++n) {
        const auto& [heights, most] = k_calm[n];
        WINDROW_EXPECT_FIGURE("shelter/bend_ratio/" + std::to_string(static_cast<int>(10.0 * heights)),
                              behind[n].bend / behind[n].blades * (front.blades / front.bend), most);
    }
}

} // namespace
} // namespace windrow
