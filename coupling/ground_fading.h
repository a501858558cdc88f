// Response of a spring to a fading target: the part of the ground's step that a target linear over the step lacks.
//
//   x'' + 2 zeta omega x' + omega^2 (x - f(t)) = 0 from rest,   f = e^(-t / tau) - 1   or   f = t / h (e^(-t / tau) - 1)
//
// over the step h, exactly: x, its velocity, f and t / h obey one linear system with constant coefficients, whose exponential is
// taken by its Taylor series over h / 2^k and k squarings. Based on: Moler & Van Loan 2003, Nineteen dubious ways to compute the
// exponential of a matrix, method 3.
#pragma once

#include "coupling/spring.h"

namespace windrow::detail {

struct FadingResponse {
    double place = 0.0;
    double velocity = 0.0; ///< [1/s]
};

/// For f = e^(-t / time) - 1 over `duration` [s], 0 or more; `time` [s] above 0.
[[nodiscard]] FadingResponse fading_response(const SpringClass& spring, double duration, double time);
/// For f = t / duration (e^(-t / time) - 1).
[[nodiscard]] FadingResponse fading_ramp_response(const SpringClass& spring, double duration, double time);

} // namespace windrow::detail
