#include "scene/body_motion.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/quaternion.hpp>
#include <limits>

namespace windrow::scene {
namespace {

constexpr double k_turn = 2.0 * glm::pi<double>(); // [rad]

bool moves(glm::dvec3 way) {
    return glm::length(glm::dvec2(way.x, way.z)) > 1e-9; // std::hypot asks for glibc 2.35
}

/// [rad] About the vertical: +z along the path at a time, or, where it waits, along the nearest stretch on which it moves.
double heading(const MotionPath& path, double time) {
    // Over a quarter of a second, so that a corner of the path is no snap.
    glm::dvec3 way = path.at(time + 0.125) - path.at(time - 0.125);
    if (moves(way))
        return std::atan2(way.x, way.z);
    const auto& points = path.points();
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t n = 1; n < points.size(); ++n) {
        const glm::dvec3 stretch = points[n].position - points[n - 1].position;
        const double off = std::max({points[n - 1].time - time, time - points[n].time, 0.0});
        if (!moves(stretch) || off >= nearest)
            continue;
        nearest = off;
        way = stretch;
    }
    return moves(way) ? std::atan2(way.x, way.z) : 0.0;
}

double height_of(const Hop& hop, double time) {
    const double turns = hop.hz * time, air = 1.0 - hop.rest;
    const double share = std::min((turns - std::floor(turns)) / air, 1.0);
    return 4.0 * hop.height * share * (1.0 - share);
}

} // namespace

BodyPose pose_at(const BodyPlace& place, const BodyMotion& motion, const MotionPath* path, const GroundSource& ground,
                 double time) {
    glm::dvec3 position = place.position;
    double yaw = glm::radians(static_cast<double>(place.yaw_deg)) + k_turn * std::fmod(motion.spin_hz * time, 1.0);
    if (path != nullptr) {
        position += path->at(time);
        if (motion.faces)
            yaw += heading(*path, time);
    }
    const double swing = std::sin(k_turn * (motion.sway.hz * time + motion.sway.phase));
    position += swing * motion.sway.by;
    position.y += height_of(motion.hop, time);
    if (place.above_ground)
        position.y += ground.height(position.x, position.z);
    yaw += swing * glm::radians(motion.sway.turn_deg);
    const double pitch = glm::radians(static_cast<double>(place.pitch_deg)) + swing * glm::radians(motion.sway.nod_deg);
    const double roll = glm::radians(static_cast<double>(place.roll_deg));
    return {position, glm::angleAxis(yaw, glm::dvec3(0.0, 1.0, 0.0)) * glm::angleAxis(pitch, glm::dvec3(1.0, 0.0, 0.0)) *
                          glm::angleAxis(roll, glm::dvec3(0.0, 0.0, 1.0))};
}

} // namespace windrow::scene
