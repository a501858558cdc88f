// Frames in fixed ticks: the air lives at Ticks::hz, the renderer at its own pace.
//
// `lead` is the time of the frame after the last tick, 0 <= lead < one tick. A frame shows
//   u = u_before + lead * hz (u_now - u_before)
// of the last two ticks in the box of today: continuous in time, at most a tick old. What moves (motors, the point that the box
// follows) is told per frame and seen by each tick at its own time (track.h), so the air's states are the same for any frame
// rate.
#include "fluid/wind_host.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <utility>

namespace windrow {
namespace {

// Sums of frame times meet tick times only so nearly; a tick that is due but for rounding is due.
constexpr double k_rounding = 1e-9;     // of a tick
constexpr double k_longest_frame = 1e9; // [s] beyond it nothing is told apart

// Neither gusts, and differing by height alone, over the same ground.
bool same_at_all_times(const AmbientWind& a, const AmbientWind& b) {
    return !a.gusting() && !b.gusting() && a.mean() == b.mean() && a.ground() == b.ground();
}

} // namespace

Advance WindHost::run_ticks(double dt) {
    dt = std::min(dt, k_longest_frame);
    const double duration = 1.0 / config.ticks.hz;
    motors.begin_frame(frames->lead, dt);
    frames->follow.begin_frame(frames->lead, dt);
    frames->lead += dt;

    Advance done;
    const double due = std::floor(frames->lead * config.ticks.hz + k_rounding);
    if (const double spare = due - config.ticks.most; spare > 0.0) {
        done.dropped = spare * duration;
        drop_ticks(done.dropped);
    }
    done.ticks = static_cast<int>(std::min(due, static_cast<double>(config.ticks.most)));
    for (int n = 0; n < done.ticks; ++n)
        tick(duration, done.last);
    frames->lead = std::max(0.0, frames->lead);
    done.factor = static_cast<float>(frames->lead * config.ticks.hz);
    show_frame();
    return done;
}

void WindHost::begin_ticks() {
    const auto frame = [&] { return Frame{{}, window, follow_point, ambient}; };
    frames.emplace(Frames{.before = {}, .shown = frame(), .shown_before = frame(), .follow = Track(follow_point)});
    frames->rim_point_before = follow_point;
    frames->gust_phase_before = ambient.phase();
    try {
        begin_keeping();
    } catch (...) {
        frames.reset();
        throw;
    }
}

// Nothing acts on the air in dropped time, but the world went on: bodies are where they are, gusts have passed.
void WindHost::drop_ticks(double seconds) {
    (void)motors.tick(seconds, window, config.sides);
    (void)frames->follow.tick(seconds);
    if (ambient.gusting() && !asleep) {
        take_ambient_out();
        ambient.advance(seconds);
        put_ambient_in();
    } else {
        ambient.advance(seconds);
        if (ambient.gusting())
            gusts_passed();
    }
    frames->lead -= seconds;
}

void WindHost::tick(double duration, Diagnostics& report) {
    if (!(asleep && frames->before_still))
        keep_before();
    frames->before_still = asleep;
    frames->rim_point_before = follow_point;
    frames->gust_phase_before = ambient.phase();
    (void)frames->follow.tick(duration);
    follow_now(frames->follow.here());
    report = tick_air(duration);
    if (report.repaired_cells > 0)
        hide_broken_cells();
    frames->lead -= duration;
}

void WindHost::show_frame() {
    std::swap(frames->shown, frames->shown_before);
    Frame& frame = frames->shown;
    const auto factor = static_cast<float>(std::min(1.0, frames->lead * config.ticks.hz));
    const bool still = asleep && frames->before_still;
    const bool same = still && frame.still && same_at_all_times(frame.ambient, ambient) &&
                      (ambient.uniform() || frame.window.origin_cells.y == window.origin_cells.y);
    frame.still = still;
    frame.window = window;
    frame.rim_point = glm::mix(frames->rim_point_before, follow_point, static_cast<double>(factor));
    frame.ambient = ambient;
    frame.ambient.set_phase(
        AmbientWind::between(frames->gust_phase_before, ambient.phase(), static_cast<double>(factor), ambient.period()));
    if (!still)
        blend(factor);
    else if (!same)
        show_ambient();
}

} // namespace windrow
