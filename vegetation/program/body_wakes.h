// Wakes of the bodies that a picture moves: whoever is drawn on a path carries the air along, unasked.
//
//     auto wakes = BodyWakes(scene, body_boxes);
//     (void)wakes.place(wind->motors(), start, end);       // each frame, after SceneMotion::place
//
// A body of frontal area A that moves at V leaves C A V / 2 of momentum (over the density) in each metre of its way: its drag, with
// C = 1, a bluff body's. A wake of radius R and rate k leaves V times the integral of 1 - exp(-k W) over the way's section
// (shaders/numerics/motors.glsl), W = 16/15 R (1 - s^2)^(5/2). With a = 16/15 k R that integral over pi R^2 is the series
//
//     f(a) = sum over n >= 1 of -(-a)^n / (n! (5 n / 2 + 1)),   and both are equal where f(a) = A / (2 pi R^2).
//
// R is that of a circle of the area A, f = 1/2, or 1.5 cells where the body is thinner; then the pull is weaker, the momentum the
// same.
//
// Air that the scene moves there already is not moved twice. There is no wake on a path that a wake or an obstacle of the scene is
// on, one wake for all that is drawn on the same path, and none where `wake` of the walker or of the body's motion is false.
#pragma once

#include "fluid/motors.h"
#include "vegetation/program/picture_scene.h"

#include <span>
#include <vector>

namespace windrow::vegetation::program {

/// [m] Width and height of a drawn person (render/person.h), seen from the front.
inline constexpr glm::vec2 k_walker_front{0.5f, 1.75f};

/// [m] The box of a body's mesh, before its place and scale.
struct BodyBox {
    glm::vec3 low{0.0f}, high{0.0f};
};

/// The motor of something so wide and high [m], whose front is an ellipse, in cells of `cell_size` [m].
[[nodiscard]] windrow::WakeMotor wake_of(glm::vec2 front, float cell_size);

class BodyWakes {
  public:
    BodyWakes() = default;
    /// One box for each of the picture's bodies. The scene outlives it.
    BodyWakes(const PictureScene& scene, std::span<const BodyBox> boxes);

    /// The wakes sweep from where their bodies are at `start` [s] to where they are at `end`. Rejects what Motors rejects.
    windrow::Result<void> place(windrow::Motors& motors, double start, double end);
    [[nodiscard]] std::size_t count() const { return wakes_.size(); }

  private:
    struct Wake {
        std::size_t path;           ///< index in Scene::paths
        const Walker* walker;       ///< null: a body's
        const Body* body;           ///< null: a walker's
        glm::dvec3 middle;          ///< [m] of the body, in its own axes from its origin
        windrow::WakeMotor motor{}; ///< its position aside
        windrow::MotorId id{};
    };
    /// Whether something moves the air on that path already.
    [[nodiscard]] bool taken(std::size_t path) const;
    [[nodiscard]] glm::dvec3 middle_at(const Wake& wake, double time) const;

    const PictureScene* scene_ = nullptr;
    std::vector<Wake> wakes_{};
};

} // namespace windrow::vegetation::program
