// Path of a moving object between two ticks: the positions that the host gave frame by frame, as linear segments in time.
//
// A position is valid at the end of the frame in which it was given; several in one frame are spread evenly over it. A tick
// takes the segments up to its own time, so a uniform motion makes the same path at 30 and at 144 Hz.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <span>

namespace windrow {

class Track {
  public:
    /// Maximal number of segments per tick. More positions are thinned, those nearest to the straight line first.
    static constexpr int k_max_segments = 8;

    struct Segment {
        glm::dvec3 start, end; ///< [m]
        double duration;       ///< [s] > 0
    };

    Track() = default;
    explicit Track(glm::dvec3 position) : here_(position), target_(position), middle_(position) {}

    /// Notes where it is at the end of the coming frame.
    void move_to(glm::dvec3 position);
    /// A frame of `duration` [s] begins `lead` [s] after the last tick: positions noted since the last frame get their times.
    void begin_frame(double lead, double duration);
    /// Scales the times of all positions noted so far by `factor`.
    void squeeze(double factor);
    /// Advances by a tick of `duration` [s] and returns the segments in it, none if the object did not move. They are valid
    /// until the next call.
    std::span<const Segment> tick(double duration);

    /// [m] Where it was at the last tick.
    [[nodiscard]] glm::dvec3 here() const { return here_; }
    /// [m] Position at the middle of the last tick. A motor there is of second order in time.
    [[nodiscard]] glm::dvec3 middle() const { return middle_; }
    /// [m] The last position that was noted.
    [[nodiscard]] glm::dvec3 target() const { return target_; }

  private:
    friend struct StateFields; // snapshot.cpp: bytes and back

    struct Point {
        double time; ///< [s] after the last tick; from `timed_` on, which of the frame's moves it was
        glm::dvec3 position;
    };

    void push(Point point);

    glm::dvec3 here_{0.0};
    glm::dvec3 target_{0.0};
    std::array<Point, k_max_segments> points_{};
    int count_ = 0;
    int timed_ = 0;                                  ///< points that have a time
    int moves_ = 0;                                  ///< since the last frame began
    std::array<Segment, k_max_segments> segments_{}; ///< as is what follows, of the last tick
    glm::dvec3 middle_{0.0};
};

} // namespace windrow
