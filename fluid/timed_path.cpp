#include "fluid/timed_path.h"

#include "fluid/portable_math.h"

namespace windrow::detail {
namespace {

/// [rad] Between two orientations, the shorter way.
double angle(const glm::dquat& a, const glm::dquat& b) {
    return 2.0 * numerics::acos(std::min(1.0, std::abs(glm::dot(a, b))));
}

/// An orientation of the way between two, at constant spin, the shorter way.
glm::dquat turned(const glm::dquat& from, glm::dquat to, double share) {
    double cosine = glm::dot(from, to);
    if (cosine < 0.0) {
        to = -to;
        cosine = -cosine;
    }
    if (cosine > 1.0 - std::numeric_limits<double>::epsilon())
        return from * (1.0 - share) + to * share;
    const double all = numerics::acos(cosine);
    return (from * numerics::sin((1.0 - share) * all) + to * numerics::sin(share * all)) / numerics::sin(all);
}

} // namespace

BodyPose between(const BodyPose& from, const BodyPose& to, double share) {
    return {between(from.position, to.position, share),
            from.orientation == to.orientation ? to.orientation : turned(from.orientation, to.orientation, share)};
}

glm::dvec3 turn_between(const glm::dquat& from, const glm::dquat& to) {
    glm::dquat by = to * glm::conjugate(from);
    if (by.w < 0.0)
        by = -by;
    const glm::dvec3 axis(by.x, by.y, by.z);
    const double sine = glm::length(axis);
    return sine > 0.0 ? 2.0 * numerics::atan2(sine, by.w) / sine * axis : glm::dvec3(0.0);
}

double bend(const BodyPose& before, const BodyPose& place, const BodyPose& after) {
    const double to = angle(before.orientation, place.orientation), from = angle(place.orientation, after.orientation);
    const double share = to + from > 0.0 ? to / (to + from) : 0.0;
    const double turn = angle(place.orientation, turned(before.orientation, after.orientation, share));
    return bend(before.position, place.position, after.position) + turn * turn;
}

} // namespace windrow::detail
