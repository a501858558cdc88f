#include "vegetation/program/body.h"

#include "vegetation/program/picture_scene.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/quaternion.hpp>
#include <limits>

namespace windrow::vegetation::program {
namespace {

constexpr double k_turn = 2.0 * glm::pi<double>(); // [rad]

bool moves(glm::dvec3 way) {
    return std::hypot(way.x, way.z) > 1e-9;
}

/// [rad] About the vertical: +z along the path at a time, or, where it waits, along the nearest stretch on which it moves.
double heading(const windrow::scene::MotionPath& path, double time) {
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

windrow::Pose pose_of(const PictureScene& scene, const Body& body, double time) {
    const BodyMotion& motion = body.motion;
    glm::dvec3 place = body.place.position;
    double yaw = glm::radians(static_cast<double>(body.place.yaw_deg)) + k_turn * std::fmod(motion.spin_hz * time, 1.0);
    if (motion.path) {
        const windrow::scene::MotionPath& path = scene.air.paths[*motion.path].path;
        place += path.at(time);
        if (motion.faces)
            yaw += heading(path, time);
    }
    const double swing = std::sin(k_turn * (motion.sway.hz * time + motion.sway.phase));
    place += swing * motion.sway.by;
    place.y += height_of(motion.hop, time);
    if (body.place.above_ground)
        place.y += scene.picture.ground.height(place.x, place.z);
    yaw += swing * glm::radians(motion.sway.turn_deg);
    const double pitch = glm::radians(static_cast<double>(body.place.pitch_deg)) + swing * glm::radians(motion.sway.nod_deg);
    const double roll = glm::radians(static_cast<double>(body.place.roll_deg));
    const glm::dquat turn = glm::angleAxis(yaw, glm::dvec3(0.0, 1.0, 0.0)) * glm::angleAxis(pitch, glm::dvec3(1.0, 0.0, 0.0)) *
                            glm::angleAxis(roll, glm::dvec3(0.0, 0.0, 1.0));
    return {.position = place, .rotation = {turn.x, turn.y, turn.z, turn.w}, .scale = static_cast<double>(body.place.scale)};
}

fur::CoatSettings settings_of(const BodyCoat& coat, const std::optional<fur::FurLine>& fur) {
    fur::CoatSettings settings = coat.coat;
    if (!fur)
        return settings;
    if (!coat.said.shells)
        settings.layers.shells = fur->shells;
    if (!coat.said.length)
        settings.layers.length = fur->height;
    if (!coat.said.thickness)
        settings.strands.thickness = fur->thickness;
    if (!coat.said.density)
        settings.strands.density = fur->resolution;
    return settings;
}

} // namespace windrow::vegetation::program
