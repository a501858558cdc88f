#include "fluid/track.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace windrow {
namespace {

// Whether a segment that ends at `end` after `duration` keeps the velocity of the one before it, up to rounding of positions.
bool goes_on(const Track::Segment& before, glm::dvec3 end, double duration) {
    const double share = before.duration / (before.duration + duration);
    const glm::dvec3 bend = before.end - (before.start + share * (end - before.start));
    return glm::length(bend) <= 1e-6 * glm::length(end - before.start);
}

} // namespace

std::span<const Track::Segment> Track::tick(double duration) {
    std::size_t pieces = 0;
    const double half = 0.5 * duration;
    bool passed_middle = false;
    // A segment with the velocity of the last one extends it: uniform motion gives one segment a tick at any frame rate.
    path_.tick(duration, [&](double time, double end_time, glm::dvec3 place, glm::dvec3 end) {
        const double length = end_time - time;
        if (!passed_middle && end_time >= half) {
            passed_middle = true;
            middle_ = length > 0.0 ? place + (half - time) / length * (end - place) : end;
        }
        if (end == place || !(length > 0.0))
            return;
        if (pieces > 0 && segments_[pieces - 1].end == place && goes_on(segments_[pieces - 1], end, length)) {
            segments_[pieces - 1].end = end;
            segments_[pieces - 1].duration += length;
        } else if (pieces < segments_.size()) {
            segments_[pieces++] = {place, end, length};
        }
    });
    if (!passed_middle)
        middle_ = path_.here(); // at rest
    if (pieces == 1 && std::abs(segments_[0].duration - duration) <= TimedPath<glm::dvec3>::k_rounding * duration)
        segments_[0].duration = duration;
    return {segments_.data(), pieces};
}

void Track::shift(glm::dvec3 offset) {
    path_.visit_places([&](glm::dvec3& place) { place += offset; });
    for (Segment& segment : segments_) {
        segment.start += offset;
        segment.end += offset;
    }
    middle_ += offset;
}

} // namespace windrow
