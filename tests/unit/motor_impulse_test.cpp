// Regions thinner than the cells: widened until they are seen, and weakened so that their total impulse stays.

#include "fluid/wind.h"
#include "tests/fields.h"
#include "tests/figure.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <string>
#include <variant>

namespace {

using namespace windrow;
using namespace windrow::test;

constexpr Stages k_sources_only{.sources = true, .settling = false, .diffusion = false, .advection = false, .projection = false};

// Volume of a region's weight.
double volume_of(const Region& region) {
    const double pi = std::numbers::pi;
    if (const auto* sphere = std::get_if<Sphere>(&region))
        return 32.0 * pi / 105.0 * std::pow(double(sphere->radius), 3);
    if (const auto* capsule = std::get_if<Capsule>(&region)) {
        const double radius = capsule->radius, length = 2.0 * glm::length(glm::dvec3(capsule->half_axis));
        return 32.0 * pi / 105.0 * std::pow(radius, 3) + pi / 3.0 * radius * radius * length;
    }
    const glm::dvec3 half(std::get<AlignedBox>(region).half_size);
    return std::pow(16.0 / 15.0, 3) * half.x * half.y * half.z;
}

// Sampled at cell centres, a region of 1.5 cells gives a few per cent more or less as it lies; over all places the mean is right.
TEST(MotorImpulse, WideningKeepsTheTotalImpulse) {
    Random random(9);
    const auto check = [&](const std::string& name, const auto& region_of, double bound, double mean_bound) {
        double worst = 0.0, mean = 0.0;
        const int trials = 400;
        for (int trial = 0; trial < trials; ++trial) {
            const float h = static_cast<float>(random.spread(0.1, 10.0));
            auto wind = Wind::create({.cells = {16, 16, 16}, .cell_size = h, .stages = k_sources_only});
            ASSERT_TRUE(wind) << wind.error();
            const Region region = region_of(h);
            ASSERT_TRUE(wind->motors().add(DirectionalMotor{
                .position = random.point(1.0) * double(h), .region = region, .law = Force{10.0f}, .turbulence = k_steady}));
            wind->step(0.1);
            double impulse = 0.0;
            for (const glm::vec4& u : wind->field())
                impulse += u.x;
            const double ratio = impulse * std::pow(double(h), 3) / volume_of(region);
            worst = std::max(worst, std::abs(ratio - 1.0));
            mean += ratio / trials;
        }
        WINDROW_EXPECT_FIGURE("widened_" + name, worst, bound);
        WINDROW_EXPECT_FIGURE("widened_" + name + "_mean", std::abs(mean - 1.0), mean_bound);
    };
    const auto thin = [&](float h) { return h * static_cast<float>(random.spread(0.02, 1.5)); };
    check(
        "sphere", [&](float h) { return Region(Sphere{thin(h)}); }, 0.1, 0.005);
    check(
        "capsule", [&](float h) { return Region(Capsule{.half_axis = random.vector(3.0f * h), .radius = thin(h)}); }, 0.04,
        0.005);
    check(
        "box",
        [&](float h) {
            return Region(AlignedBox{{thin(h), thin(h), thin(h)}});
        },
        0.04, 0.005);
    check(
        "flat_box",
        [&](float h) {
            return Region(AlignedBox{{4.0f * h, thin(h), 4.0f * h}});
        },
        0.02, 0.005);
}

} // namespace
