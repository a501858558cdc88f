// Elementary functions with the same bits on every machine, for everything that reaches the state of a wind or a plant.
//
// The functions of a C library differ between systems by a last digit. Those of glibc differ between processors too: it takes a
// fused multiply-add where there is one. These here are sums, products, quotients and roots of doubles, which IEEE arithmetic
// rounds alike everywhere, in one order, and each rounds by itself (-ffp-contract=off).
//
// Functions of double are within 4 units in the last place, angles within 8. Functions of float round the result of a double:
// within .501 units. Where they are declared they take the place of glm's in the text of shaders/numerics.
#pragma once

namespace windrow::numerics {

[[nodiscard]] double exp(double x);
[[nodiscard]] double expm1(double x);
/// -infinity at 0, NaN below.
[[nodiscard]] double log(double x);
/// Of x above -1.
[[nodiscard]] double log1p(double x);
/// Of an angle [rad]. Beyond 1e6 it is reduced by the double nearest to 2 pi first: the error is then 1e-16 of the angle.
[[nodiscard]] double sin(double x);
[[nodiscard]] double cos(double x);
[[nodiscard]] double atan2(double y, double x);
/// NaN outside of -1 to 1.
[[nodiscard]] double acos(double x);
/// A power by squaring: within `exponent` units in the last place.
[[nodiscard]] double power(double base, unsigned exponent);
/// Smallest whole n with 2^n >= x; `x` is positive and finite. Exact.
[[nodiscard]] int ceil_log2(double x);

[[nodiscard]] float exp(float x);
[[nodiscard]] float log(float x);
[[nodiscard]] float log1p(float x);
/// x^y for x >= 0; 1 where y is 0.
[[nodiscard]] float pow(float x, float y);
[[nodiscard]] float sin(float x);
[[nodiscard]] float cos(float x);
[[nodiscard]] float tanh(float x);
[[nodiscard]] float cosh(float x);
/// Of x >= 0.
[[nodiscard]] float cbrt(float x);

} // namespace windrow::numerics
