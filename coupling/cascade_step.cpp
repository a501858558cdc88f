#include "coupling/cascade_step.h"

#include "fluid/core/message.h"
#include "fluid/portable_math.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace windrow {
namespace {

constexpr int k_max_stages = 4096;
constexpr double k_nothing = 1e-18; // of a weight: the sum of all omitted weights is below a double's last digit

// log j!, of whole j: by Stirling's series from 16 on, whose next term is below 1e-16 there.
double log_factorial(double j) {
    if (j < 16.0) {
        double factorial = 1.0;
        for (double n = 2.0; n <= j; n += 1.0)
            factorial *= n;
        return numerics::log(factorial);
    }
    const double z = j + 1.0, s = 1.0 / (z * z);
    const double series =
        1.0 / 12 - s * (1.0 / 360 - s * (1.0 / 1260 - s * (1.0 / 1680 - s * (1.0 / 1188 - s * (691.0 / 360360)))));
    return (z - 0.5) * numerics::log(z) - z + 0.5 * numerics::log(2.0 * std::numbers::pi) + series / z;
}

// p_j; exponent first, since e^-z alone underflows from z = 745 on.
double poisson(double z, double j) {
    if (z == 0.0)
        return j == 0.0 ? 1.0 : 0.0;
    return numerics::exp(j * numerics::log(z) - z - log_factorial(j));
}

// P(i, z) / p_i = 1 + z / (i+1) + z^2 / ((i+1)(i+2)) + .., all of one sign. For z < i + 1, where it converges fast.
double tail_over_weight(double z, double i) {
    double sum = 1.0, term = 1.0;
    for (double k = i + 1.0; term > 1e-17 * sum; k += 1.0) {
        term *= z / k;
        sum += term;
    }
    return sum;
}

} // namespace

Result<CascadeStep> CascadeStep::create(int stages) {
    if (stages < 1 || stages > k_max_stages)
        return Error{detail::message("A cascade of ", stages, " stages is not possible: give 1 to ", k_max_stages, ".")};
    return detail::where_memory_lasts([&]() -> Result<CascadeStep> {
        CascadeStep step;
        step.weights_.resize(static_cast<std::size_t>(stages));
        step.body_now_.resize(static_cast<std::size_t>(stages));
        step.body_before_.resize(static_cast<std::size_t>(stages));
        step.weights_[0] = 1.0;
        return step;
    });
}

Result<void> CascadeStep::set(double rate, double duration) {
    if (!(rate > 0.0) || !std::isfinite(rate))
        return Error{detail::message("The rate of a cascade is ", rate, " 1/s: give one above 0.")};
    if (!(duration >= 0.0) || !std::isfinite(duration))
        return Error{detail::message("The duration of a cascade's step is ", duration, " s: give 0 or more.")};
    const double given = rate * duration;
    const double z = std::min(given, 1e6); // at 1e6 the weights of 4096 stages are 0 already
    const std::size_t n = weights_.size();
    for (std::size_t j = 0; j < n; ++j)
        weights_[j] = poisson(z, static_cast<double>(j));
    first_ = 0;
    while (first_ + 1 < n && weights_[first_] < k_nothing && weights_[first_ + 1] >= weights_[first_])
        ++first_;
    count_ = n - first_;
    while (count_ > 1 && weights_[first_ + count_ - 1] < k_nothing)
        --count_;
    double below = weights_[0]; // p_0 + .. + p_i
    for (std::size_t i = 1; i <= n; ++i) {
        const auto stage = static_cast<double>(i);
        const double p = i < n ? weights_[i] : poisson(z, stage);
        // P(i, z) and P(i+1, z) as sums of their own where 1 - below would lose digits.
        const bool early = z < stage + 1.0;
        const double later = early ? p * z / (stage + 1.0) * tail_over_weight(z, stage + 1.0) : std::max(1.0 - below - p, 0.0);
        body_now_[i - 1] = early ? p + later : std::max(1.0 - below, 0.0);
        body_before_[i - 1] = given > 0.0 ? stage * later / given : 0.0;
        below += p;
    }
    return {};
}

namespace {

// Flushes negligible values to 0: a row that approaches 0 would end in denormal numbers, a hundred times as slow.
template <class Real>
Real settled(Real value) {
    return std::abs(value) < static_cast<Real>(1e-20) ? Real{0} : value;
}

// Rows of a thread's block: two stages are `stride` rows apart. Without remainders `rest` is null.
template <class Real>
struct Rows {
    Real* value;
    Real* rest;
    const Real* before;
    const Real* now;
    std::size_t stride, count;
};

// Stage after stage from the tip in. Each reads stages further in than itself, which still hold their old values.
template <class Real>
void advance_plain(const CascadeStep& step, const Rows<Real>& rows, Real* __restrict grown) {
    const auto weights = step.weights();
    for (std::size_t i = static_cast<std::size_t>(step.stages()); i >= 1; --i) {
        Real* const at = rows.value + (i - 1) * rows.stride;
        const auto p_now = static_cast<Real>(step.body_now()[i - 1]), c = static_cast<Real>(step.body_before()[i - 1]);
        for (std::size_t k = 0; k < rows.count; ++k)
            grown[k] = p_now * (rows.now[k] - at[k]) + c * (rows.before[k] - rows.now[k]);
        // Stage i takes weights j < i; j = 0 is its own old value.
        for (std::size_t w = step.first() == 0 ? 1 : 0; w < weights.size() && step.first() + w < i; ++w) {
            const auto p = static_cast<Real>(weights[w]);
            const Real* const from = at - (step.first() + w) * rows.stride;
            for (std::size_t k = 0; k < rows.count; ++k)
                grown[k] += p * (from[k] - at[k]);
        }
        for (std::size_t k = 0; k < rows.count; ++k)
            at[k] = settled(at[k] + grown[k]);
    }
}

// Compensated summation (Kahan 1965): the rounding error of each sum is stored beside it.
template <class Real>
void advance_compensated(const CascadeStep& step, const Rows<Real>& rows, Real* __restrict grown) {
    const auto weights = step.weights();
    for (std::size_t i = static_cast<std::size_t>(step.stages()); i >= 1; --i) {
        Real* const at = rows.value + (i - 1) * rows.stride;
        Real* const rest = rows.rest + (i - 1) * rows.stride;
        const auto p_now = static_cast<Real>(step.body_now()[i - 1]), c = static_cast<Real>(step.body_before()[i - 1]);
        for (std::size_t k = 0; k < rows.count; ++k)
            grown[k] = p_now * (rows.now[k] - at[k] - rest[k]) + c * (rows.before[k] - rows.now[k]) + rest[k];
        for (std::size_t w = step.first() == 0 ? 1 : 0; w < weights.size() && step.first() + w < i; ++w) {
            const auto p = static_cast<Real>(weights[w]);
            const std::size_t back = (step.first() + w) * rows.stride;
            for (std::size_t k = 0; k < rows.count; ++k)
                grown[k] += p * ((*(at - back + k) - at[k]) + (*(rest - back + k) - rest[k]));
        }
        for (std::size_t k = 0; k < rows.count; ++k) {
            const Real moved = settled(at[k] + grown[k]);
            rest[k] = settled(grown[k] - (moved - at[k]));
            at[k] = moved;
        }
    }
}

constexpr std::size_t k_block = 256; // rows whose stages stay in a near cache while they are summed; also a thread's block

} // namespace

template <class Real>
Result<void> advance_cascades(const CascadeStep& step, const CascadeBatch<Real>& batch, ParallelFor parallel_for) {
    const std::size_t rows = batch.body_now.size(), n = static_cast<std::size_t>(step.stages());
    if (batch.body_before.size() != rows)
        return Error{detail::message("CascadeBatch::body_before holds ", batch.body_before.size(),
                                     " numbers where body_now holds ", rows, ": give as many.")};
    if (batch.value.size() != n * rows)
        return Error{detail::message("CascadeBatch::value holds ", batch.value.size(), " numbers for ", rows, " rows of ", n,
                                     " stages: give ", n * rows, ".")};
    const bool compensated = !batch.remainder.empty();
    if (compensated && batch.remainder.size() != batch.value.size())
        return Error{detail::message("CascadeBatch::remainder holds ", batch.remainder.size(), " numbers where value holds ",
                                     batch.value.size(), ": give as many, or none.")};
    parallel_for(static_cast<int>((rows + k_block - 1) / k_block), [&](int block) {
        const std::size_t at = static_cast<std::size_t>(block) * k_block;
        const Rows<Real> share{.value = batch.value.data() + at,
                               .rest = compensated ? batch.remainder.data() + at : nullptr,
                               .before = batch.body_before.data() + at,
                               .now = batch.body_now.data() + at,
                               .stride = rows,
                               .count = std::min(k_block, rows - at)};
        Real grown[k_block];
        if (compensated)
            advance_compensated(step, share, grown);
        else
            advance_plain(step, share, grown);
    });
    return {};
}

template Result<void> advance_cascades<float>(const CascadeStep&, const CascadeBatch<float>&, ParallelFor);
template Result<void> advance_cascades<double>(const CascadeStep&, const CascadeBatch<double>&, ParallelFor);

} // namespace windrow
