#include "vegetation/program/body_wakes.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

namespace windrow::vegetation::program {
namespace {

/// Whether the path leads anywhere.
bool leads(const windrow::scene::MotionPath& path) {
    const auto& points = path.points();
    return std::any_of(points.begin(), points.end(),
                       [&](const auto& point) { return glm::distance(point.position, points.front().position) > 1e-6; });
}

/// f(a) of the header, for a up to 5: the terms are then below 26 before they fall.
double pulled(double a) {
    double term = -1.0, sum = 0.0;
    for (int n = 1; n <= 40; ++n) {
        term *= -a / n;
        sum += term / (2.5 * n + 1.0);
    }
    return sum;
}

} // namespace

windrow::WakeMotor wake_of(glm::vec2 front, float cell_size) {
    const double thin = 0.25 * std::max(static_cast<double>(front.x) * static_cast<double>(front.y), 1e-4); // A / pi
    const double radius = std::max(std::sqrt(thin), 1.5 * static_cast<double>(cell_size));
    const double wanted = 0.5 * thin / (radius * radius);
    double low = 0.0, high = 5.0; // pulled() is 0 to 0.52 there
    for (int n = 0; n < 50; ++n) {
        const double middle = 0.5 * (low + high);
        (pulled(middle) < wanted ? low : high) = middle;
    }
    return {.radius = static_cast<float>(radius),
            .law = windrow::WakeDrive{.per_metre = static_cast<float>(0.9375 * low / radius)}};
}

BodyWakes::BodyWakes(const PictureScene& scene, std::span<const BodyBox> boxes) : scene_(&scene) {
    const Picture& picture = scene.picture;
    for (std::size_t n = 0; n < picture.bodies.size() && n < boxes.size(); ++n) {
        const Body& body = picture.bodies[n];
        if (!body.motion.path || !body.motion.wake || body.coats.empty() || taken(*body.motion.path))
            continue;
        const glm::vec3 size = body.place.scale * (boxes[n].high - boxes[n].low);
        const float width =
            body.motion.faces ? size.x : std::sqrt(size.x * size.z); // from any side, where it does not face its way
        wakes_.push_back({.path = *body.motion.path,
                          .walker = nullptr,
                          .body = &body,
                          .middle = glm::dvec3(0.5f * body.place.scale * (boxes[n].low + boxes[n].high)),
                          .motor = wake_of({width, size.y}, scene.air.air.cell_size)});
    }
    for (const Walker& walker : picture.walkers) {
        if (!walker.wake || taken(walker.path))
            continue;
        const glm::vec2 front = walker.figure ? k_walker_front : glm::vec2(2.0f * walker.radius);
        wakes_.push_back({.path = walker.path,
                          .walker = &walker,
                          .body = nullptr,
                          .middle = {0.0, 0.5 * static_cast<double>(front.y), 0.0},
                          .motor = wake_of(front, scene.air.air.cell_size)});
    }
}

bool BodyWakes::taken(std::size_t path) const {
    const auto on_it = [&](const auto& one) { return one.path == path; };
    const windrow::scene::Scene& air = scene_->air;
    return !leads(air.paths[path].path) || std::any_of(wakes_.begin(), wakes_.end(), on_it) ||
           std::any_of(air.obstacles.begin(), air.obstacles.end(), on_it) ||
           std::any_of(air.motors.begin(), air.motors.end(), [&](const windrow::scene::SceneMotor& motor) {
               return on_it(motor) && std::holds_alternative<windrow::WakeMotor>(motor.motor);
           });
}

glm::dvec3 BodyWakes::middle_at(const Wake& wake, double time) const {
    if (wake.body != nullptr) {
        const windrow::Pose pose = pose_of(*scene_, *wake.body, time);
        const glm::dquat turn(pose.rotation.w, pose.rotation.x, pose.rotation.y, pose.rotation.z);
        return pose.position + turn * wake.middle;
    }
    glm::dvec3 place = scene_->air.paths[wake.path].path.at(time);
    place.y = scene_->picture.ground.height(place.x, place.z) + static_cast<double>(wake.walker->foot_height(time));
    return place + wake.middle;
}

windrow::Result<void> BodyWakes::place(windrow::Motors& motors, double start, double end) {
    for (Wake& wake : wakes_) {
        if (wake.id == windrow::MotorId{}) {
            wake.motor.position = middle_at(wake, start);
            const auto added = motors.add(wake.motor);
            if (!added)
                return windrow::Error{(wake.body != nullptr ? "$.picture.bodies, " + wake.body->name : "$.picture.walkers") +
                                      ", wake: " + added.error()};
            wake.id = *added;
        }
        if (auto moved = motors.move(wake.id, middle_at(wake, end)); !moved)
            return moved;
    }
    return {};
}

} // namespace windrow::vegetation::program
