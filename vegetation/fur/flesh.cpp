#include "vegetation/fur/flesh.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace windrow::vegetation::fur {
namespace {

double distance(const Capsule& capsule, const glm::dvec3& p) {
    const glm::dvec3 a(capsule.a), along = glm::dvec3(capsule.b) - a;
    const double square = glm::dot(along, along);
    const double t = square > 0.0 ? std::clamp(glm::dot(p - a, along) / square, 0.0, 1.0) : 0.0;
    const double ra = static_cast<double>(capsule.radius_a), rb = static_cast<double>(capsule.radius_b);
    return glm::length(p - a - t * along) - (ra + t * (rb - ra));
}

} // namespace

double distance(const Flesh& flesh, const glm::dvec3& p) {
    double whole = std::numeric_limits<double>::max();
    for (const Capsule& capsule : flesh) {
        const double one = distance(capsule, p), k = static_cast<double>(capsule.melt);
        const double h = std::max(1.0 - std::abs(whole - one) / k, 0.0);
        whole = std::min(whole, one) - 0.25 * h * h * k;
    }
    return whole;
}

glm::dvec3 slope(const Flesh& flesh, const glm::dvec3& p) {
    constexpr double k_step = 1e-5;
    glm::dvec3 result;
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 step(0.0);
        step[axis] = k_step;
        result[axis] = (distance(flesh, p + step) - distance(flesh, p - step)) / (2.0 * k_step);
    }
    return result;
}

} // namespace windrow::vegetation::fur
