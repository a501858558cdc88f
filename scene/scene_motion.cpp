#include "scene/scene_motion.h"

#include "fluid/message.h"

#include <glm/geometric.hpp>
#include <utility>

namespace windrow::scene {
namespace {

using detail::message;

Motor moved(const Motor& motor, glm::dvec3 position) {
    Motor result = motor;
    std::visit([&](auto& kind) { kind.position = position; }, result);
    return result;
}

/// Mean strength between two ages [s].
double strength_of(const Motor& motor, double from, double to) {
    return std::visit(
        [&](const auto& kind) {
            if constexpr (requires { kind.envelope; })
                return kind.envelope.mean(from, to);
            else
                return kind.mean(from, to);
        },
        motor);
}

} // namespace

std::vector<SceneMotion::ActingMotor> SceneMotion::acting(const Motors& motors, double time) const {
    std::vector<ActingMotor> result;
    for (std::size_t i = 0; i < scene_->motors.size(); ++i) {
        const SceneMotor& motor = scene_->motors[i];
        const MovedMotor& part = parts_[i];
        if (time < motor.from || time >= motor.until || (part.begun && motors.find(part.id) == nullptr))
            continue;
        const double age = part.begun ? time - part.since : 0.0;
        result.push_back({&motor, motor.path ? moved(motor.motor, scene_->paths[*motor.path].path.at(time)) : motor.motor,
                          strength_of(motor.motor, age, age + 1.0 / scene_->tick_hz)});
    }
    return result;
}

std::vector<SceneMotion::StandingObstacle> SceneMotion::standing(double time) const {
    std::vector<StandingObstacle> result;
    for (const SceneObstacle& body : scene_->obstacles)
        if (body.from <= time && time < body.until)
            result.push_back({&body, obstacle_at(body, time)});
    return result;
}

bool SceneMotion::StandingObstacle::blocks(glm::dvec3 from, glm::dvec3 to) const {
    const auto reach = static_cast<double>(glm::length(detail::half_extent(now.shape)));
    if (glm::distance(from, now.position) > reach + glm::distance(from, to))
        return false;
    const glm::quat to_own = glm::conjugate(glm::normalize(now.orientation));
    const glm::vec3 begin = to_own * glm::vec3(from - now.position), end = to_own * glm::vec3(to - now.position);
    return detail::distance_to(now.shape, end) < 0.0f || detail::blocks(now.shape, begin, end);
}

Error SceneMotion::rejection(const char* key, double time, const std::string& why) const {
    return Error{message(scene_->file.string(), ": $.", key, " at ", time, " s: ", why)};
}

Result<void> SceneMotion::place_motors(Motors& motors, double start, double end) {
    for (std::size_t i = 0; i < scene_->motors.size(); ++i)
        if (const auto placed = place_motor(motors, scene_->motors[i], parts_[i], start, end); !placed)
            return Error{message(scene_->file.string(), ": $.motors[", i, "]: ", placed.error())};
    return {};
}

Result<void> SceneMotion::place_motor(Motors& motors, const SceneMotor& motor, MovedMotor& part, double start, double end) {
    const double middle = 0.5 * (start + end);
    const bool acts = motor.from <= middle && middle < motor.until;
    if (acts && !part.begun) {
        // A wake begins its path at the body's place at the tick's start, then moves like any other motor.
        const auto added = motors.add(motor.path ? moved(motor.motor, scene_->paths[*motor.path].path.at(start)) : motor.motor);
        if (!added)
            return Error{added.error()};
        part = {.id = *added, .begun = true, .since = start};
    }
    if (motors.find(part.id) == nullptr)
        return {};
    if (!acts)
        return motors.remove(part.id);
    return motor.path ? motors.move(part.id, scene_->paths[*motor.path].path.at(end)) : Result<void>{};
}

Result<void> SceneMotion::place_obstacles(Obstacles& obstacles, double start, double end) {
    for (std::size_t i = 0; i < scene_->obstacles.size(); ++i)
        if (const auto placed = place_obstacle(obstacles, scene_->obstacles[i], bodies_[i], start, end); !placed)
            return Error{message(scene_->file.string(), ": $.obstacles[", i, "]: ", placed.error())};
    return {};
}

Result<void> SceneMotion::place_obstacle(Obstacles& obstacles, const SceneObstacle& body, ObstacleId& id, double start,
                                         double end) {
    const double middle = 0.5 * (start + end);
    const bool is_there = body.from <= middle && middle < body.until;
    if (!is_there)
        return id == ObstacleId{} ? Result<void>{} : obstacles.remove(std::exchange(id, {}));
    if (id == ObstacleId{}) {
        const auto added = obstacles.add(obstacle_at(body, start));
        if (!added)
            return Error{added.error()};
        id = *added;
    }
    if (!body.path && !body.turn_path)
        return {};
    const Obstacle then = obstacle_at(body, end);
    return body.turn_path ? obstacles.move(id, then.position, then.orientation) : obstacles.move(id, then.position);
}

Obstacle SceneMotion::obstacle_at(const SceneObstacle& body, double time) const {
    Obstacle obstacle = body.obstacle;
    if (body.path)
        obstacle.position = scene_->paths[*body.path].path.at(time);
    if (body.turn_path)
        obstacle.orientation = orientation_of(scene_->paths[*body.turn_path].path.at(time));
    return obstacle;
}

} // namespace windrow::scene
