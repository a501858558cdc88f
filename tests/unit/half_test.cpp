// Half precision, against rounding done in double: all 65,536 halves, a million floats, and every tie.

#include "fluid/textures.h"
#include "tests/fields.h"
#include "tests/figure.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <limits>

namespace {

using namespace windrow;
using namespace windrow::test;

// The value of a half from its fields.
double value_of(std::uint16_t half) {
    const int exponent = (half >> 10) & 31, fraction = half & 1023;
    const double size = exponent == 0 ? std::ldexp(fraction, -24) : std::ldexp(1024 + fraction, exponent - 25);
    return (half & 0x8000) != 0 ? -size : size;
}

// The nearest half as a value: round to a multiple of the last place, ties to even by the processor's own rounding.
double nearest(float value) {
    if (std::isnan(value))
        return 0.0;
    if (std::abs(value) >= 65504.0f)
        return std::copysign(65504.0, value);
    const int exponent = value == 0.0f ? -14 : std::max(std::ilogb(value), -14);
    return std::ldexp(std::nearbyint(std::ldexp(double(value), 10 - exponent)), exponent - 10);
}

bool same(double a, double b) {
    return a == b && std::signbit(a) == std::signbit(b);
}

TEST(Half, EveryHalfIsItsValueAndComesBack) {
    for (std::uint32_t bits = 0; bits < 65536; ++bits) {
        const auto half = static_cast<std::uint16_t>(bits);
        const bool special = (half & 0x7c00) == 0x7c00, nan = special && (half & 0x3ff) != 0;
        if (nan) {
            EXPECT_TRUE(std::isnan(from_half(half)));
            EXPECT_EQ(to_half(from_half(half)), 0);
        } else if (special) {
            EXPECT_EQ(from_half(half),
                      std::copysign(std::numeric_limits<float>::infinity(), (half & 0x8000) != 0 ? -1.0f : 1.0f));
            EXPECT_EQ(to_half(from_half(half)), (half & 0x8000) | 0x7bff) << "a texture never holds infinity";
        } else {
            ASSERT_TRUE(same(from_half(half), value_of(half))) << bits;
            ASSERT_EQ(to_half(from_half(half)), half);
        }
    }
}

TEST(Half, EveryTieGoesToTheEvenOne) {
    for (std::uint32_t bits = 0; bits < 0x7bff; ++bits) {
        const auto below = static_cast<std::uint16_t>(bits), above = static_cast<std::uint16_t>(bits + 1);
        const double tie = 0.5 * (value_of(below) + value_of(above));
        const auto exact = static_cast<float>(tie);
        ASSERT_EQ(double(exact), tie) << "a float holds every tie";
        const std::uint16_t even = (below & 1) == 0 ? below : above;
        ASSERT_EQ(to_half(exact), even);
        ASSERT_EQ(to_half(-exact), even | 0x8000);
        ASSERT_EQ(to_half(std::nextafter(exact, 0.0f)), below);
        ASSERT_EQ(to_half(std::nextafter(exact, 1e9f)), above);
    }
}

TEST(Half, AMillionFloatsRoundToTheNearest) {
    Random random(71);
    int differing = 0;
    double relative = 0.0;
    const auto check = [&](float value) {
        const double rounded = from_half(to_half(value));
        differing += !same(rounded, std::isnan(value) ? 0.0 : nearest(value));
        if (const double size = std::abs(double(value)); size >= 0x1p-14 && size <= 65504.0)
            relative = std::max(relative, std::abs(rounded - double(value)) / size);
    };
    for (int n = 0; n < 500'000; ++n) {
        check(std::bit_cast<float>(random.bits()));                             // any bits: denormals, infinities, NaN
        check(static_cast<float>(random.spread(1e-9, 2e5)) * (n % 2 ? 1 : -1)); // the range of halves and around it
    }
    for (const float value :
         {0.0f, -0.0f, 65504.0f, 65519.996f, 65520.0f, 1e30f, -1e30f, 0x1p-24f, 0x1p-25f, -0x1.8p-25f, 0x1.ffffp-15f,
          std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN(),
          -std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::denorm_min(), std::numeric_limits<float>::max()})
        check(value);
    WINDROW_EXPECT_FIGURE("half_not_nearest", double(differing), 0.0);
    WINDROW_EXPECT_FIGURE("half_relative_error", relative, 0x1p-11);
}

} // namespace
