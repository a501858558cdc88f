#include "coupling/spring.h"

#include "fluid/core/validation.h"
#include "fluid/portable_math.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace windrow {
namespace {

// Terms of a step: the unit responses and their differences from rest.
struct Responses {
    double gone = 0.0;         ///< 1 - A
    double speed = 0.0;        ///< B
    double mean_gone = 0.0;    ///< 1 + E, the mean of 1 - A over the step
    double speed_change = 0.0; ///< D - 1
};

// Short steps by the Taylor series of B at 0, with derivatives B'' = -2a B' - omega^2 B. Each sum keeps all its digits; the
// closed forms lose them to cancellation. (2a + omega) t <= 1/2, so a term is less than half of the one before it.
Responses short_step(double omega, double a, double t) {
    Responses sums;
    double earlier = 0.0, derivative = 1.0; // B^(n-1) and B^(n) at 0, n from 1
    double power = t;                       // t^n / n!
    for (int n = 1; n < 40; ++n) {
        sums.speed += power * derivative;
        sums.gone += omega * omega * power * t / (n + 1) * derivative;
        sums.mean_gone += omega * omega * power * t / ((n + 1.0) * (n + 2.0)) * derivative;
        const double next = -2.0 * a * derivative - omega * omega * earlier;
        earlier = derivative;
        derivative = next;
        power *= t / (n + 1);
    }
    sums.speed_change = -sums.gone - 2.0 * a * sums.speed;
    return sums;
}

Responses long_step(double omega, double a, double t) {
    Responses closed;
    if (a < omega) { // underdamped
        const double swing = std::sqrt((omega - a) * (omega + a));
        const double left = numerics::exp(-a * t);
        closed.speed = left * numerics::sin(swing * t) / swing;
        closed.gone = 1.0 - left * numerics::cos(swing * t) - a * closed.speed;
    } else { // overdamped, with the rates slow and fast; their product is omega^2
        const double apart = std::sqrt((a - omega) * (a + omega));
        const double fast = a + apart, slow = omega * omega / fast;
        const double left = numerics::exp(-slow * t);
        closed.speed = apart > 0.0 ? left * -numerics::expm1(-2.0 * apart * t) / (2.0 * apart) : left * t;
        if (apart > 0.1 * a)
            closed.gone = (slow * numerics::expm1(-fast * t) - fast * numerics::expm1(-slow * t)) / (2.0 * apart);
        else // near the limit: no division by a vanishing difference
            closed.gone = 1.0 - 0.5 * left * (1.0 + numerics::exp(-2.0 * apart * t)) - a * closed.speed;
    }
    closed.mean_gone = 1.0 - (closed.speed + 2.0 * a / (omega * omega) * closed.gone) / t;
    closed.speed_change = -closed.gone - 2.0 * a * closed.speed;
    return closed;
}

// Springs per block of a thread, a multiple of any SIMD width.
constexpr std::size_t k_fraction = 16384;

// Flushes negligible values to 0: a spring at rest would end in denormal numbers, a hundred times as slow.
template <class Real>
Real settled(Real value) {
    return std::abs(value) < static_cast<Real>(1e-20) ? Real{0} : value;
}

template <class Real>
struct Numbers {
    Real xx, xv, xg, vx, vv, vg;
};

template <class Real>
void advance_plain(const Numbers<Real>& s, std::size_t count, Real* __restrict place, Real* __restrict velocity,
                   const Real* __restrict before, const Real* __restrict now) {
    for (std::size_t i = 0; i < count; ++i) {
        const Real e = place[i] - before[i], d = now[i] - before[i], v = velocity[i];
        place[i] = settled(place[i] + (s.xx * e + s.xv * v + s.xg * d));
        velocity[i] = settled(v + (s.vx * e + s.vv * v + s.vg * d));
    }
}

// Compensated summation (Kahan 1965): `rest` is the rounding error of the last sum.
template <class Real>
void advance_compensated(const Numbers<Real>& s, std::size_t count, Real* __restrict place, Real* __restrict velocity,
                         const Real* __restrict before, const Real* __restrict now, Real* __restrict place_rest,
                         Real* __restrict velocity_rest) {
    for (std::size_t i = 0; i < count; ++i) {
        const Real e = place[i] - before[i] + place_rest[i], d = now[i] - before[i], v = velocity[i] + velocity_rest[i];
        const Real dx = s.xx * e + s.xv * v + s.xg * d + place_rest[i];
        const Real dv = s.vx * e + s.vv * v + s.vg * d + velocity_rest[i];
        const Real x1 = settled(place[i] + dx), v1 = settled(velocity[i] + dv);
        place_rest[i] = settled(dx - (x1 - place[i]));
        velocity_rest[i] = settled(dv - (v1 - velocity[i]));
        place[i] = x1;
        velocity[i] = v1;
    }
}

} // namespace

Result<void> validate(const SpringClass& spring) {
    return detail::validate_settings(spring, "spring");
}

Result<std::array<SpringClass, 4>> spring_bands(const SpringClass& spring) {
    if (auto valid = validate(spring); !valid)
        return valid.failure();
    constexpr double k_steps[] = {0.77110541270397037, 0.91700404320467121, 1.0905077326652577, 1.2968395546510096};
    std::array<SpringClass, 4> bands;
    for (std::size_t n = 0; n < bands.size(); ++n)
        bands[n] = {std::clamp(k_steps[n] * spring.frequency_hz, 1e-4, 1000.0), spring.damping};
    return bands;
}

Result<SpringStep> spring_step(const SpringClass& spring, double duration) {
    if (auto valid = validate(spring); !valid)
        return valid.failure();
    if (!(duration >= 0.0) || !std::isfinite(duration))
        return Error{detail::message("The duration of a spring's step is ", duration, " s: give 0 or more.")};
    if (duration == 0.0)
        return SpringStep{};
    const double omega = 2.0 * std::numbers::pi * spring.frequency_hz, a = spring.damping * omega;
    const Responses r = (2.0 * a + omega) * duration <= 0.5 ? short_step(omega, a, duration) : long_step(omega, a, duration);
    return SpringStep{.place_place = -r.gone,
                      .place_velocity = r.speed,
                      .place_target = r.mean_gone,
                      .velocity_place = -omega * omega * r.speed,
                      .velocity_velocity = r.speed_change,
                      .velocity_target = r.gone / duration};
}

SpringBlock SpringStep::block() const {
    const auto f = [](double value) { return static_cast<float>(value); };
    SpringBlock block;
    block.place = {f(place_place), f(place_velocity), f(place_target), 0.0f};
    block.velocity = {f(velocity_place), f(velocity_velocity), f(velocity_target), 0.0f};
    return block;
}

namespace {

// A frame of `spring`, whose ripples are filtered as those of its class, of `class_hz`, are.
Result<SwingBlock> filtered_swing_step(const SpringClass& spring, double class_hz, double duration) {
    constexpr double k_part = 1.0 / 60.0, k_most_parts = 8.0; // ripples pass a blade several times a second
    const double parts = std::clamp(std::ceil(duration / k_part - 1e-6), 1.0, k_most_parts);
    const auto step = spring_step(spring, duration / parts);
    if (!step)
        return step.failure();
    constexpr double k_butterworth = 0.70710678118654752; // damping of the flattest filter of two poles
    const double passed_hz = 6.0 / 7.0 * class_hz, shown_hz = duration > 0.0 ? 0.15 / duration : passed_hz;
    const auto filter = spring_step({std::clamp(shown_hz, 1e-4, std::max(passed_hz, 1e-4)), k_butterworth}, duration / parts);
    if (!filter)
        return filter.failure();
    SwingBlock block;
    block.spring = step->block();
    block.smoothing = filter->block();
    block.parts = {static_cast<float>(parts), static_cast<float>(duration / parts), 0.0f, 0.0f};
    return block;
}

} // namespace

Result<SwingBlock> swing_step(const SpringClass& spring, double duration) {
    return filtered_swing_step(spring, spring.frequency_hz, duration);
}

Result<std::array<SwingBlock, 4>> swing_steps(const SpringClass& spring, double duration) {
    const auto bands = spring_bands(spring);
    if (!bands)
        return bands.failure();
    std::array<SwingBlock, 4> blocks;
    for (std::size_t n = 0; n < blocks.size(); ++n) {
        const auto block = filtered_swing_step((*bands)[n], spring.frequency_hz, duration);
        if (!block)
            return block.failure();
        blocks[n] = *block;
    }
    return blocks;
}

Result<void> validate(const FlutterClass& flutter) {
    return detail::validate_settings(flutter, "flutter");
}

Result<FlutterBlock> flutter_step(const FlutterClass& flutter, double time, double duration) {
    if (auto valid = validate(flutter); !valid)
        return valid.failure();
    if (!(duration >= 0.0) || !std::isfinite(duration) || !std::isfinite(time))
        return Error{detail::message("A frame of flutter ends at ", time, " s and has ", duration,
                                     " s: give finite numbers, and a duration of 0 or more.")};
    FlutterBlock block;
    block.motion = {flutter.most, flutter.onset, 0.0f, 0.0f};
    const auto bands = *spring_bands({flutter.frequency_hz, 0.0}); // of a valid frequency
    for (int n = 0; n < 4; ++n) {
        const double hz = bands[static_cast<std::size_t>(n)].frequency_hz;
        const double now = hz * time, before = hz * (time - duration);
        block.now[n] = static_cast<float>(now - std::floor(now));
        block.before[n] = static_cast<float>(before - std::floor(before));
    }
    return block;
}

template <class Real>
Result<void> advance_springs(const SpringStep& step, const SpringBatch<Real>& batch, ParallelFor parallel_for) {
    const std::size_t count = batch.place.size();
    const bool compensated = !batch.place_remainder.empty() || !batch.velocity_remainder.empty();
    const auto fits = [&](const char* name, std::size_t size) -> Result<void> {
        if (size == count)
            return {};
        return Error{
            detail::message("SpringBatch::", name, " holds ", size, " numbers where `place` holds ", count, ": give as many.")};
    };
    if (auto fit = fits("velocity", batch.velocity.size()); !fit)
        return fit;
    if (auto fit = fits("target_before", batch.target_before.size()); !fit)
        return fit;
    if (auto fit = fits("target_now", batch.target_now.size()); !fit)
        return fit;
    if (compensated) {
        if (auto fit = fits("place_remainder", batch.place_remainder.size()); !fit)
            return fit;
        if (auto fit = fits("velocity_remainder", batch.velocity_remainder.size()); !fit)
            return fit;
    }
    if (!batch.place_previous.empty())
        if (auto fit = fits("place_previous", batch.place_previous.size()); !fit)
            return fit;
    const auto r = [](double value) { return static_cast<Real>(value); };
    const Numbers<Real> s{r(step.place_place),    r(step.place_velocity),    r(step.place_target),
                          r(step.velocity_place), r(step.velocity_velocity), r(step.velocity_target)};
    const auto shares = static_cast<int>((count + k_fraction - 1) / k_fraction);
    parallel_for(shares, [&](int share) {
        const std::size_t at = static_cast<std::size_t>(share) * k_fraction, n = std::min(k_fraction, count - at);
        if (!batch.place_previous.empty())
            std::copy_n(&batch.place[at], n, &batch.place_previous[at]);
        if (compensated)
            advance_compensated(s, n, &batch.place[at], &batch.velocity[at], &batch.target_before[at], &batch.target_now[at],
                                &batch.place_remainder[at], &batch.velocity_remainder[at]);
        else
            advance_plain(s, n, &batch.place[at], &batch.velocity[at], &batch.target_before[at], &batch.target_now[at]);
    });
    return {};
}

template Result<void> advance_springs<float>(const SpringStep&, const SpringBatch<float>&, ParallelFor);
template Result<void> advance_springs<double>(const SpringStep&, const SpringBatch<double>&, ParallelFor);

} // namespace windrow
