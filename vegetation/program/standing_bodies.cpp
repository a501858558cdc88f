#include "vegetation/program/standing_bodies.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace windrow::vegetation::program {
namespace {

glm::mat4 placed_at(const windrow::Obstacle& obstacle, glm::dvec3 anchor) {
    const glm::mat4 moved = glm::translate(glm::mat4(1.0f), glm::vec3(obstacle.position - anchor));
    return moved * glm::mat4_cast(glm::normalize(obstacle.orientation));
}

} // namespace

Result<StandingBodies> StandingBodies::create(engine::Device& device, const render::DrawTargets& targets,
                                              const PictureScene& scene, glm::dvec3 anchor, bool edited) {
    StandingBodies made(device, scene, anchor, edited);
    if (auto stand = made.make_fans(targets); !stand)
        return stand.failure();
    if (auto stand = made.make_obstacles(targets); !stand)
        return stand.failure();
    return made;
}

void StandingBodies::add_to(render::Renderer& renderer) {
    for (render::Bodies* const one : {fans_.get(), obstacles_.get()})
        if (one != nullptr)
            renderer.add(*one);
}

Result<void> StandingBodies::make_fans(const render::DrawTargets& targets) {
    std::vector<render::Solid> shapes;
    for (const Fan& fan : scene_->picture.fans) {
        const double above = fan.position.y - scene_->picture.ground.height(fan.position.x, fan.position.z);
        shapes.push_back(render::fan_stand(static_cast<float>(fan.radius), static_cast<float>(std::max(above, fan.radius))));
        shapes.push_back(render::fan_blades(static_cast<float>(fan.radius)));
    }
    if (shapes.empty())
        return {};
    auto made = render::Bodies::create(*device_, targets, shapes);
    if (!made)
        return made.failure();
    fans_ = *std::move(made);
    return {};
}

Result<void> StandingBodies::make_obstacles(const render::DrawTargets& targets) {
    obstacles_.reset();
    moving_.clear();
    const auto& obstacles = scene_->air.obstacles;
    const auto& looks = scene_->picture.obstacles;
    std::vector<render::Solid> shapes{{}};
    for (std::size_t n = 0; n < obstacles.size(); ++n) {
        const windrow::scene::SceneObstacle& body = obstacles[n];
        const auto look = std::find_if(looks.begin(), looks.end(), [&](const auto& one) { return one.name == body.name; });
        const render::ObstacleLook drawn = look != looks.end() ? *look : render::ObstacleLook{};
        if (drawn.hidden)
            continue;
        const render::Solid solid = render::obstacle_solid(body.obstacle.shape, drawn);
        if (solid.empty()) // hills are drawn as ground: a body without parts has no place
            continue;
        const bool always = body.from <= 0.0 && body.until > scene_->air.duration;
        if (!edited_ && always && !body.moves() && body.pivot == glm::dvec3(0.0)) {
            render::add(shapes.front(), solid, placed_at(body.obstacle, anchor_));
        } else {
            shapes.push_back(solid);
            moving_.push_back(n);
        }
    }
    if (shapes.size() == 1 && shapes.front().empty())
        return {};
    auto made = render::Bodies::create(*device_, targets, shapes);
    if (!made)
        return made.failure();
    obstacles_ = *std::move(made);
    return {};
}

void StandingBodies::place_fans(double time) {
    if (!fans_)
        return;
    std::size_t body = 0;
    for (const Fan& fan : scene_->picture.fans) {
        const glm::mat4 moved = glm::translate(glm::mat4(1.0f), glm::vec3(fan.position - anchor_));
        const glm::mat4 stands =
            glm::rotate(moved, static_cast<float>(std::atan2(fan.direction.x, fan.direction.z)), glm::vec3(0.0f, 1.0f, 0.0f));
        const double turns = fan.turns_hz * time;
        const auto angle = static_cast<float>(2.0 * glm::pi<double>() * (turns - std::floor(turns)));
        fans_->place(body++, stands);
        fans_->place(body++, glm::rotate(stands, angle, glm::vec3(0.0f, 0.0f, 1.0f)));
    }
}

void StandingBodies::place(double time, const windrow::scene::SceneAir& air) {
    place_fans(time);
    if (!obstacles_)
        return;
    const auto standing = air.standing(time);
    for (std::size_t n = 0; n < moving_.size(); ++n) {
        const auto* const body = &scene_->air.obstacles[moving_[n]];
        const auto found = std::find_if(standing.begin(), standing.end(), [&](const auto& one) { return one.obstacle == body; });
        // Of no size while it is not there.
        obstacles_->place(n + 1, found != standing.end() ? placed_at(found->now, anchor_)
                                                         : glm::scale(glm::mat4(1.0f), glm::vec3(0.0f)));
    }
}

} // namespace windrow::vegetation::program
