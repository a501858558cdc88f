#include "vegetation/program/figures.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace windrow::vegetation::program {
namespace {

namespace person = render::person;

constexpr double k_ahead = 0.9; // [m] ahead of a walker, where its own wake has not been yet

/// [rad] Heel and toes over the stand and the swing: toes up before the foot lands, heel up before it leaves.
double pitch_of(const Gait::Foot& foot) {
    if (foot.planted)
        return 0.95 * glm::smoothstep(0.55, 1.0, foot.stood) - 0.25 * (1.0 - glm::smoothstep(0.0, 0.15, foot.stood));
    return 0.95 * (1.0 - glm::smoothstep(0.0, 0.55, foot.swung)) - 0.25 * glm::smoothstep(0.55, 1.0, foot.swung);
}

/// [m] By which a leg may be drawn in at its foot: none while it carries.
double slack_of(const Gait::Foot& foot) {
    return 0.15 * (foot.planted ? glm::smoothstep(0.5, 1.0, foot.stood) : 1.0 - glm::smoothstep(0.75, 1.0, foot.swung));
}

/// The least of three, rounded over some centimetres, so that hips do not jerk where one leg takes over from the other.
double soft_least(double a, double b, double c) {
    constexpr double k_round = 0.04; // [m]
    const double least = std::min({a, b, c});
    return least - k_round * std::log(std::exp((least - a) / k_round) + std::exp((least - b) / k_round) +
                                      std::exp((least - c) / k_round));
}

} // namespace

WalkerPose walker_pose(const PictureScene& scene, const Walker& walker, const Gait& gait, double time) {
    const GroundSource& ground = scene.picture.ground;
    const double way = gait.way(time);
    const glm::dvec2 on_path = gait.at(way);
    const double jump = static_cast<double>(walker.foot_height(time));
    WalkerPose pose;
    pose.place = {on_path.x, ground.height(on_path.x, on_path.y) + jump, on_path.y};
    pose.yaw = gait.heading(way);
    render::PersonStance& stance = pose.stance;
    const double brisk = std::min(gait.speed() / 1.4, 1.0), fast = std::clamp((gait.speed() - 1.4) / 3.0, 0.0, 1.0);
    stance.lean = static_cast<float>(0.03 * brisk + 0.20 * fast);

    double forward[2] = {}, highest[2] = {};
    for (int n = 0; n < 2; ++n) {
        const Gait::Foot foot = gait.foot(n, time);
        const double side = n == 0 ? 1.0 : -1.0, aside = 0.085 * side * (1.0 - 0.4 * fast), turn = gait.heading(foot.way);
        const glm::dvec2 set = gait.at(foot.way) + aside * glm::dvec2(std::cos(turn), -std::sin(turn));
        const double pitch = pitch_of(foot), swing = std::sin(glm::pi<double>() * foot.swung);
        const glm::dvec2 off = set - on_path;
        const double c = std::cos(pose.yaw), s = std::sin(pose.yaw);
        // A heel that rises about the toes takes the ankle up and ahead.
        const double heel = std::max(pitch, 0.0);
        const double height = ground.height(set.x, set.y) + jump - pose.place.y + static_cast<double>(person::k_ankle) +
                              0.15 * std::sin(heel) + swing * (0.05 * brisk + 0.22 * fast);
        const glm::dvec3 ankle(c * off.x - s * off.y, height, s * off.x + c * off.y - 0.05 + 0.12 * std::sin(heel));
        stance.legs[static_cast<std::size_t>(n)] = {.ankle = glm::vec3(ankle),
                                                    .pitch = static_cast<float>(pitch + 0.5 * swing * fast)};
        forward[n] = ankle.z + 0.05;
        const double reach = static_cast<double>(person::k_thigh + person::k_shin) - 0.008, level = ankle.z * ankle.z;
        highest[n] = height + std::sqrt(std::max(reach * reach - level, 0.01)) + slack_of(foot);
    }
    const double upright = static_cast<double>(person::k_hip) - 0.02 * brisk - 0.06 * fast;
    stance.hip = static_cast<float>(soft_least(highest[0], highest[1], upright));
    // Arms go against their legs.
    const double span = std::max(0.5 * gait.stride() * 0.62, 0.1);
    for (std::size_t n = 0; n < 2; ++n) {
        const double back = std::clamp((forward[n] - forward[1 - n]) / (2.0 * span), -1.0, 1.0);
        stance.arms[n] = {.swing = static_cast<float>((0.42 * brisk + 0.35 * fast) * back),
                          .bend = static_cast<float>(0.18 + 0.15 * brisk + 1.1 * fast)};
    }
    stance.twist = static_cast<float>(-0.10 * brisk * std::clamp((forward[0] - forward[1]) / (2.0 * span), -1.0, 1.0));
    return pose;
}

bool Figures::any(const PictureScene& scene) {
    return std::any_of(scene.picture.walkers.begin(), scene.picture.walkers.end(), [](const Walker& one) { return one.figure; });
}

windrow::Result<Figures> Figures::create(engine::Device& device, const render::DrawTargets& targets, const PictureScene& scene,
                                         glm::dvec3 anchor) {
    Figures made(scene, anchor);
    if (!any(scene))
        return made;
    render::Solid whole = render::person_solid();
    const render::Solid cloak = render::Cloak::solid(person::k_parts);
    whole.insert(whole.end(), cloak.begin(), cloak.end());
    for (const Walker& walker : scene.picture.walkers)
        if (walker.figure)
            made.figures_.push_back({.walker = walker, .gait = Gait(scene.air.paths[walker.path].path)});
    auto bodies = render::Bodies::create(device, targets, std::span(&whole, 1), made.figures_.size());
    if (!bodies)
        return bodies.failure();
    made.bodies_ = *std::move(bodies);
    return made;
}

void Figures::add_to(render::Renderer& renderer) {
    if (bodies_)
        renderer.add(*bodies_);
}

void Figures::move(double time, double seconds, const WindAt& wind) {
    for (Figure& figure : figures_) {
        figure.pose = walker_pose(*scene_, figure.walker, figure.gait, time);
        figure.parts = render::person_parts(figure.pose.stance);
        const auto& path = scene_->air.paths[figure.walker.path].path;
        const glm::dvec3 velocity =
            (path.at(time) - path.at(time - 0.125)) / 0.125; // a start and a stop take an eighth of a second
        const glm::dvec3 own(velocity.x, 0.0, velocity.z);
        const double speed = glm::length(own);
        const glm::dvec3 ahead = speed > 0.1 ? k_ahead / speed * own : glm::dvec3(0.0);
        const auto passing = [&](double height) {
            return wind(figure.pose.place + ahead + glm::dvec3(0.0, height, 0.0)) - glm::vec3(own);
        };
        figure.cloak.advance(seconds, {.parts = figure.parts,
                                       .yaw = static_cast<float>(figure.pose.yaw),
                                       .high = passing(static_cast<double>(person::k_shoulder)),
                                       .low = passing(0.5)});
    }
}

void Figures::place() {
    for (std::size_t n = 0; n < figures_.size(); ++n) {
        const Figure& figure = figures_[n];
        const glm::mat4 moved = glm::translate(glm::mat4(1.0f), glm::vec3(figure.pose.place - anchor_));
        const glm::mat4 stands = glm::rotate(moved, static_cast<float>(figure.pose.yaw), glm::vec3(0.0f, 1.0f, 0.0f));
        for (std::size_t part = 0; part < figure.parts.size(); ++part)
            bodies_->place(n, part, stands * figure.parts[part]);
        const std::vector<glm::mat4> cloth = figure.cloak.placements();
        for (std::size_t point = 0; point < cloth.size(); ++point)
            bodies_->place(n, person::k_parts + point, stands * cloth[point]);
    }
}

} // namespace windrow::vegetation::program
