#include "scene/motion_path.h"

#include <algorithm>

namespace windrow::scene {

glm::dvec3 MotionPath::at(double time) const {
    if (points_.empty())
        return glm::dvec3(0.0);
    const auto next =
        std::upper_bound(points_.begin(), points_.end(), time, [](double t, const PathPoint& point) { return t < point.time; });
    if (next == points_.begin())
        return points_.front().position;
    if (next == points_.end())
        return points_.back().position;
    const PathPoint& before = *(next - 1);
    const double share = (time - before.time) / (next->time - before.time);
    // Written so that equal points give that point to the bit, and a share of 0 the point before.
    return before.position + share * (next->position - before.position);
}

} // namespace windrow::scene
