// What pushes the air: fans, gusts, bodies that pass, jets, whirls, blasts.
//
// A motor acts by one of three laws:
//   a force    adds an acceleration w(x) f,
//   a drive    pulls the air toward a velocity U: du = (1 - exp(-k w dt)) (U - u), stable for any strength and step,
//   a source   lets air come out of a ball or vanish in it: div u = S0 w(x),
// with the weight w(x) of its region: 1 in its middle, falling as (1 - s^2)^2 to exactly 0 at the rim (s = distance over
// radius), smooth there. The formulas stand in shaders/numerics/motors.glsl, one text for C++ and GLSL.
// A region thinner than 1.5 cells in radius would fall between the cells; it is widened to that and weakened so that its impulse
// stays.
#pragma once

#include "fluid/result.h"

#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <variant>

namespace windrow {

// --- Regions ---------------------------------------------------------------------------------------------------------

/// Ball: w = (1 - d^2/radius^2)^2.
struct Sphere {
    float radius = 2.0f; ///< [m] > 0
};

/// All points within `radius` of the segment centre - half_axis .. centre + half_axis; d is the distance to the segment.
struct Capsule {
    glm::vec3 half_axis{2.0f, 0.0f, 0.0f}; ///< [m] any finite vector; 0 makes a sphere
    float radius = 1.0f;                   ///< [m] > 0
};

/// Axis-aligned box: w = product over the axes of (1 - d^2/half_size^2)^2.
struct AlignedBox {
    glm::vec3 half_size{2.0f}; ///< [m] each > 0
};

/// Cone or cylinder that begins at the motor's position: w = (1 - (2 z/L - 1)^2)^2 (1 - d^2/r(z)^2)^2, z along the axis of length
/// L and r(z) growing evenly. Equal radii make a cylinder.
struct Cone {
    glm::vec3 axis{6.0f, 0.0f, 0.0f}; ///< [m] from the first end to the second; any finite vector but 0
    float start_radius = 0.5f;        ///< [m] > 0, at the motor's position
    float end_radius = 2.0f;          ///< [m] > 0, at the other end
};

using Region = std::variant<Sphere, Capsule, AlignedBox, Cone>;

// --- Laws ------------------------------------------------------------------------------------------------------------

/// A constant acceleration along the motor's direction.
struct Force {
    float acceleration = 10.0f; ///< [m/s^2] any sign, at most 1e6 in size
};

/// Pulls the air toward a speed along the motor's direction.
struct Drive {
    float speed = 8.0f; ///< [m/s] any sign, at most 1e4 in size
    float rate = 4.0f;  ///< [1/s] how fast: 63 % of the way in 1/rate seconds where w = 1; 0 to 1e6
};

/// A wake that pushes: along its path it adds `strength * w` metres per second for each metre that the body passes, so the
/// impulse per metre is fixed and the impulse per second grows in proportion to the speed.
struct WakeForce {
    float strength = 1.0f; ///< [1/s] 0 to 1e4
};

/// A wake that drags: the air is pulled toward `entrainment` times the body's velocity; the exponent is the path integral of
/// `per_metre * w`, so cutting the path into steps changes nothing.
struct WakeDrive {
    float per_metre = 0.5f;   ///< [1/m] 0 to 1e4
    float entrainment = 1.0f; ///< share of the body's velocity, 0 to 2
};

// --- Time ------------------------------------------------------------------------------------------------------------

/// Strength over time, from the moment at which the motor is added: a smooth rise, full strength, a smooth fall (3 s^2 - 2 s^3
/// each). Steps take its mean over the step, so an impulse does not depend on the frame rate. When it has ended the motor is
/// removed by itself and its handle is stale: a gust needs no keeper.
struct Envelope {
    float attack = 0.0f;                                 ///< [s] >= 0
    float hold = std::numeric_limits<float>::infinity(); ///< [s] >= 0; infinity, the default: until it is removed
    float decay = 0.0f;                                  ///< [s] >= 0

    /// Mean strength between two ages [s], 0 to 1.
    [[nodiscard]] double mean(double from, double to) const;
    /// [s] Age at which it has ended.
    [[nodiscard]] double end() const;
};

// --- Turbulence ------------------------------------------------------------------------------------------------------

/// Eddies in what a motor blows. Without them a jet stays a rod for ten diameters: what makes it roll up and spread is missing.
/// The law's velocity (or acceleration) becomes
///   U + 2.8 w intensity |U| n((x - x_motor - 0.7 U t) / s),
/// n the gust tile (gust_tile.h) of standard deviation 1, w the region's weight, U the law's own, t the motor's age at the middle
/// of the step. 0.7 is about the speed at which eddies travel in the shear layer of a round jet; 2.8 makes up for the weight: what
/// leaves a jet of 5 cells a radius has the intensity asked for. For a force, U is the speed that it gives air over a radius. A
/// body's wake takes eddies that rest in the world, without w.
struct Turbulence {
    /// Standard deviation over U of a level component of what leaves the region, 0 to 1. 0: none, and it costs nothing. At 0.05
    /// jets spread as measured ones do.
    float intensity = 0.05f;
    /// [m] Of the longest eddies, 0 to 1e6; most are a third of that. Default 0: two radii of the region (of a box, two of its
    /// smallest half sizes).
    float length = 0.0f;
    /// Which stretch of the pattern: motors that share a kind, an age and a seed blow alike. Default 0; any value.
    std::uint32_t seed = 0;
};

// --- Motors ----------------------------------------------------------------------------------------------------------

/// A fan, a gust, a draught: pushes along one direction within a region.
struct DirectionalMotor {
    glm::dvec3 position{0.0};              ///< [m] world; centre of the region (first end of a cone)
    glm::vec3 direction{1.0f, 0.0f, 0.0f}; ///< any length but 0; normalised on creation
    Region region = Sphere{};
    std::variant<Force, Drive> law = Drive{};
    Envelope envelope{};
    Turbulence turbulence{};
};

/// A moving body: acts only while it moves, along the path through all positions that `Motors::move` gave since the last step.
/// Several moves between two steps make a curved path.
struct WakeMotor {
    glm::dvec3 position{0.0}; ///< [m] world; where the path begins
    float radius = 0.5f;      ///< [m] > 0
    std::variant<WakeForce, WakeDrive> law = WakeDrive{};
    Envelope envelope{};
    Turbulence turbulence{.intensity = 0.0f}; ///< default none: a wake makes its own
};

/// A nozzle: blows along a cone or cylinder whose rays spread from the cone's tip and slow as it widens, so that each section
/// passes the same momentum. `speed` and `acceleration` hold at the nozzle.
struct JetMotor {
    glm::dvec3 position{0.0};              ///< [m] world; the nozzle
    glm::vec3 direction{1.0f, 0.0f, 0.0f}; ///< any length but 0; normalised on creation
    float length = 6.0f;                   ///< [m] > 0; how far it pushes. The air carries the jet on beyond it.
    float start_radius = 0.5f;             ///< [m] > 0, at the nozzle
    float end_radius = 1.5f;               ///< [m] > 0, at the end; equal to start_radius: a cylinder
    std::variant<Force, Drive> law = Drive{.speed = 12.0f, .rate = 8.0f};
    Envelope envelope{};
    Turbulence turbulence{};
};

/// A whirl: turns the air right-handed about an axis, fastest at 0.447 of the radius. A negative speed or acceleration turns it
/// the other way.
struct VortexMotor {
    glm::dvec3 position{0.0};         ///< [m] world; the middle
    glm::vec3 axis{0.0f, 1.0f, 0.0f}; ///< any length but 0; normalised on creation
    /// [m] > 0; beyond it nothing acts. Circulation comes out within 5 % where the fastest ring, at 0.447 of it, is 3.5 cells or
    /// wider.
    float radius = 4.0f;
    float half_length = 4.0f; ///< [m] > 0; along the axis, to each end
    float lift = 0.0f;        ///< push along the axis in the middle over the swirl; -10 to 10. A dust devil has about 0.5.
    std::variant<Force, Drive> law = Drive{.speed = 8.0f, .rate = 8.0f};
    Envelope envelope{};
};

/// Air that comes out of a ball (a blast, a vent) or vanishes in it (suction). In incompressible air a radial push is a pure
/// gradient, which the pressure takes back whole; only a source can blow outward. In free air the speed is `speed` at the ball's
/// radius and falls as 1/distance^2 beyond: in a box every axis of which is open at one end at least, with walls as mirrors. There
/// a source outside the box blows into it too.
struct OmniMotor {
    glm::dvec3 position{0.0}; ///< [m] world
    float radius = 2.0f;      ///< [m] > 0
    float speed = 5.0f;       ///< [m/s] outward at the radius, at most 1e4 in size; negative draws in
    Envelope envelope{};
};

/// A burst of pressure: air is thrown out, then drawn back, as behind a blast wave: outflow (1 - t/T) exp(-t/T) times its start,
/// which leaves no air over. It begins when it is added, and removes itself 12 durations later, when 1e-4 of it is left. Based
/// on: Friedlander 1946, Proceedings of the Royal Society A 186 (the wave's form in time).
struct PressureMotor {
    glm::dvec3 position{0.0}; ///< [m] world
    float radius = 2.0f;      ///< [m] > 0
    float speed = 20.0f;      ///< [m/s] outward at the radius in the first moment, at most 1e4 in size; negative: implosion
    float duration = 0.2f;    ///< [s] T > 0: how long it throws out before it draws back

    /// Mean of the outflow's form between two ages [s].
    [[nodiscard]] double mean(double from, double to) const;
    /// [s] Age at which it has ended.
    [[nodiscard]] double end() const { return 12.0 * static_cast<double>(duration); }
};

using Motor = std::variant<DirectionalMotor, WakeMotor, JetMotor, VortexMotor, OmniMotor, PressureMotor>;

/// Every reason why a motor cannot be used, a line each.
[[nodiscard]] Result<void> validate(const Motor& motor);

/// [m] Where a motor stands.
[[nodiscard]] glm::dvec3 position_of(const Motor& motor);

namespace detail {
[[nodiscard]] Result<void> validate_motor_position(glm::dvec3 position);
}

} // namespace windrow
