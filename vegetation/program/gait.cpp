#include "vegetation/program/gait.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace windrow::vegetation::program {

Gait::Gait(const windrow::scene::MotionPath& path) {
    double moving = 0.0;
    for (const windrow::scene::PathPoint& point : path.points()) {
        const glm::dvec2 place(point.position.x, point.position.z);
        const double step = marks_.empty() ? 0.0 : glm::distance(place, marks_.back().place);
        if (step > 1e-9)
            moving += point.time - marks_.back().time;
        marks_.push_back({.time = point.time, .way = (marks_.empty() ? 0.0 : marks_.back().way) + step, .place = place});
    }
    if (marks_.empty())
        marks_.emplace_back();
    if (moving > 0.0)
        speed_ = marks_.back().way / moving;
    stride_ = std::clamp(1.25 * std::pow(speed_, 0.6), 0.5, 6.0);
    const double running = glm::smoothstep(2.0, 2.4, speed_);
    stand_ = std::min(glm::mix(0.62, 0.36, running), 0.95 / stride_);
    ahead_ = glm::mix(0.4, 0.35, running);
}

// The `value` where `key` is `at`, linear between two marks; constant beyond the first and the last.
template <class Value>
Value Gait::between(double at, double Mark::*key, Value Mark::*value) const {
    const auto next =
        std::upper_bound(marks_.begin(), marks_.end(), at, [key](double t, const Mark& mark) { return t < mark.*key; });
    if (next == marks_.begin())
        return marks_.front().*value;
    if (next == marks_.end())
        return marks_.back().*value;
    const Mark& last = *(next - 1);
    return glm::mix(last.*value, (*next).*value, (at - last.*key) / ((*next).*key - last.*key));
}

double Gait::way(double time) const {
    return between(time, &Mark::time, &Mark::way);
}

glm::dvec2 Gait::at(double way) const {
    return between(way, &Mark::way, &Mark::place);
}

double Gait::heading(double way) const {
    const double inside = std::clamp(way, std::min(0.2, 0.5 * marks_.back().way), std::max(marks_.back().way - 0.2, 0.0));
    const glm::dvec2 along = at(inside + 0.2) - at(inside - 0.2);
    return glm::length(along) > 1e-9 ? std::atan2(along.x, along.y) : 0.0;
}

Gait::Foot Gait::foot(int n, double time) const {
    if (!(speed_ > 0.0))
        return {.way = 0.0, .stood = 0.5};
    const double late = 0.5 * n;
    const double cycle = way(time) / stride_ - late, begun = std::floor(cycle), part = cycle - begun;
    const double here = (begun + late + ahead_ * stand_) * stride_;
    if (part < stand_)
        return {.way = here, .stood = part / stand_};
    const double swung = (part - stand_) / (1.0 - stand_);
    return {.way = here + stride_ * glm::smoothstep(0.0, 1.0, swung), .stood = 1.0, .swung = swung, .planted = false};
}

} // namespace windrow::vegetation::program
