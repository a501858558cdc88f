// What was put into the air, as a speed: what a run is measured by where forces act.
//
// Without pressure every rule of the step pulls the air toward something or adds an impulse: transport brings what was
// elsewhere, a side, a wall, viscosity or the relaxation time pull toward the wind outside or the wall, a drive toward its target.
// So along each path
//   |u| <= V = max(start, winds outside, walls, targets) + sum of the impulses + 2 max(flow of the sources of air)
// The flow of sources counts twice: a drive pulls the whole wind toward its target while the flow stands in it, so that what is
// solved, wind less flow, may hold both. Gusts are given, not solved, as that flow is, and count twice as well.
//
// Pressure shares speed out: projecting takes energy, never adds any. So two bounds are asked, both stated here once:
//   energy     that of the whole box at V: it could be passed only by air that is driven while it is faster than its target;
//   largest    k_speed_factor V: a cubic read overshoots by at most 1.25 an axis (operators.h), 1.95 in all, and shear rolls up to
//              1.5 of its speed (hard_cases_test.cpp): 2.93 together. 1.8 was seen where jets meet.
#pragma once

#include "fluid/wind.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <variant>

namespace windrow::test {

inline constexpr double k_input_energy = 1.001;
inline constexpr double k_speed_factor = 3.0;

/// How a motor may change the air in a box of such cells.
struct MotorInput {
    double target = 0.0;       ///< [m/s] what it pulls the air toward
    double acceleration = 0.0; ///< [m/s^2]
    double flow = 0.0;         ///< [m/s] air that comes out of it or vanishes in it
    double per_metre = 0.0;    ///< [1/s] a wake: change of speed for each metre of its path
    double entrainment = 0.0;  ///< a wake: share of the body's velocity
};

namespace detail {

// A shape's largest push over the law's own figure; regions thinner than 1.5 cells are widened.
inline double push_of(const Motor& motor, double h) {
    if (const auto* jet = std::get_if<JetMotor>(&motor)) {
        const double start = std::max<double>(jet->start_radius, 1.5 * h), end = std::max<double>(jet->end_radius, 1.5 * h);
        const double length = std::max<double>(jet->length, 3.0 * h);
        return std::max(1.0, start / end) * std::hypot(1.0, (end - start) / length);
    }
    if (const auto* vortex = std::get_if<VortexMotor>(&motor))
        return std::hypot(1.0, static_cast<double>(vortex->lift));
    return 1.0;
}

// The longest push with turbulence over that without.
inline double eddies_of(const Motor& motor) {
    static const double longest = static_cast<double>(GustTile::standard()->bound());
    return std::visit(
        [&](const auto& kind) {
            if constexpr (requires { kind.turbulence; })
                return 1.0 + 2.8 * static_cast<double>(kind.turbulence.intensity) * longest;
            else
                return 1.0;
        },
        motor);
}

} // namespace detail

[[nodiscard]] inline MotorInput input_of(const Motor& motor, double h) {
    const double push = detail::push_of(motor, h);
    MotorInput input;
    const auto lawful = [&](const auto& law) {
        if (const auto* force = std::get_if<Force>(&law))
            input.acceleration = push * std::abs(static_cast<double>(force->acceleration));
        else
            input.target = push * std::abs(static_cast<double>(std::get<Drive>(law).speed));
    };
    // All that comes out passes each section of a channel one cell wide, and no face of the box is passed by more.
    const auto flow = [&](double radius, double speed) {
        input.flow = 4.0 * std::numbers::pi * radius * radius * std::abs(speed) / (h * h);
    };
    if (const auto* directional = std::get_if<DirectionalMotor>(&motor))
        lawful(directional->law);
    else if (const auto* jet = std::get_if<JetMotor>(&motor))
        lawful(jet->law);
    else if (const auto* vortex = std::get_if<VortexMotor>(&motor))
        lawful(vortex->law);
    else if (const auto* omni = std::get_if<OmniMotor>(&motor))
        flow(omni->radius, omni->speed);
    else if (const auto* burst = std::get_if<PressureMotor>(&motor))
        flow(burst->radius, burst->speed);
    else if (const auto* wake = std::get_if<WakeMotor>(&motor)) {
        if (const auto* force = std::get_if<WakeForce>(&wake->law))
            input.per_metre = force->strength;
        else
            input.entrainment = std::get<WakeDrive>(wake->law).entrainment;
    }
    const double eddies = detail::eddies_of(motor);
    input.target *= eddies;
    input.acceleration *= eddies;
    input.per_metre *= eddies;
    input.entrainment *= eddies;
    return input;
}

class Input {
  public:
    /// Something that the air is pulled toward. [m/s]
    void meets(double speed) { fastest_ = std::max(fastest_, speed); }
    void meets(glm::vec3 velocity) { meets(glm::length(glm::dvec3(velocity))); }
    void meets(const Boundaries& boundaries) {
        for (int axis = 0; axis < 3; ++axis)
            for (int end = 0; end < 2; ++end)
                meets(boundaries.at(axis, end).wall_velocity);
    }
    /// A change that adds to what is there. [m/s]
    void adds(double speed) { added_ += speed; }
    /// A given part of the wind, while it stands. [m/s]
    void gives(double speed) { given_ = std::max(given_, speed); }
    /// A motor acts for a step. The second half of a force's impulse is felt one step later, and up to twice where that step is
    /// longer: 1.5 f dt.
    void acts(const MotorInput& motor, double dt) {
        meets(motor.target);
        adds(1.5 * motor.acceleration * dt);
    }
    /// A wake is swept along a path [m], in a time [s].
    void drags_along(const MotorInput& wake, double path, double duration) { meets(wake.entrainment * path / duration); }
    void pushes_along(const MotorInput& wake, double path) { adds(1.5 * wake.per_metre * path); }

    [[nodiscard]] double speed() const { return fastest_ + added_ + 2.0 * given_; }

  private:
    double fastest_ = 0.0, added_ = 0.0, given_ = 0.0;
};

} // namespace windrow::test
