// Exact step of any length of a row of stages, each following the one before it:
//
//   y_i' = lambda (y_(i-1) - y_i),  i = 1 .. n,     y_0 = g(t), the body, linear from `before` to `now` over the step h
//
// With z = lambda h, p_j = e^-z z^j / j! (Poisson weights) and P(i, z) = 1 - p_0 - .. - p_(i-1) (the regularised incomplete gamma
// function), as what a stage grows by, so that a row at rest stays at rest to the bit and a short step in float keeps its digits:
//
//   y_i  +=  sum_(0 < j < i) p_j (y_(i-j) - y_i)  +  P(i, z) (now - y_i)  +  c_i (before - now),     c_i = i P(i+1, z) / z
//
// The factor 1 - e^-z of each stage alone, stage after stage, is not this: it depends on the order and on the frame rate.
// Based on: the Erlang distribution as the delay of a row of equal exponential stages (Erlang 1917); DLMF 8.2, 8.4, 8.8.
#pragma once

#include "../fluid/api.h"
#include "../fluid/parallel.h"
#include "../fluid/result.h"

#include <cstddef>
#include <span>
#include <vector>

namespace windrow {

/// The coefficients of a step, the same for all rows with one rate and number of stages. Made once a frame; `set` does not
/// allocate.
class WINDROW_API CascadeStep {
  public:
    /// For `stages` of 1 to 4096; no time has passed. Rejects others.
    [[nodiscard]] static Result<CascadeStep> create(int stages);
    /// A step of `duration` [s], 0 or more, at `rate` [1/s] above 0. Rejects other values.
    Result<void> set(double rate, double duration);

    [[nodiscard]] int stages() const { return static_cast<int>(body_before_.size()); }
    /// p_0 .. p_(n-1), without those at the end that are below a double's last digit.
    [[nodiscard]] std::span<const double> weights() const { return {weights_.data() + first_, count_}; }
    /// The j of the first of them: after a long step the early ones have vanished.
    [[nodiscard]] std::size_t first() const { return first_; }
    /// P(1, z) .. P(n, z).
    [[nodiscard]] std::span<const double> body_now() const { return body_now_; }
    /// c_1 .. c_n.
    [[nodiscard]] std::span<const double> body_before() const { return body_before_; }

  private:
    std::vector<double> weights_;
    std::vector<double> body_now_, body_before_;
    std::size_t first_ = 0, count_ = 1;
};

/// Rows side by side; a vector's components are rows of their own.
template <class Real>
struct CascadeBatch {
    std::span<Real> value;             ///< value[(i - 1) * rows + k] is stage i of row k, from the body's side out
    std::span<const Real> body_before; ///< of each row, at the start of the step
    std::span<const Real> body_now;    ///< at its end
    std::span<Real> remainder{};       ///< as `value`: what rounding took, given back in the next step; 0 at first. Empty: none
};

/// Advances all rows by one step, in place, `Real` float or double; any number of threads gives the same bits. What falls below
/// 1e-20 is 0. Rejects arrays whose lengths do not fit. In float a stage that is closer to the one before it than rounding over z
/// stays there: some 1e-5 of its size at 1000 Hz. With remainders, or in double, it does not.
template <class Real>
Result<void> advance_cascades(const CascadeStep& step, const CascadeBatch<Real>& batch, ParallelFor parallel_for = {});

extern template Result<void> advance_cascades<float>(const CascadeStep&, const CascadeBatch<float>&, ParallelFor);
extern template Result<void> advance_cascades<double>(const CascadeStep&, const CascadeBatch<double>&, ParallelFor);

} // namespace windrow
