// Masks by height: their values at root, middle and tip. The droop: any number of shells, any shape p > 0, 1 included.
#include "coupling/plant_numerics.h"
#include "coupling/shell.h"
#include "tests/figure.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace windrow {
namespace {

using namespace numerics;

float log_of(double p) {
    return static_cast<float>(std::log(p));
}

// In extended precision, with its own limit at p = 1.
double droop_reference(double h, double p) {
    const long double x = std::log(static_cast<long double>(p));
    return static_cast<double>(x == 0.0L ? static_cast<long double>(h) : std::expm1(h * x) / std::expm1(x));
}

TEST(PlantMasks, HaveTheirValuesAtRootMiddleAndTip) {
    for (const float exponent : {0.25f, 1.0f, 2.0f, 3.5f}) {
        EXPECT_EQ(windrow_mask_power(0.0f, exponent), 0.0f);
        EXPECT_NEAR(windrow_mask_power(0.5f, exponent), std::pow(0.5, exponent), 1e-7);
        EXPECT_EQ(windrow_mask_power(1.0f, exponent), 1.0f);
    }
    for (const float curve : {0.0f, 0.5f, 1.0f}) {
        EXPECT_EQ(windrow_mask_own(0.0f, curve), 0.0f);
        EXPECT_EQ(windrow_mask_own(0.5f, curve), 0.5f - 0.25f * curve);
        EXPECT_EQ(windrow_mask_own(1.0f, curve), 1.0f);
    }
    for (const float sharpness : {0.0f, 0.4f, 3.7f}) {
        EXPECT_EQ(windrow_mask_drag(0.0f, sharpness), 0.0f);
        EXPECT_NEAR(windrow_mask_drag(0.5f, sharpness), 1.0 - std::pow(0.5 / (1.0 + 0.5 * sharpness), 3.0), 1e-7);
        EXPECT_EQ(windrow_mask_drag(1.0f, sharpness), 1.0f);
    }
    for (const double p : {1e-3, 0.5, 1.0, 3.0, 1e3}) {
        EXPECT_EQ(windrow_mask_droop(0.0f, log_of(p)), 0.0f);
        EXPECT_NEAR(windrow_mask_droop(0.5f, log_of(p)), 1.0 / (1.0 + std::sqrt(p)), 1e-6);
        EXPECT_EQ(windrow_mask_droop(1.0f, log_of(p)), 1.0f);
    }
}

TEST(PlantMasks, GrowFromRootToTip) {
    for (int n = 0; n < 1000; ++n) {
        const float low = static_cast<float>(n) / 1000.0f, high = static_cast<float>(n + 1) / 1000.0f;
        for (const float x : {0.0f, 0.3f, 1.0f, 3.67f}) {
            ASSERT_LE(windrow_mask_drag(low, x), windrow_mask_drag(high, x));
            ASSERT_LE(windrow_mask_power(low, 0.2f + x), windrow_mask_power(high, 0.2f + x));
        }
        for (const double p : {1e-3, 0.3, 0.9999999, 1.0, 1.0000001, 3.0, 1e3})
            ASSERT_LE(windrow_mask_droop(low, log_of(p)), windrow_mask_droop(high, log_of(p)) + 6e-8f) << p; // half a last digit
    }
}

TEST(PlantMasks, ExpMinusOneKeepsItsDigits) {
    double most = 0.0;
    for (int n = -80000; n <= 80000; ++n) {
        const float x = static_cast<float>(n) * 1e-3f;
        for (const float value : {x, x * 1e-4f, x * 1e-9f})
            if (value != 0.0f)
                most = std::max(
                    most, std::abs(static_cast<double>(windrow_expm1(value)) / std::expm1(static_cast<double>(value)) - 1.0));
    }
    WINDROW_EXPECT_FIGURE("plants/masks/expm1_relative_error", most, 5e-7); // a few roundings of 6e-8 each
    EXPECT_EQ(windrow_expm1(0.0f), 0.0f);
}

TEST(Droop, IsRightForEveryShapeAndThroughOne) {
    double most = 0.0, plain = 0.0;
    const auto look = [&](double p) {
        for (int n = 0; n <= 200; ++n) {
            const float h = static_cast<float>(n) / 200.0f;
            const double right = droop_reference(static_cast<double>(h), p);
            most = std::max(most, std::abs(static_cast<double>(windrow_mask_droop(h, log_of(p))) - right));
            const float p_single = static_cast<float>(p);
            plain = std::max(plain, std::abs(static_cast<double>((std::pow(p_single, h) - 1.0f) / (p_single - 1.0f)) - right));
        }
    };
    for (int n = 0; n <= 600; ++n)
        look(std::pow(10.0, -3.0 + 0.01 * n));
    for (int n = 1; n <= 15; ++n) {
        look(1.0 + std::pow(10.0, -n));
        look(1.0 - std::pow(10.0, -n));
    }
    look(1.0);
    WINDROW_EXPECT_FIGURE("plants/droop/error", most, 1e-6);
    test::figure("plants/droop/error_of_the_plain_form_beside_one", plain); // at 1 it is 0 / 0
}

TEST(Droop, OfTheTipDoesNotDependOnTheNumberOfShells) {
    float tips[2], quarter[2];
    for (int n = 0; n < 2; ++n) {
        const int count = n == 0 ? 13 : 201; // both have a shell at a quarter, and the outermost
        const auto shells = Shells::create({.shells = count, .droop = 0.02f, .droop_shape = 3.0f});
        ASSERT_TRUE(shells);
        const auto fall = [&](int i) {
            const glm::vec3 normal{1.0f, 0.0f, 0.0f};
            return shells->translated(glm::vec3(0.0f), normal, shells->height(i), 1.0f, glm::vec3(0.0f)).y;
        };
        tips[n] = fall(count - 1);
        quarter[n] = fall((count - 1) / 4);
    }
    WINDROW_EXPECT_FIGURE("plants/droop/tip_10_to_200_shells", std::abs(tips[0] - tips[1]), 1e-6);
    WINDROW_EXPECT_FIGURE("plants/droop/quarter_10_to_200_shells", std::abs(quarter[0] - quarter[1]), 1e-6);
    EXPECT_EQ(tips[0], -0.02f);
}

TEST(Droop, RejectsAShapeOfZeroOrLess) {
    for (const float shape : {0.0f, -1.0f, std::nanf(""), std::numeric_limits<float>::infinity()}) {
        const auto shells = Shells::create({.droop_shape = shape});
        ASSERT_FALSE(shells);
        EXPECT_NE(shells.error().find("droop_shape"), std::string::npos) << shells.error();
    }
}

} // namespace
} // namespace windrow
