// Surfaces for shells to grow on: points with unit normals.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace windrow::test {

struct SkinPoint {
    glm::vec3 position;
    glm::vec3 normal;
    glm::vec2 share; ///< how far along and around the body, 0 to 1
};

/// [m] Of the body, `a` along it, 0 to 1, at an angle around it.
inline double bumpy_radius(double a, double turn) {
    const double taper = std::sqrt(std::max(1e-4, 1.0 - 0.9 * std::pow(2.0 * a - 1.0, 2.0)));
    return taper * (0.3 + 0.08 * std::sin(9.0 * a) + 0.03 * std::sin(7.0 * turn) * std::sin(30.0 * a));
}

/// A body like an animal's: a tube along x, thick and thin by turns, with bumps all over; 1.6 m long. Normals by differences in
/// double.
inline std::vector<SkinPoint> bumpy_body(int along = 60, int around = 48) {
    const auto at = [](double a, double b) {
        const double x = 1.6 * a - 0.8, turn = 6.283185307179586 * b, radius = bumpy_radius(a, turn);
        return glm::dvec3(x, radius * std::cos(turn), radius * std::sin(turn));
    };
    std::vector<SkinPoint> points;
    for (int i = 0; i < along; ++i)
        for (int j = 0; j < around; ++j) {
            const double a = (i + 0.5) / along, b = (j + 0.5) / around, step = 1e-5;
            const glm::dvec3 da = at(a + step, b) - at(a - step, b), db = at(a, b + step) - at(a, b - step);
            points.push_back({glm::vec3(at(a, b)), glm::vec3(glm::normalize(glm::cross(db, da))), {a, b}});
        }
    return points;
}

/// The body with its front half turned about z by `bend` and about x by `twist` [rad], by blending of two bones along it; the
/// normals are turned with it. Blended normals are the skinning's own, as an engine's are.
inline std::vector<SkinPoint> posed(const std::vector<SkinPoint>& rest, float bend, float twist) {
    std::vector<SkinPoint> points = rest;
    for (SkinPoint& point : points) {
        const float t = std::clamp((point.share.x - 0.35f) / 0.3f, 0.0f, 1.0f), w = t * t * (3.0f - 2.0f * t);
        const auto turned = [&](glm::vec3 v) {
            const glm::vec3 bent{std::cos(bend) * v.x - std::sin(bend) * v.y, std::sin(bend) * v.x + std::cos(bend) * v.y, v.z};
            return glm::vec3{bent.x, std::cos(twist) * bent.y - std::sin(twist) * bent.z,
                             std::sin(twist) * bent.y + std::cos(twist) * bent.z};
        };
        point.position = (1.0f - w) * point.position + w * turned(point.position);
        point.normal = glm::normalize((1.0f - w) * point.normal + w * turned(point.normal));
    }
    return points;
}

} // namespace windrow::test
