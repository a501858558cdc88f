// Elementary functions from IEEE sums, products, quotients and roots.
//
//   exp    x = k ln 2 + r, |r| <= ln 2 / 2;   2^k sum r^n / n!                       to r^13: 4e-18
//   log    x = 2^k m, m in [sqrt 1/2, sqrt 2), s = (m - 1) / (m + 1);   k ln 2 + 2 atanh s     to s^21: 1e-18
//   sin    x = k pi / 2 + r, |r| <= pi / 4;   sum (-1)^n r^(2n+1) / (2n+1)!          to r^17: 1e-19; cos to r^18
//   atan   tan(a/2) = t / (1 + sqrt(1 + t^2)), twice, then sum (-1)^n t^(2n+1) / (2n+1), t <= tan(pi/16)     to t^23: 1e-18
//
// The figures are the relative errors that the series leave, a hundredth of a double's last digit. The series are Taylor's: no
// coefficient needs a source.
// Based on: Cody & Waite 1980, Software Manual for the Elementary Functions (constants in parts, of which k times the first is
// exact); Tang 1990, Table-driven implementation of the logarithm function, and fdlibm (the logarithm as f - (f^2/2 - ...), which
// keeps the digits near 1).
#include "fluid/portable_math.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

namespace windrow::numerics {
namespace {

constexpr double k_infinity = std::numeric_limits<double>::infinity();
constexpr double k_nan = std::numeric_limits<double>::quiet_NaN();

// ln 2 in two parts, the first of 32 digits in base 2.
constexpr double k_ln2_high = 0x1.62e42feep-1, k_ln2_low = 0x1.a39ef35793c76p-33;
// pi / 2 in three parts of 33, 33 and 53 digits.
constexpr double k_half_pi[3] = {0x1.921fb544p+0, 0x1.0b4611a6p-34, 0x1.3198a2e037073p-69};
constexpr double k_pi = std::numbers::pi;

// Coefficients of the powers of a series; `of` gives the one of x^n.
template <std::size_t count, class Of>
constexpr std::array<double, count> coefficients(const Of& of) {
    std::array<double, count> list{};
    for (std::size_t n = 0; n < count; ++n)
        list[n] = of(static_cast<int>(n));
    return list;
}
constexpr double inverse_factorial(int n) {
    double factorial = 1.0; // exact up to 22!
    for (int m = 2; m <= n; ++m)
        factorial *= m;
    return 1.0 / factorial;
}
constexpr double sign(int n) {
    return n % 2 == 0 ? 1.0 : -1.0;
}
constexpr auto k_exp = coefficients<12>([](int n) { return inverse_factorial(n + 2); });
constexpr auto k_sin = coefficients<8>([](int n) { return -sign(n) * inverse_factorial(2 * n + 3); });
constexpr auto k_cos = coefficients<8>([](int n) { return sign(n) * inverse_factorial(2 * n + 4); });
constexpr auto k_log = coefficients<10>([](int n) { return 2.0 / (2 * n + 3); });
constexpr auto k_atan = coefficients<11>([](int n) { return -sign(n) / (2 * n + 3); });

// The first `terms` of a series: even and odd powers side by side, which takes half the time of one chain.
template <std::size_t terms, std::size_t count>
double sum_of(const std::array<double, count>& list, double x) {
    static_assert(terms <= count);
    const double square = x * x;
    double even = 0.0, odd = 0.0;
    for (std::size_t n = terms; n-- > 0;)
        (n % 2 == 0 ? even : odd) = list[n] + square * (n % 2 == 0 ? even : odd);
    return even + x * odd;
}

// 2^k for k from -1022 to 1023.
double power_of_two(int k) {
    return std::bit_cast<double>(static_cast<std::uint64_t>(k + 1023) << 52);
}

// value 2^k for k from -1100 to 1024, rounded once where the result is subnormal.
double scaled(double value, int k) {
    if (k > 1023)
        return value * power_of_two(1023) * power_of_two(k - 1023);
    if (k < -1021)
        return value * power_of_two(k + 100) * power_of_two(-100);
    return value * power_of_two(k);
}

struct Reduced {
    int k;
    double rest;
};
// For |x| up to 800. A sum with 1.5 2^52 rounds to a whole number, without a call where a machine has no instruction for it.
Reduced by_ln2(double x) {
    constexpr double k_rounding = 0x1.8p52;
    const double k = (x * std::numbers::log2e + k_rounding) - k_rounding;
    return {static_cast<int>(k), (x - k * k_ln2_high) - k * k_ln2_low};
}

// exp(r) - 1 - r
template <std::size_t terms = k_exp.size()>
double beyond_line(double r) {
    return r * r * sum_of<terms>(k_exp, r);
}

// log x of a positive and finite x.
template <std::size_t terms>
double logarithm(double x) {
    constexpr double k_least = std::numeric_limits<double>::min();
    const bool subnormal = x < k_least;
    const auto bits = std::bit_cast<std::uint64_t>(subnormal ? x * 0x1p54 : x);
    // From sqrt(1/2) on: the exponent that the number over it has.
    constexpr std::uint64_t k_digits = (std::uint64_t{1} << 52) - 1, k_first = 0x3fe6a09e667f3bcc;
    const auto k = static_cast<std::int64_t>(bits - k_first) >> 52;
    const double m = std::bit_cast<double>(((bits - k_first) & k_digits) + k_first);
    const double f = m - 1.0, s = f / (2.0 + f), z = s * s;
    const double half_square = 0.5 * f * f, beyond = z * sum_of<terms>(k_log, z);
    const double exponent = static_cast<double>(subnormal ? k - 54 : k);
    return exponent * k_ln2_high - ((half_square - (s * (half_square + beyond) + exponent * k_ln2_low)) - f);
}

struct Turned {
    int quarter;         // 0 to 3
    double rest, behind; // rest + behind, the second below the first's last digit
};
Turned by_quarters(double x) {
    if (!(std::abs(x) < 1e6))
        x = std::fmod(x, 2.0 * k_pi); // exact; NaN for infinity
    if (!(std::abs(x) < 1e7))
        return {0, k_nan, 0.0};
    const double k = std::floor(x * (2.0 / k_pi) + 0.5);
    const double first = x - k * k_half_pi[0], second = k * k_half_pi[1];
    const double rest = first - second;
    const double behind = ((first - rest) - second) - k * k_half_pi[2];
    const double sum = rest + behind;
    return {static_cast<int>(static_cast<std::int64_t>(k) & 3), sum, (rest - sum) + behind};
}

double sine_within(double r, double behind) {
    const double z = r * r;
    return r + (r * z * sum_of<8>(k_sin, z) + behind);
}
double cosine_within(double r, double behind) {
    const double z = r * r;
    const double line = 1.0 - 0.5 * z;
    return line + (((1.0 - line) - 0.5 * z) + (z * z * sum_of<8>(k_cos, z) - r * behind));
}

double sine_of(const Turned& x) {
    switch (x.quarter) {
    case 0:
        return sine_within(x.rest, x.behind);
    case 1:
        return cosine_within(x.rest, x.behind);
    case 2:
        return -sine_within(x.rest, x.behind);
    default:
        return -cosine_within(x.rest, x.behind);
    }
}

// The angle of a place with 0 <= low <= high, high above 0.
double angle_below_diagonal(double low, double high) {
    double t = low / high;
    for (int n = 0; n < 2; ++n)
        t = t / (1.0 + std::sqrt(1.0 + t * t));
    const double z = t * t;
    return 4.0 * (t + t * z * sum_of<11>(k_atan, z));
}

} // namespace

double exp(double x) {
    if (!(x < 709.79))
        return x > 0.0 ? k_infinity : x;
    if (x < -746.0)
        return 0.0;
    const auto [k, r] = by_ln2(x);
    return scaled(1.0 + (r + beyond_line(r)), k);
}

double expm1(double x) {
    if (!(x < 40.0))
        return exp(x);
    if (x < -40.0)
        return -1.0;
    const auto [k, r] = by_ln2(x);
    const double within = r + beyond_line(r);
    if (k == 0)
        return within;
    const double power = power_of_two(k);
    return power * within + (power - 1.0);
}

double log(double x) {
    if (!(x > 0.0))
        return x == 0.0 ? -k_infinity : k_nan;
    if (x == k_infinity)
        return x;
    return logarithm<k_log.size()>(x);
}

// log(u) for the rounded u = 1 + x, and what the rounding lost: Kahan's.
double log1p(double x) {
    const double u = 1.0 + x;
    if (u == 1.0 || u == k_infinity)
        return x;
    return log(u) + (x - (u - 1.0)) / u;
}

double sin(double x) {
    return sine_of(by_quarters(x));
}

double cos(double x) {
    Turned turned = by_quarters(x);
    turned.quarter = (turned.quarter + 1) & 3;
    return sine_of(turned);
}

double atan2(double y, double x) {
    const double up = std::abs(y), along = std::abs(x);
    if (std::isnan(x) || std::isnan(y))
        return k_nan;
    double angle = 0.0;
    if (up == along) // 0 and infinity too
        angle = up == 0.0 ? 0.0 : k_pi / 4.0;
    else
        angle = up < along ? angle_below_diagonal(up, along) : k_pi / 2.0 - angle_below_diagonal(along, up);
    if (std::signbit(x))
        angle = k_pi - angle;
    return std::copysign(angle, y);
}

double acos(double x) {
    return std::abs(x) <= 1.0 ? 2.0 * atan2(std::sqrt(1.0 - x), std::sqrt(1.0 + x)) : k_nan;
}

double power(double base, unsigned exponent) {
    double result = 1.0;
    for (; exponent != 0; exponent >>= 1) {
        if ((exponent & 1) != 0)
            result *= base;
        base *= base;
    }
    return result;
}

int ceil_log2(double x) {
    int k = 0;
    return std::frexp(x, &k) == 0.5 ? k - 1 : k;
}

// In double, with series that end where a float does: exp leaves 7e-12, log 3e-13.
float exp(float x) {
    if (!(x < 89.0f))
        return x > 0.0f ? std::numeric_limits<float>::infinity() : x;
    if (x < -104.0f)
        return 0.0f;
    const auto [k, r] = by_ln2(static_cast<double>(x));
    return static_cast<float>((1.0 + (r + beyond_line<8>(r))) * power_of_two(k));
}

float log(float x) {
    return static_cast<float>(log(static_cast<double>(x)));
}

float log1p(float x) {
    return static_cast<float>(log1p(static_cast<double>(x)));
}

float pow(float x, float y) {
    if (y == 0.0f)
        return 1.0f;
    if (!(x > 0.0f) || x == std::numeric_limits<float>::infinity())
        return static_cast<float>(exp(static_cast<double>(y) * log(static_cast<double>(x))));
    const double exponent = static_cast<double>(y) * logarithm<6>(static_cast<double>(x));
    if (!(std::abs(exponent) < 700.0))
        return static_cast<float>(exp(exponent));
    const auto [k, r] = by_ln2(exponent);
    return static_cast<float>((1.0 + (r + beyond_line<8>(r))) * power_of_two(k));
}

float sin(float x) {
    return static_cast<float>(sin(static_cast<double>(x)));
}

float cos(float x) {
    return static_cast<float>(cos(static_cast<double>(x)));
}

float tanh(float x) {
    const double grown = expm1(2.0 * std::clamp(static_cast<double>(x), -20.0, 20.0));
    return static_cast<float>(grown / (grown + 2.0));
}

float cosh(float x) {
    const double grown = exp(std::abs(static_cast<double>(x)));
    return static_cast<float>(0.5 * (grown + 1.0 / grown));
}

float cbrt(float x) {
    return x > 0.0f ? static_cast<float>(exp(log(static_cast<double>(x)) / 3.0)) : 0.0f;
}

} // namespace windrow::numerics
