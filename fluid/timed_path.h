// Places of a moving thing between two ticks, as the host gave them frame by frame.
//
// A place is valid at the end of the frame in which it was given; several in one frame are spread evenly over it. A tick takes
// the places up to its own time, so a uniform motion makes the same path at 30 and at 144 Hz.
#pragma once

#include "api.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <limits>

namespace windrow {

/// Where a body is and how it is turned.
struct BodyPose {
    glm::dvec3 position{0.0};                          ///< [m]
    glm::dquat orientation = glm::dquat(1.0, 0, 0, 0); ///< of length 1
    friend bool operator==(const BodyPose&, const BodyPose&) = default;
};

namespace detail {

/// A place of the way between two.
[[nodiscard]] inline glm::dvec3 between(glm::dvec3 from, glm::dvec3 to, double share) {
    return from + share * (to - from);
}
[[nodiscard]] BodyPose between(const BodyPose& from, const BodyPose& to, double share);
/// [rad] Rotation vector from one orientation to another, the shorter way.
[[nodiscard]] WINDROW_API glm::dvec3 turn_between(const glm::dquat& from, const glm::dquat& to);

/// Whether a way [m] in a time [s] is no motion, but a new place. `fastest` [m/s]; 0: never.
[[nodiscard]] inline bool is_jump(glm::dvec3 way, double duration, float fastest) {
    return fastest > 0.0f && glm::length(way) > static_cast<double>(fastest) * duration;
}

/// [m^2] Square of the distance of a place from the straight line between the ones before and after it.
[[nodiscard]] inline double bend(glm::dvec3 before, glm::dvec3 place, glm::dvec3 after) {
    const glm::dvec3 along = after - before, from = place - before;
    const double squared = glm::dot(along, along);
    const glm::dvec3 apart = from - (squared > 0.0 ? std::clamp(glm::dot(from, along) / squared, 0.0, 1.0) : 0.0) * along;
    return glm::dot(apart, apart);
}
/// A radian counts as a metre.
[[nodiscard]] double bend(const BodyPose& before, const BodyPose& place, const BodyPose& after);

} // namespace detail

/// `Place`: glm::dvec3 or BodyPose.
template <class Place>
class TimedPath {
  public:
    /// More places between two ticks are thinned, those nearest to the straight line first.
    static constexpr int k_max_points = 8;
    static constexpr double k_rounding = 1e-9; ///< of a tick: sums of frame times equal tick times up to rounding

    TimedPath() = default;
    explicit TimedPath(const Place& place) : here_(place), target_(place) {}

    /// Notes where it is at the end of the coming frame.
    void move_to(const Place& place) {
        target_ = place;
        push({static_cast<double>(++moves_), place});
    }

    /// A frame of `duration` [s] begins `lead` [s] after the last tick: places noted since the last frame get their times.
    void begin_frame(double lead, double duration) {
        if (count_ == timed_)
            return;
        // It was at rest until this frame began.
        const double last = timed_ > 0 ? at(timed_ - 1).time : 0.0;
        if (last < lead - k_rounding * duration && count_ < k_max_points) {
            const Place resting = timed_ > 0 ? at(timed_ - 1).place : here_;
            std::copy_backward(points_.begin() + timed_, points_.begin() + count_, points_.begin() + count_ + 1);
            at(timed_++) = {lead, resting};
            ++count_;
        }
        for (int n = timed_; n < count_; ++n)
            at(n).time = lead + duration * at(n).time / static_cast<double>(moves_);
        timed_ = count_;
        moves_ = 0;
    }

    /// Scales the times of all places noted so far by `factor`.
    void squeeze(double factor) {
        for (int n = 0; n < timed_; ++n)
            at(n).time *= factor;
    }

    /// Advances by a tick of `duration` [s]. Calls visit(start [s], end [s], from, to) for each straight line of the way in it.
    template <class Visit>
    void tick(double duration, const Visit& visit) {
        int taken = 0;
        double time = 0.0;
        Place place = here_;
        const auto go_on = [&](double end_time, const Place& end) {
            if (std::abs(end_time - duration) <= k_rounding * duration)
                end_time = duration;
            visit(time, end_time, place, end);
            place = end;
            time = end_time;
        };
        while (taken < timed_ && at(taken).time <= duration * (1.0 + k_rounding)) {
            go_on(at(taken).time, at(taken).place);
            ++taken;
        }
        if (taken < timed_ && time < duration)
            go_on(duration, detail::between(place, at(taken).place, (duration - time) / (at(taken).time - time)));
        std::copy(points_.begin() + taken, points_.begin() + count_, points_.begin());
        count_ -= taken;
        timed_ -= taken;
        for (int n = 0; n < timed_; ++n)
            at(n).time -= duration;
        here_ = place;
    }

    /// Calls visit(place) for each place that it holds, to change it.
    template <class Visit>
    void visit_places(const Visit& visit) {
        visit(here_);
        visit(target_);
        for (int n = 0; n < count_; ++n)
            visit(at(n).place);
    }

    /// Where it was at the last tick.
    [[nodiscard]] const Place& here() const { return here_; }
    /// The last place that was noted.
    [[nodiscard]] const Place& target() const { return target_; }
    /// No place is left to go to.
    [[nodiscard]] bool ended() const { return count_ == 0; }

  private:
    friend struct PathFields; // obstacle_record.h: bytes and back

    struct Point {
        double time = 0.0; ///< [s] after the last tick; from `timed_` on, which of the frame's moves it was
        Place place{};
    };

    [[nodiscard]] Point& at(int n) { return points_[static_cast<std::size_t>(n)]; }

    // A full path drops the point whose removal changes it least. The newest point is the target and is kept.
    void push(const Point& point) {
        if (count_ == k_max_points) {
            int spare = 0;
            double least = std::numeric_limits<double>::infinity();
            for (int n = 0; n < count_; ++n) {
                const Place& before = n > 0 ? at(n - 1).place : here_;
                const Place& after = n + 1 < count_ ? at(n + 1).place : point.place;
                if (const double size = detail::bend(before, at(n).place, after); size < least) {
                    least = size;
                    spare = n;
                }
            }
            std::copy(points_.begin() + spare + 1, points_.end(), points_.begin() + spare);
            timed_ -= spare < timed_ ? 1 : 0;
            --count_;
        }
        at(count_++) = point;
    }

    Place here_{};
    Place target_{};
    std::array<Point, k_max_points> points_{};
    int count_ = 0;
    int timed_ = 0; ///< points that have a time
    int moves_ = 0; ///< since the last frame began
};

} // namespace windrow
