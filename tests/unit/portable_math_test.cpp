// Functions of fluid/portable_math.h against those of long double, in units of the last place. Where long double is double (ARM by
// some compilers, not ours) nothing is compared.
//
// Bounds: each operation rounds by half a unit of a number near 1, and a unit of a result may be half of that.
#include "fluid/portable_math.h"
#include "tests/fields.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace {

namespace own = windrow::numerics;
using windrow::test::Random;
using Wide = long double;

constexpr double k_not_a_number = std::numeric_limits<double>::quiet_NaN(), k_endless = std::numeric_limits<double>::infinity();

template <class Real>
double units_off(Real found, Wide truth) {
    const Real nearest = std::abs(static_cast<Real>(truth));
    const Wide unit =
        static_cast<Wide>(std::nextafter(nearest, std::numeric_limits<Real>::infinity())) - static_cast<Wide>(nearest);
    return static_cast<double>(std::abs(static_cast<Wide>(found) - truth) / unit);
}

// The worst of many places between two, evenly spread or by their logarithm.
enum class Spread { even, by_size };
template <class Real, class Own, class Truth>
double worst(Real low, Real high, Spread spread, const Own& own_one, const Truth& truth) {
    Random random(5);
    double most = 0.0;
    for (int n = 0; n < 20000; ++n) {
        const double share = random.real(0.0, 1.0);
        const double wide = spread == Spread::even ? double(low) + share * (double(high) - double(low))
                                                   : double(low) * std::pow(double(high) / double(low), share);
        const Real x = static_cast<Real>(wide);
        most = std::max(most, units_off<Real>(own_one(x), truth(static_cast<Wide>(x))));
    }
    return most;
}

#define WINDROW_WORST(Real, name, low, high, spread)                                                                             \
    worst<Real>(                                                                                                                 \
        low, high, spread, [](Real x) { return own::name(x); }, [](Wide x) { return std::name(x); })

TEST(PortableMath, OfDoubleIsWithinFourUnits) {
    EXPECT_LE(WINDROW_WORST(double, exp, -700.0, 700.0, Spread::even), 4.0);
    EXPECT_LE(WINDROW_WORST(double, exp, 1e-12, 1.0, Spread::by_size), 4.0);
    EXPECT_LE(WINDROW_WORST(double, expm1, -40.0, 40.0, Spread::even), 4.0);
    EXPECT_LE(WINDROW_WORST(double, expm1, 1e-12, 1.0, Spread::by_size), 4.0);
    EXPECT_LE(WINDROW_WORST(double, log, 1e-140, 1e140, Spread::by_size), 4.0);
    EXPECT_LE(WINDROW_WORST(double, log, 0.5, 2.0, Spread::even), 4.0);
    EXPECT_LE(WINDROW_WORST(double, log1p, 1e-12, 1e6, Spread::by_size), 4.0);
    EXPECT_LE(WINDROW_WORST(double, log1p, -0.99, 0.99, Spread::even), 4.0);
    EXPECT_LE(WINDROW_WORST(double, sin, -20.0, 20.0, Spread::even), 4.0);
    EXPECT_LE(WINDROW_WORST(double, cos, -1e6, 1e6, Spread::even), 4.0);
}

// Some more operations than the others: two half angles, two roots.
TEST(PortableMath, AnglesAreWithinEightUnits) {
    EXPECT_LE(WINDROW_WORST(double, acos, -1.0, 1.0, Spread::even), 8.0);
    EXPECT_LE(WINDROW_WORST(double, acos, 0.9999, 1.0, Spread::even), 8.0);
    Random random(6);
    for (int n = 0; n < 20000; ++n) {
        const double y = random.real(-1.0, 1.0) * std::exp2(random.real(-30.0, 30.0)), x = random.real(-1.0, 1.0);
        EXPECT_LE(units_off(own::atan2(y, x), std::atan2(Wide(y), Wide(x))), 8.0) << y << ' ' << x;
    }
    for (const double y : {0.0, -0.0, 1.0, -1.0, k_endless, -k_endless})
        for (const double x : {0.0, -0.0, 1.0, -1.0, k_endless, -k_endless}) {
            EXPECT_NEAR(own::atan2(y, x), std::atan2(y, x), 1e-15) << y << ' ' << x;
            EXPECT_EQ(std::signbit(own::atan2(y, x)), std::signbit(y));
        }
}

TEST(PortableMath, OfFloatIsTheNearestFloat) {
    constexpr double k_most = 0.501;
    EXPECT_LE(WINDROW_WORST(float, exp, -80.0f, 80.0f, Spread::even), k_most);
    EXPECT_LE(WINDROW_WORST(float, exp, 1e-6f, 1.0f, Spread::by_size), k_most);
    EXPECT_LE(WINDROW_WORST(float, log, 1e-30f, 1e30f, Spread::by_size), k_most);
    EXPECT_LE(WINDROW_WORST(float, log1p, 1e-8f, 1e8f, Spread::by_size), k_most);
    EXPECT_LE(WINDROW_WORST(float, sin, -100.0f, 100.0f, Spread::even), k_most);
    EXPECT_LE(WINDROW_WORST(float, cos, -100.0f, 100.0f, Spread::even), k_most);
    EXPECT_LE(WINDROW_WORST(float, tanh, -20.0f, 20.0f, Spread::even), k_most);
    EXPECT_LE(WINDROW_WORST(float, tanh, 1e-6f, 1.0f, Spread::by_size), k_most);
    EXPECT_LE(WINDROW_WORST(float, cosh, -20.0f, 20.0f, Spread::even), k_most);
    EXPECT_LE(WINDROW_WORST(float, cbrt, 1.0f, 1e7f, Spread::by_size), k_most);
    for (const float power : {-1.5f, -0.25f, 0.5f, 1.0f, 2.3f})
        EXPECT_LE(worst<float>(
                      1e-12f, 1e12f, Spread::by_size, [&](float x) { return own::pow(x, power); },
                      [&](Wide x) { return std::pow(x, Wide(power)); }),
                  k_most)
            << power;
}

TEST(PortableMath, EndsAreAsInIeee) {
    EXPECT_EQ(own::exp(710.0), k_endless);
    EXPECT_EQ(own::exp(-750.0), 0.0);
    EXPECT_EQ(own::exp(0.0), 1.0);
    EXPECT_EQ(own::exp(-745.0), std::exp(-745.0)); // the least number
    EXPECT_EQ(own::exp(89.0f), std::numeric_limits<float>::infinity());
    EXPECT_EQ(own::exp(-200.0f), 0.0f);
    EXPECT_EQ(own::expm1(0.0), 0.0);
    EXPECT_EQ(own::expm1(-50.0), -1.0);
    EXPECT_EQ(own::log(0.0), -k_endless);
    EXPECT_EQ(own::log(k_endless), k_endless);
    EXPECT_NEAR(own::log(5e-324), -744.4400719213812, 1e-12);
    EXPECT_EQ(own::pow(0.0f, 0.5f), 0.0f);
    EXPECT_EQ(own::pow(0.0f, 0.0f), 1.0f);
    EXPECT_EQ(own::pow(1e30f, 2.0f), std::numeric_limits<float>::infinity());
    EXPECT_EQ(own::acos(1.0), 0.0);
    EXPECT_EQ(own::cbrt(0.0f), 0.0f);
    for (const double none :
         {own::exp(k_not_a_number), own::log(-1.0), own::log(k_not_a_number), own::sin(k_endless), own::cos(k_not_a_number),
          own::acos(1.1), own::atan2(k_not_a_number, 1.0), own::expm1(k_not_a_number), own::log1p(k_not_a_number)})
        EXPECT_TRUE(std::isnan(none));
}

TEST(PortableMath, PowersAreExactWhereTheyFit) {
    EXPECT_EQ(own::power(3.0, 0), 1.0);
    EXPECT_EQ(own::power(3.0, 5), 243.0);
    EXPECT_EQ(own::power(-2.0, 31), -0x1p31);
    EXPECT_LE(units_off(own::power(1.1, 127), std::pow(Wide(1.1), Wide(127))), 127.0);
    for (int k = -30; k <= 30; ++k) {
        EXPECT_EQ(own::ceil_log2(std::ldexp(1.0, k)), k);
        EXPECT_EQ(own::ceil_log2(std::nextafter(std::ldexp(1.0, k), 1e300)), k + 1);
    }
}

} // namespace
