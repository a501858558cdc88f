#include "fluid/track.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace windrow {
namespace {

constexpr double k_rounding = 1e-9; // of a tick: sums of frame times equal tick times up to rounding

// Whether a segment that ends at `end` after `duration` keeps the velocity of the one before it, up to rounding of positions.
bool goes_on(const Track::Segment& before, glm::dvec3 end, double duration) {
    const double share = before.duration / (before.duration + duration);
    const glm::dvec3 bend = before.end - (before.start + share * (end - before.start));
    return glm::length(bend) <= 1e-6 * glm::length(end - before.start);
}

} // namespace

void Track::move_to(glm::dvec3 position) {
    target_ = position;
    push({static_cast<double>(++moves_), position});
}

// A full track drops the point whose removal changes the path least. The newest point is the target and is kept.
void Track::push(Point point) {
    if (count_ == k_max_segments) {
        int spare = 0;
        double least = std::numeric_limits<double>::infinity();
        for (int n = 0; n < count_; ++n) {
            const glm::dvec3 before = n > 0 ? points_[n - 1].position : here_;
            const glm::dvec3 after = n + 1 < count_ ? points_[n + 1].position : point.position;
            const glm::dvec3 along = after - before, from = points_[n].position - before;
            const double squared = glm::dot(along, along);
            const glm::dvec3 bend = from - (squared > 0.0 ? std::clamp(glm::dot(from, along) / squared, 0.0, 1.0) : 0.0) * along;
            if (const double size = glm::dot(bend, bend); size < least) {
                least = size;
                spare = n;
            }
        }
        std::copy(points_.begin() + spare + 1, points_.end(), points_.begin() + spare);
        timed_ -= spare < timed_ ? 1 : 0;
        --count_;
    }
    points_[count_++] = point;
}

void Track::begin_frame(double lead, double duration) {
    if (count_ == timed_)
        return;
    // The point was at rest until this frame began.
    const double last = timed_ > 0 ? points_[timed_ - 1].time : 0.0;
    if (last < lead - 1e-9 * duration && count_ < k_max_segments) {
        const glm::dvec3 resting = timed_ > 0 ? points_[timed_ - 1].position : here_;
        std::copy_backward(points_.begin() + timed_, points_.begin() + count_, points_.begin() + count_ + 1);
        points_[timed_++] = {lead, resting};
        ++count_;
    }
    for (int n = timed_; n < count_; ++n)
        points_[n].time = lead + duration * points_[n].time / static_cast<double>(moves_);
    timed_ = count_;
    moves_ = 0;
}

void Track::squeeze(double factor) {
    for (int n = 0; n < timed_; ++n)
        points_[n].time *= factor;
}

std::span<const Track::Segment> Track::tick(double duration) {
    int pieces = 0, taken = 0;
    double time = 0.0;
    glm::dvec3 place = here_;
    const double half = 0.5 * duration;
    bool passed_middle = false;
    // A segment with the velocity of the last one extends it: uniform motion gives one segment a tick at any frame rate.
    const auto add = [&](double end_time, glm::dvec3 end) {
        if (std::abs(end_time - duration) <= k_rounding * duration)
            end_time = duration;
        const double length = end_time - time;
        if (!passed_middle && end_time >= half) {
            passed_middle = true;
            middle_ = length > 0.0 ? place + (half - time) / length * (end - place) : end;
        }
        if (end != place && length > 0.0) {
            if (pieces > 0 && segments_[pieces - 1].end == place && goes_on(segments_[pieces - 1], end, length)) {
                segments_[pieces - 1].end = end;
                segments_[pieces - 1].duration += length;
            } else if (pieces < k_max_segments) {
                segments_[pieces++] = {place, end, length};
            }
        }
        place = end;
        time = end_time;
    };
    while (taken < timed_ && points_[taken].time <= duration * (1.0 + k_rounding)) {
        add(points_[taken].time, points_[taken].position);
        ++taken;
    }
    if (taken < timed_ && time < duration) {
        const Point& next = points_[taken];
        add(duration, place + (duration - time) / (next.time - time) * (next.position - place));
    }
    if (!passed_middle)
        middle_ = place; // at rest
    std::copy(points_.begin() + taken, points_.begin() + count_, points_.begin());
    count_ -= taken;
    timed_ -= taken;
    for (int n = 0; n < timed_; ++n)
        points_[n].time -= duration;
    here_ = place;
    if (pieces == 1 && std::abs(segments_[0].duration - duration) <= k_rounding * duration)
        segments_[0].duration = duration;
    return {segments_.data(), static_cast<std::size_t>(pieces)};
}

} // namespace windrow
