// What a scene's picture moves along a path and what carries the air along, unasked: its walkers and furred bodies.
//
// A body of frontal area A that moves at V leaves C A V / 2 of momentum (over the density) in each metre of its way: its drag, with
// C = 1, a bluff body's. A wake of radius R and rate k leaves V times the integral of 1 - exp(-k W) over the way's section
// (shaders/numerics/motors.glsl), W = 16/15 R (1 - s^2)^(5/2). With a = 16/15 k R that integral over pi R^2 is the series
//
//     f(a) = sum over n >= 1 of -(-a)^n / (n! (5 n / 2 + 1)),   and both are equal where f(a) = A / (2 pi R^2).
//
// R is that of a circle of the area A, f = 1/2, or 1.5 cells where the body is thinner; then the pull is weaker, the momentum the
// same.
#pragma once

#include "fluid/motor.h"
#include "scene/motion_path.h"

#include <cstddef>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>

namespace windrow::scene {

struct Carried {
    std::string key;       ///< for sentences: "$.picture.walkers[0]"
    std::size_t path = 0;  ///< index in Scene::paths
    glm::vec2 front{0.0f}; ///< [m] its width and height, seen from the front
    /// [m] Its middle at a time [s], on that path.
    std::function<glm::dvec3(const MotionPath& path, double time)> middle_at{};
};

/// [m] Width and height of a drawn person (vegetation/render/person.h), seen from the front.
inline constexpr glm::vec2 k_walker_front{0.5f, 1.75f};

/// The motor of something so wide and high [m], whose front is an ellipse, in cells of `cell_size` [m]; its position aside.
[[nodiscard]] WakeMotor wake_of(glm::vec2 front, float cell_size);

} // namespace windrow::scene
