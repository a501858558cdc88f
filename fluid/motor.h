// Motors, the sources of momentum and volume: fans, gusts, passing bodies, jets, vortices, blasts.
//
// A motor acts by one of three laws:
//   a force    adds an acceleration w(x) f,
//   a drive    pulls the air toward a velocity U: du = (1 - exp(-k w dt)) (U - u), stable for any strength and step,
//   a source   adds or removes volume in a ball: div u = S0 w(x),
// with the weight w(x) of its region: 1 in its middle, falling as (1 - s^2)^2 to exactly 0 at its edge (s = distance over
// radius), smooth there. The formulas stand in shaders/numerics/motors.glsl, one text for C++ and GLSL.
// A region thinner than 1.5 cells in radius would fall between the cells; it is widened to that and weakened so that its impulse
// stays.
#pragma once

#include "api.h"
#include "result.h"
#include "setting.h"

#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <tuple>
#include <variant>

namespace windrow {

// --- Regions ---------------------------------------------------------------------------------------------------------

/// Ball: w = (1 - d^2/radius^2)^2.
struct Sphere {
    static constexpr const char* k_name = "sphere";
    static constexpr const char* k_meaning = "A ball.";
    /// [m] A number above 0, at most 1e6, default 2. Radius.
    float radius = 2.0f;

    static constexpr auto settings() { return std::tuple{Setting("radius", &Sphere::radius, k_size_range, "Radius.")}; }
};

/// All points within `radius` of the segment centre - half_axis .. centre + half_axis; d is the distance to the segment.
struct Capsule {
    static constexpr const char* k_name = "capsule";
    static constexpr const char* k_meaning = "A ball drawn out along a segment.";
    /// [m] A length of 0 to 1e6, default (2, 0, 0). From the centre to the middle of an end; 0 makes a sphere.
    glm::vec3 half_axis{2.0f, 0.0f, 0.0f};
    /// [m] A number above 0, at most 1e6, default 1. Radius.
    float radius = 1.0f;

    static constexpr auto settings() {
        return std::tuple{
            Setting("half_axis", &Capsule::half_axis, Range::length(0.0, 1e6, "m"),
                    "From the centre to the middle of an end; 0 makes a sphere."),
            Setting("radius", &Capsule::radius, k_size_range, "Radius."),
        };
    }
};

/// Axis-aligned box: w = product over the axes of (1 - d^2/half_size^2)^2.
struct AlignedBox {
    static constexpr const char* k_name = "box";
    static constexpr const char* k_meaning = "A box along the axes.";
    /// [m] Each component a number above 0, at most 1e6, default (2, 2, 2). From the centre to the faces.
    glm::vec3 half_size{2.0f};

    static constexpr auto settings() {
        return std::tuple{Setting("half_size", &AlignedBox::half_size, k_size_range, "From the centre to the faces.")};
    }
};

/// Cone or cylinder that begins at the motor's position: w = (1 - (2 z/L - 1)^2)^2 (1 - d^2/r(z)^2)^2, z along the axis of length
/// L and r(z) growing evenly. Equal radii make a cylinder.
struct Cone {
    static constexpr const char* k_name = "cone";
    static constexpr const char* k_meaning = "A cone or cylinder that begins at the motor's position.";
    /// [m] A length of 1e-6 to 1e6, default (6, 0, 0). From the motor's position to the other end.
    glm::vec3 axis{6.0f, 0.0f, 0.0f};
    /// [m] A number above 0, at most 1e6, default 0.5. Radius at the motor's position.
    float start_radius = 0.5f;
    /// [m] A number above 0, at most 1e6, default 2. Radius at the other end.
    float end_radius = 2.0f;

    static constexpr auto settings() {
        return std::tuple{
            Setting("axis", &Cone::axis, Range::length(1e-6, 1e6, "m"), "From the motor's position to the other end."),
            Setting("start_radius", &Cone::start_radius, k_size_range, "Radius at the motor's position."),
            Setting("end_radius", &Cone::end_radius, k_size_range, "Radius at the other end."),
        };
    }
};

using Region = std::variant<Sphere, Capsule, AlignedBox, Cone>;

// --- Laws ------------------------------------------------------------------------------------------------------------

/// A constant acceleration along the motor's direction.
struct Force {
    static constexpr const char* k_name = "force";
    static constexpr const char* k_meaning = "A constant acceleration.";
    /// [m/s^2] -1e6 to 1e6, default 10. Acceleration along the motor's direction.
    float acceleration = 10.0f;

    static constexpr auto settings() {
        return std::tuple{
            Setting("acceleration", &Force::acceleration, {-1e6, 1e6, "m/s^2"}, "Acceleration along the motor's direction.")};
    }
};

/// Relaxation of the air to a speed along the motor's direction.
struct Drive {
    static constexpr const char* k_name = "drive";
    static constexpr const char* k_meaning = "Pulls the air toward a speed.";
    /// [m/s] -10000 to 10000, default 8. Target speed along the motor's direction.
    float speed = 8.0f;
    /// [1/s] 0 to 1e6, default 4. How fast: 63 % of the way in 1/rate seconds where w = 1.
    float rate = 4.0f;

    static constexpr auto settings() {
        return std::tuple{
            Setting("speed", &Drive::speed, k_speed_range, "Target speed along the motor's direction."),
            Setting("rate", &Drive::rate, {0.0, 1e6, "1/s"}, "How fast: 63 % of the way in 1/rate seconds where w = 1."),
        };
    }
};

/// Force of a wake: along its path it adds `strength * w` metres per second for each metre that the body passes, so the
/// impulse per metre is fixed and the impulse per second grows in proportion to the speed.
struct WakeForce {
    static constexpr const char* k_name = "force";
    static constexpr const char* k_meaning = "Pushes: the same impulse for each metre that the body passes.";
    /// [1/s] 0 to 10000, default 1. Speed that each metre of the path adds where w = 1.
    float strength = 1.0f;

    static constexpr auto settings() {
        return std::tuple{
            Setting("strength", &WakeForce::strength, {0.0, 1e4, "1/s"}, "Speed that each metre of the path adds where w = 1.")};
    }
};

/// Drive of a wake: the air is pulled toward `entrainment` times the body's velocity; the exponent is the path integral of
/// `per_metre * w`, so cutting the path into steps changes nothing.
struct WakeDrive {
    static constexpr const char* k_name = "drive";
    static constexpr const char* k_meaning = "Drags: pulls the air toward a fraction of the body's velocity.";
    /// [1/m] 0 to 10000, default 0.5. How fast: 63 % of the way when the body has passed 1/per_metre metres where w = 1.
    float per_metre = 0.5f;
    /// 0 to 2, default 1. Fraction of the body's velocity that the air is pulled toward.
    float entrainment = 1.0f;

    static constexpr auto settings() {
        return std::tuple{
            Setting("per_metre", &WakeDrive::per_metre, {0.0, 1e4, "1/m"},
                    "How fast: 63 % of the way when the body has passed 1/per_metre metres where w = 1."),
            Setting("entrainment", &WakeDrive::entrainment, {0.0, 2.0},
                    "Fraction of the body's velocity that the air is pulled toward."),
        };
    }
};

// --- Time ------------------------------------------------------------------------------------------------------------

/// Strength over time, from the moment at which the motor is added: a smooth rise, full strength, a smooth fall (3 s^2 - 2 s^3
/// each). Steps take its mean over the step, so an impulse does not depend on the frame rate. At its end the motor is
/// removed by itself and its handle is stale.
struct WINDROW_API Envelope {
    static constexpr Range k_time_range{0.0, 1e9, "s"};
    /// [s] 0 to 1e9, default 0. Time in which it rises.
    float attack = 0.0f;
    /// [s] At least 0, default infinity. Time at full strength. Default infinity: until the motor is removed.
    float hold = std::numeric_limits<float>::infinity();
    /// [s] 0 to 1e9, default 0. Time in which it falls, after the hold.
    float decay = 0.0f;
    /// [s] 0 to 1e9, default 0. Time before it begins to rise, in which the motor rests: gusts that are added together come one
    /// by one.
    float delay = 0.0f;

    static constexpr auto settings() {
        return std::tuple{
            Setting("attack", &Envelope::attack, k_time_range, "Time in which it rises."),
            Setting("hold", &Envelope::hold, {.min = 0.0, .unit = "s"},
                    "Time at full strength. Default infinity: until the motor is removed."),
            Setting("decay", &Envelope::decay, k_time_range, "Time in which it falls, after the hold."),
            Setting("delay", &Envelope::delay, k_time_range,
                    "Time before it begins to rise, in which the motor rests: gusts that are added together come one by one."),
        };
    }

    /// Mean strength between two ages [s], 0 to 1.
    [[nodiscard]] double mean(double from, double to) const;
    /// [s] Age at which it has ended.
    [[nodiscard]] double end() const;
};

namespace detail {
class Reasons;
struct FieldPath;
} // namespace detail
/// Rejects an envelope that lasts no time.
WINDROW_API void check_rules(detail::Reasons& reasons, const detail::FieldPath& path, const Envelope& envelope);

// --- Turbulence ------------------------------------------------------------------------------------------------------

/// Turbulence of the air that a motor moves. Without it a jet stays straight for ten diameters and does not roll up and spread.
/// The law's velocity (or acceleration) becomes
///   U + 2.8 w intensity |U| n((x - x_motor - 0.7 U t) / s),
/// n the gust tile (gust_tile.h) of standard deviation 1, w the region's weight, U the law's own, t the motor's age at the middle
/// of the step. 0.7 is about the speed at which eddies travel in the shear layer of a round jet; 2.8 makes up for the weight:
/// what leaves a jet of 5 cells a radius has the intensity asked for. For a force, U is the speed that it gives air over a
/// radius. A body's wake takes eddies that rest in the world, without w.
struct Turbulence {
    /// 0 (none) to 1, default 0.05. Standard deviation over U of a horizontal component of what leaves the region. At 0.05 jets
    /// spread as measured ones do. 0 costs nothing.
    float intensity = 0.05f;
    /// [m] 0 (two radii) to 1e6, default 0. Size of the largest eddies; most are a third of that. 0: two radii of the region (of
    /// a box, two of its smallest half sizes).
    float length = 0.0f;
    /// 0 to 4294967295, default 0. Selects a part of the pattern: motors of the same kind, age and seed have the same eddies.
    std::uint32_t seed = 0;

    static constexpr auto settings() {
        return std::tuple{
            Setting(
                "intensity", &Turbulence::intensity, {.min = 0.0, .max = 1.0, .zero = "none"},
                "Standard deviation over U of a horizontal component of what leaves the region. At 0.05 jets spread as measured "
                "ones do. 0 costs nothing."),
            Setting(
                "length", &Turbulence::length, {0.0, 1e6, "m", "two radii"},
                "Size of the largest eddies; most are a third of that. 0: two radii of the region (of a box, two of its smallest "
                "half sizes)."),
            Setting("seed", &Turbulence::seed, k_seed_range,
                    "Selects a part of the pattern: motors of the same kind, age and seed have the same eddies."),
        };
    }
};

// --- Motors ----------------------------------------------------------------------------------------------------------

/// A fan, a gust, a draught: pushes along one direction within a region.
struct DirectionalMotor {
    static constexpr const char* k_name = "directional";
    static constexpr const char* k_meaning = "A fan, a gust, a draught: pushes along one direction within a region.";
    /// [m] Each component -1e12 to 1e12, default (0, 0, 0). Centre of the region; first end of a cone.
    glm::dvec3 position{0.0};
    /// A finite vector that is not 0, default (1, 0, 0). Any length; normalised on creation.
    glm::vec3 direction{1.0f, 0.0f, 0.0f};
    /// Region in which it acts: fully in the middle, falling smoothly to 0 at the edge.
    Region region = Sphere{};
    /// Law of its action on the air.
    std::variant<Force, Drive> law = Drive{};
    /// Strength over time.
    Envelope envelope{};
    /// Eddies in what it blows.
    Turbulence turbulence{};

    static constexpr auto settings() {
        return std::tuple{
            Setting("position", &DirectionalMotor::position, k_world_range, "Centre of the region; first end of a cone."),
            Setting("direction", &DirectionalMotor::direction, Range::direction(), "Any length; normalised on creation."),
            Setting("region", &DirectionalMotor::region,
                    "Region in which it acts: fully in the middle, falling smoothly to 0 at the edge."),
            Setting("law", &DirectionalMotor::law, "Law of its action on the air."),
            Setting("envelope", &DirectionalMotor::envelope, "Strength over time."),
            Setting("turbulence", &DirectionalMotor::turbulence, "Eddies in what it blows."),
        };
    }
};

/// Wake of a moving body: acts only while it moves, along the path through all positions that `Motors::move` gave since the last
/// step. Several moves between two steps make a curved path.
struct WakeMotor {
    static constexpr const char* k_name = "wake";
    static constexpr const char* k_meaning = "A moving body: acts only while it moves, along its path.";
    /// [m] Each component -1e12 to 1e12, default (0, 0, 0). Start of the path.
    glm::dvec3 position{0.0};
    /// [m] A number above 0, at most 1e6, default 0.5. Radius of the body.
    float radius = 0.5f;
    /// Law of its action on the air.
    std::variant<WakeForce, WakeDrive> law = WakeDrive{};
    /// Strength over time.
    Envelope envelope{};
    /// Eddies in the wake. Default none: a wake makes its own.
    Turbulence turbulence{.intensity = 0.0f};

    static constexpr auto settings() {
        return std::tuple{
            Setting("position", &WakeMotor::position, k_world_range, "Start of the path."),
            Setting("radius", &WakeMotor::radius, k_size_range, "Radius of the body."),
            Setting("law", &WakeMotor::law, "Law of its action on the air."),
            Setting("envelope", &WakeMotor::envelope, "Strength over time."),
            Setting("turbulence", &WakeMotor::turbulence, "Eddies in the wake. Default none: a wake makes its own."),
        };
    }
};

/// A jet from a nozzle: blows along a cone or cylinder whose rays spread from the cone's tip and slow as it widens, so that each
/// section passes the same momentum. `speed` and `acceleration` hold at the nozzle.
struct JetMotor {
    static constexpr const char* k_name = "jet";
    static constexpr const char* k_meaning = "A nozzle: blows along a cone or cylinder.";
    /// [m] Each component -1e12 to 1e12, default (0, 0, 0). The nozzle.
    glm::dvec3 position{0.0};
    /// A finite vector that is not 0, default (1, 0, 0). Any length; normalised on creation.
    glm::vec3 direction{1.0f, 0.0f, 0.0f};
    /// [m] A number above 0, at most 1e6, default 6. Length over which it pushes. The air carries the jet on beyond it.
    float length = 6.0f;
    /// [m] A number above 0, at most 1e6, default 0.5. Radius at the nozzle.
    float start_radius = 0.5f;
    /// [m] A number above 0, at most 1e6, default 1.5. Radius at the end; equal to start_radius: a cylinder.
    float end_radius = 1.5f;
    /// Law of its action on the air, at the nozzle.
    std::variant<Force, Drive> law = Drive{.speed = 12.0f, .rate = 8.0f};
    /// Strength over time.
    Envelope envelope{};
    /// Eddies in the jet: they make it roll up and spread.
    Turbulence turbulence{};

    static constexpr auto settings() {
        return std::tuple{
            Setting("position", &JetMotor::position, k_world_range, "The nozzle."),
            Setting("direction", &JetMotor::direction, Range::direction(), "Any length; normalised on creation."),
            Setting("length", &JetMotor::length, k_size_range,
                    "Length over which it pushes. The air carries the jet on beyond it."),
            Setting("start_radius", &JetMotor::start_radius, k_size_range, "Radius at the nozzle."),
            Setting("end_radius", &JetMotor::end_radius, k_size_range, "Radius at the end; equal to start_radius: a cylinder."),
            Setting("law", &JetMotor::law, "Law of its action on the air, at the nozzle."),
            Setting("envelope", &JetMotor::envelope, "Strength over time."),
            Setting("turbulence", &JetMotor::turbulence, "Eddies in the jet: they make it roll up and spread."),
        };
    }
};

/// A vortex: turns the air right-handed about an axis, fastest at 0.447 of the radius. A negative speed or acceleration turns it
/// the other way. The circulation is within 5 % where the fastest ring, at 0.447 of the radius, is 3.5 cells or wider.
struct VortexMotor {
    static constexpr const char* k_name = "vortex";
    static constexpr const char* k_meaning = "Turns the air right-handed about an axis.";
    /// [m] Each component -1e12 to 1e12, default (0, 0, 0). The middle.
    glm::dvec3 position{0.0};
    /// A finite vector that is not 0, default (0, 1, 0). Any length; normalised on creation.
    glm::vec3 axis{0.0f, 1.0f, 0.0f};
    /// [m] A number above 0, at most 1e6, default 4. Distance from the axis beyond which nothing acts.
    float radius = 4.0f;
    /// [m] A number above 0, at most 1e6, default 4. Along the axis, from the middle to each end.
    float half_length = 4.0f;
    /// -10 to 10, default 0. Speed along the axis in the middle over the swirl. A dust devil has about 0.5.
    float lift = 0.0f;
    /// Law of its action on the air, where it is fastest.
    std::variant<Force, Drive> law = Drive{.speed = 8.0f, .rate = 8.0f};
    /// Strength over time.
    Envelope envelope{};

    static constexpr auto settings() {
        return std::tuple{
            Setting("position", &VortexMotor::position, k_world_range, "The middle."),
            Setting("axis", &VortexMotor::axis, Range::direction(), "Any length; normalised on creation."),
            Setting("radius", &VortexMotor::radius, k_size_range, "Distance from the axis beyond which nothing acts."),
            Setting("half_length", &VortexMotor::half_length, k_size_range, "Along the axis, from the middle to each end."),
            Setting("lift", &VortexMotor::lift, {-10.0, 10.0},
                    "Speed along the axis in the middle over the swirl. A dust devil has about 0.5."),
            Setting("law", &VortexMotor::law, "Law of its action on the air, where it is fastest."),
            Setting("envelope", &VortexMotor::envelope, "Strength over time."),
        };
    }
};

/// Volume source in a ball (a blast, a vent), or sink (suction). In incompressible air a radial force is a pure gradient, which
/// the pressure cancels; only a volume source can blow outward. In free air, a box with an open boundary on every axis, the speed
/// is `speed` at the ball's radius and falls as 1/distance^2 beyond, with walls as mirrors. There a source outside of the box
/// acts in it too.
struct OmniMotor {
    static constexpr const char* k_name = "omni";
    static constexpr const char* k_meaning = "Air that comes out of a ball or vanishes in it.";
    /// [m] Each component -1e12 to 1e12, default (0, 0, 0). Centre of the ball.
    glm::dvec3 position{0.0};
    /// [m] A number above 0, at most 1e6, default 2. Radius of the ball.
    float radius = 2.0f;
    /// [m/s] -10000 to 10000, default 5. Outward speed at the radius; negative draws in.
    float speed = 5.0f;
    /// Strength over time.
    Envelope envelope{};

    static constexpr auto settings() {
        return std::tuple{
            Setting("position", &OmniMotor::position, k_world_range, "Centre of the ball."),
            Setting("radius", &OmniMotor::radius, k_size_range, "Radius of the ball."),
            Setting("speed", &OmniMotor::speed, k_speed_range, "Outward speed at the radius; negative draws in."),
            Setting("envelope", &OmniMotor::envelope, "Strength over time."),
        };
    }
};

/// A pressure burst: outflow, then inflow, as behind a blast wave: (1 - t/T) exp(-t/T) times the initial outflow, whose integral
/// is 0. It begins when it is added, and is removed 12 durations later, when 1e-4 of it is left. Based
/// on: Friedlander 1946, Proceedings of the Royal Society A 186 (the wave's form in time).
struct WINDROW_API PressureMotor {
    static constexpr const char* k_name = "pressure";
    static constexpr const char* k_meaning = "A burst: air is thrown out, then drawn back.";
    /// [m] Each component -1e12 to 1e12, default (0, 0, 0). Centre of the ball.
    glm::dvec3 position{0.0};
    /// [m] A number above 0, at most 1e6, default 2. Radius of the ball.
    float radius = 2.0f;
    /// [m/s] -10000 to 10000, default 20. Outward speed at the radius in the first moment; negative: an implosion.
    float speed = 20.0f;
    /// [s] A number above 0, at most 1e9, default 0.2. T: duration of the outflow before the inflow.
    float duration = 0.2f;

    static constexpr auto settings() {
        return std::tuple{
            Setting("position", &PressureMotor::position, k_world_range, "Centre of the ball."),
            Setting("radius", &PressureMotor::radius, k_size_range, "Radius of the ball."),
            Setting("speed", &PressureMotor::speed, k_speed_range,
                    "Outward speed at the radius in the first moment; negative: an implosion."),
            Setting("duration", &PressureMotor::duration, Range::above(0.0, 1e9, "s"),
                    "T: duration of the outflow before the inflow."),
        };
    }

    /// Mean of the outflow's form between two ages [s].
    [[nodiscard]] double mean(double from, double to) const;
    /// [s] Age at which it has ended.
    [[nodiscard]] double end() const { return 12.0 * static_cast<double>(duration); }
};

using Motor = std::variant<DirectionalMotor, WakeMotor, JetMotor, VortexMotor, OmniMotor, PressureMotor>;

/// All reasons why a motor is invalid, one per line.
[[nodiscard]] WINDROW_API Result<void> validate(const Motor& motor);

/// [m] Position of a motor.
[[nodiscard]] WINDROW_API glm::dvec3 position_of(const Motor& motor);

namespace detail {
[[nodiscard]] WINDROW_API Result<void> validate_motor_position(glm::dvec3 position);
}

} // namespace windrow
