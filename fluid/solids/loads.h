// What the pressure does to obstacles, and what of it is kept from step to step: plain data of both backends and of snapshots.
// The impulse is the sum of -phi over the closed faces, the adjoint of what a body's velocity does to the air's divergence.
//
// Based on: Batty, Bertails & Bridson 2007, ACM Transactions on Graphics 26 (pressure on bodies by fractions of faces).
#pragma once

#include "fluid/obstacle.h"
#include "fluid/obstacle_force.h"

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace windrow {

/// What a potential does to a body, over the air's density.
struct PressurePush {
    glm::dvec3 impulse{0.0}; ///< [m^4/s]
    glm::dvec3 twist{0.0};   ///< [m^5/s] about the body's position
    double potential = 0.0;  ///< [m^2/s] mean over its surface
    double wetted = 0.0;     ///< closed faces, by fraction and side

    PressurePush& operator+=(const PressurePush& other) { return *this = *this + other; }
    friend PressurePush operator+(const PressurePush& a, const PressurePush& b) {
        return {a.impulse + b.impulse, a.twist + b.twist, a.potential + b.potential, a.wetted + b.wetted};
    }
    friend PressurePush operator*(double factor, const PressurePush& push) {
        return {factor * push.impulse, factor * push.twist, factor * push.potential, factor * push.wetted};
    }
};

/// `push` in a step of so many seconds.
[[nodiscard]] inline ObstacleForce force_of(const PressurePush& push, double duration) {
    if (!(duration > 0.0))
        return {};
    const double each_second = static_cast<double>(k_air_density) / duration;
    return {.force = glm::vec3(each_second * push.impulse),
            .moment = glm::vec3(each_second * push.twist),
            .pressure = static_cast<float>(each_second * push.potential),
            .in_box = push.wetted > 0.0};
}

/// What is kept of a body, by its handle.
struct BodyLoad {
    std::uint32_t slot = 0, generation = 0;
    bool in_box = false;
    PressurePush history{}; ///< of psi
    PressurePush sources{}; ///< of the potential of volume sources
    PressurePush sum{};     ///< pressure in the step
    PressurePush blast{};   ///< changes of `sources` in the step
};

/// What the air around obstacles keeps from step to step, for snapshots.
struct SurfaceHistory {
    std::vector<PlacedObstacle> placed{}; ///< in the last step
    bool inside_is_air = false;           ///< their cells were filled since, and do not hold their velocity
    std::vector<std::uint32_t> keys{};    ///< of closed faces, in order: 4 times the low cell, plus the axis
    std::vector<float> terms{};           ///< one each
    glm::ivec3 shift{0};                  ///< cells by which the box has moved since
    std::vector<BodyLoad> loads{};
    float duration = 0.0f; ///< [s] of the step of the loads
};

} // namespace windrow
