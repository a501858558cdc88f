#include "scene/frame_times.h"

#include <algorithm>
#include <cmath>

namespace windrow::scene {
namespace {

// What rounding may change of a count, so that 0.3 s at 10 frames a second make 4 frames although 0.3 * 10 is below 3.
double slack(double count) {
    return 1e-12 * count + 1e-9;
}

// The fewest parts of a time of so many ticks.
std::int64_t parts(double ticks) {
    return std::max<std::int64_t>(1, static_cast<std::int64_t>(std::ceil(ticks - slack(ticks))));
}

} // namespace

FrameTimes::FrameTimes(double from, double frames_per_second, double tick_hz)
    : from_(from), frames_per_second_(frames_per_second), steps_a_frame_(parts(tick_hz / frames_per_second)),
      step_hz_(static_cast<double>(steps_a_frame_) * frames_per_second) {
    const double frames = from * frames_per_second, whole = std::round(frames);
    if (std::abs(frames - whole) <= slack(frames))
        first_step_ = static_cast<std::int64_t>(whole) * steps_a_frame_;
    else
        first_step_ = lead_steps_ = parts(from * tick_hz);
}

std::int64_t FrameTimes::frames_until(double until) const {
    const double frames = (until - from_) * frames_per_second_;
    return std::max<std::int64_t>(0, static_cast<std::int64_t>(std::floor(frames + slack(until * frames_per_second_))) + 1);
}

double FrameTimes::time_of_step(std::int64_t step) const {
    if (step < lead_steps_)
        return from_ * static_cast<double>(step) / static_cast<double>(lead_steps_);
    return (lead_steps_ > 0 ? from_ : 0.0) + static_cast<double>(step - lead_steps_) / step_hz_;
}

double FrameTimes::length_of_step(std::int64_t step) const {
    return step <= lead_steps_ ? from_ / static_cast<double>(lead_steps_) : 1.0 / step_hz_;
}

} // namespace windrow::scene
