// Elementary functions with the same bits on every machine, for everything that reaches the state of a wind or a plant.
//
// The functions of a C library differ between systems by a last digit. Those of glibc differ between processors too: it takes a
// fused multiply-add where there is one. These here are sums, products, quotients and roots of doubles, which IEEE arithmetic
// rounds alike everywhere, in one order, and each rounds by itself (-ffp-contract=off).
//
// Functions of double are within 4 units in the last place, angles within 8. Functions of float round the result of a double:
// within .501 units. Where they are declared they take the place of glm's in the text of shaders/numerics.
#pragma once

#include "api.h"

namespace windrow::numerics {

[[nodiscard]] WINDROW_API double exp(double x);
[[nodiscard]] WINDROW_API double expm1(double x);
/// -infinity at 0, NaN below.
[[nodiscard]] WINDROW_API double log(double x);
/// Of x above -1.
[[nodiscard]] WINDROW_API double log1p(double x);
/// Of an angle [rad]. Beyond 1e6 it is reduced by the double nearest to 2 pi first: the error is then 1e-16 of the angle.
[[nodiscard]] WINDROW_API double sin(double x);
[[nodiscard]] WINDROW_API double cos(double x);
[[nodiscard]] WINDROW_API double atan2(double y, double x);
/// NaN outside of -1 to 1.
[[nodiscard]] WINDROW_API double acos(double x);
/// A power by squaring: within `exponent` units in the last place.
[[nodiscard]] WINDROW_API double power(double base, unsigned exponent);
/// Smallest whole n with 2^n >= x; `x` is positive and finite. Exact.
[[nodiscard]] WINDROW_API int ceil_log2(double x);

[[nodiscard]] WINDROW_API float exp(float x);
[[nodiscard]] WINDROW_API float log(float x);
[[nodiscard]] WINDROW_API float log1p(float x);
/// x^y for x >= 0; 1 where y is 0.
[[nodiscard]] WINDROW_API float pow(float x, float y);
[[nodiscard]] WINDROW_API float sin(float x);
[[nodiscard]] WINDROW_API float cos(float x);
[[nodiscard]] WINDROW_API float tanh(float x);
[[nodiscard]] WINDROW_API float cosh(float x);
/// Of x >= 0.
[[nodiscard]] WINDROW_API float cbrt(float x);

} // namespace windrow::numerics
