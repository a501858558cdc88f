// Path of a moving object between two ticks (timed_path.h), as linear segments in time.
#pragma once

#include "api.h"
#include "timed_path.h"

#include <array>
#include <glm/vec3.hpp>
#include <span>

namespace windrow {

class WINDROW_API Track {
  public:
    /// Maximal number of segments per tick.
    static constexpr int k_max_segments = TimedPath<glm::dvec3>::k_max_points;

    struct Segment {
        glm::dvec3 start, end; ///< [m]
        double duration;       ///< [s] > 0
    };

    Track() = default;
    explicit Track(glm::dvec3 position) : path_(position), middle_(position) {}

    /// Notes where it is at the end of the coming frame.
    void move_to(glm::dvec3 position) { path_.move_to(position); }
    /// A frame of `duration` [s] begins `lead` [s] after the last tick: positions noted since the last frame get their times.
    void begin_frame(double lead, double duration) { path_.begin_frame(lead, duration); }
    /// Scales the times of all positions noted so far by `factor`.
    void squeeze(double factor) { path_.squeeze(factor); }
    /// Advances by a tick of `duration` [s] and returns the segments in it, none if the object did not move. They are valid
    /// until the next call.
    std::span<const Segment> tick(double duration);

    /// The world's origin has moved: every place moves by `offset` [m].
    void shift(glm::dvec3 offset);

    /// [m] Where it was at the last tick.
    [[nodiscard]] glm::dvec3 here() const { return path_.here(); }
    /// [m] Position at the middle of the last tick. A motor there is of second order in time.
    [[nodiscard]] glm::dvec3 middle() const { return middle_; }
    /// [m] The last position that was noted.
    [[nodiscard]] glm::dvec3 target() const { return path_.target(); }

  private:
    friend struct PathFields; // obstacle_record.h: bytes and back

    TimedPath<glm::dvec3> path_;
    std::array<Segment, k_max_segments> segments_{}; ///< as is what follows, of the last tick
    glm::dvec3 middle_{0.0};
};

} // namespace windrow
