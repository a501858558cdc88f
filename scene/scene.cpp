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

std::int64_t Scene::frame_count() const {
    // A hair of slack, so that 0.3 s at 10 frames a second make 4 frames although 0.3 * 10 rounds below 3.
    return static_cast<std::int64_t>(std::floor(duration * frames_per_second * (1.0 + 1e-12) + 1e-9)) + 1;
}

std::int64_t Scene::tick_of_frame(std::int64_t frame) const {
    return std::llround(static_cast<double>(frame) * tick_hz / frames_per_second);
}

} // namespace windrow::scene
