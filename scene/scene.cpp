#include "scene/scene.h"

#include <cmath>
#include <glm/ext/quaternion_trigonometric.hpp>
#include <glm/trigonometric.hpp>

namespace windrow::scene {

glm::quat orientation_of(glm::dvec3 turn_deg) {
    const auto about = [](double degrees, glm::dvec3 axis) { return glm::angleAxis(glm::radians(degrees), axis); };
    return glm::quat(about(turn_deg.x, {0.0, 1.0, 0.0}) * about(turn_deg.y, {1.0, 0.0, 0.0}) *
                     about(turn_deg.z, {0.0, 0.0, 1.0}));
}

glm::dvec3 turn_of(const glm::quat& orientation) {
    const glm::dmat3 axes = glm::mat3_cast(glm::normalize(glm::dquat(orientation)));
    // Pitched straight up or down, yaw and roll are one turn: all of it is yaw.
    constexpr double k_upright = 1e-14;
    if (axes[2].x * axes[2].x + axes[2].z * axes[2].z < k_upright)
        return {glm::degrees(std::atan2(-axes[0].z, axes[0].x)), axes[2].y < 0.0 ? 90.0 : -90.0, 0.0};
    return glm::degrees(glm::dvec3(std::atan2(axes[2].x, axes[2].z), std::asin(glm::clamp(-axes[2].y, -1.0, 1.0)),
                                   std::atan2(axes[0].y, axes[1].y)));
}

glm::dvec3 Scene::followed_point(double time) const {
    if (const auto* path = std::get_if<std::size_t>(&follow))
        return paths[*path].path.at(time);
    if (const auto* point = std::get_if<glm::dvec3>(&follow))
        return *point;
    return air.centre;
}

double Scene::floor_height(double time) const {
    if (const auto* path = std::get_if<std::size_t>(&floor))
        return paths[*path].path.at(time).y;
    return std::get<double>(floor);
}

} // namespace windrow::scene
