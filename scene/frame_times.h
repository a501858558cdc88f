// Times of the frames of a run, and the steps of the solver that lead to them.
//
// Frame n is at from + n / frames_per_second. Between frames the solver makes the fewest equal steps that are no longer than
// 1 / tick_hz, so that each frame is the air of its own time: neither of the nearest tick nor a blend of two.
//
//     60 Hz, 24 frames a second   3 steps of 1/72 s a frame
//     60 Hz, 48 frames a second   2 steps of 1/96 s
//     60 Hz, 10 frames a second   6 steps of 1/60 s
//
// Where `from` is a whole number of frames, the steps are those of a run from 0: a part of a film has the bits of the whole.
#pragma once

#include <cstdint>

namespace windrow::scene {

class FrameTimes {
  public:
    /// [s] of the first frame, >= 0; [1/s], both > 0.
    FrameTimes(double from, double frames_per_second, double tick_hz);

    /// Frames from the first one to `until` [s], both included; 0 where `until` is before the first.
    [[nodiscard]] std::int64_t frames_until(double until) const;
    /// [s]
    [[nodiscard]] double time_of_frame(std::int64_t frame) const { return time_of_step(step_of_frame(frame)); }
    /// Steps from time 0 to a frame.
    [[nodiscard]] std::int64_t step_of_frame(std::int64_t frame) const { return first_step_ + frame * steps_a_frame_; }
    /// [s] Time after so many steps, rounded once: no sum of rounded steps.
    [[nodiscard]] double time_of_step(std::int64_t step) const;
    /// [s] Length of the step that ends there, >= 1.
    [[nodiscard]] double length_of_step(std::int64_t step) const;
    /// Steps a second between frames.
    [[nodiscard]] double step_hz() const { return step_hz_; }

  private:
    double from_, frames_per_second_;
    std::int64_t steps_a_frame_;
    double step_hz_;
    std::int64_t first_step_ = 0; ///< at `from`
    std::int64_t lead_steps_ = 0; ///< of other length, from 0 to `from`; 0: all are equal
};

} // namespace windrow::scene
