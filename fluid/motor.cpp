#include "fluid/motor.h"

#include "fluid/message.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string_view>

namespace windrow {
namespace {

constexpr double k_farthest = 1e12; // [m] beyond it a double no longer tells millimetres apart
constexpr float k_most_acceleration = 1e6f;
constexpr float k_most_speed = 1e4f;
constexpr float k_most_rate = 1e6f;
constexpr float k_most_wake = 1e4f;
constexpr float k_most_size = 1e6f;
constexpr double k_least_axis = 1e-6; // [m] shorter ones have no direction in float arithmetic
constexpr float k_most_seconds = 1e9f;

template <class Vector>
bool finite(const Vector& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// Refuses NaN too, which fails every comparison.
void require(detail::Reasons& reasons, bool valid, std::string_view field, float value, std::string_view fix) {
    if (!valid)
        reasons.add(field, " is ", value, ": ", fix);
}

void check_position(detail::Reasons& reasons, const glm::dvec3& position) {
    if (!finite(position) || glm::length(position) > k_farthest)
        reasons.add("motor.position is ", position, " m: give finite numbers within 1e12 m of the origin.");
}

void check_direction(detail::Reasons& reasons, std::string_view field, const glm::vec3& direction) {
    if (!finite(direction) || direction == glm::vec3(0.0f))
        reasons.add(field, " is ", direction, ": give a finite vector that is not 0.");
}

void check_length(detail::Reasons& reasons, std::string_view field, float length) {
    require(reasons, length > 0.0f && length <= k_most_size, field, length, "give a length above 0 m, at most 1e6 m.");
}

void check_radius(detail::Reasons& reasons, std::string_view field, float radius) {
    require(reasons, radius > 0.0f && radius <= k_most_size, field, radius, "give a radius above 0 m, at most 1e6 m.");
}

struct RegionCheck {
    detail::Reasons& reasons;
    void operator()(const Sphere& sphere) const { check_radius(reasons, "motor.region.sphere.radius", sphere.radius); }
    void operator()(const Capsule& capsule) const {
        check_radius(reasons, "motor.region.capsule.radius", capsule.radius);
        if (!finite(capsule.half_axis) || glm::length(capsule.half_axis) > k_most_size)
            reasons.add("motor.region.capsule.half_axis is ", capsule.half_axis, " m: give finite numbers, at most 1e6 m long.");
    }
    void operator()(const AlignedBox& box) const {
        for (int axis = 0; axis < 3; ++axis)
            if (!(box.half_size[axis] > 0.0f && box.half_size[axis] <= k_most_size)) {
                reasons.add("motor.region.box.half_size is ", box.half_size, " m: give each axis above 0 m, at most 1e6 m.");
                return;
            }
    }
    void operator()(const Cone& cone) const {
        if (!finite(cone.axis) || !(glm::length(glm::dvec3(cone.axis)) >= k_least_axis) ||
            glm::length(glm::dvec3(cone.axis)) > k_most_size)
            reasons.add("motor.region.cone.axis is ", cone.axis, " m: give finite numbers, 1e-6 to 1e6 m long.");
        check_radius(reasons, "motor.region.cone.start_radius", cone.start_radius);
        check_radius(reasons, "motor.region.cone.end_radius", cone.end_radius);
    }
};

struct LawCheck {
    detail::Reasons& reasons;
    void operator()(const Force& law) const {
        require(reasons, std::abs(law.acceleration) <= k_most_acceleration, "motor.law.force.acceleration", law.acceleration,
                "give at most 1e6 m/s2 in size.");
    }
    void operator()(const Drive& law) const {
        require(reasons, std::abs(law.speed) <= k_most_speed, "motor.law.drive.speed", law.speed,
                "give at most 1e4 m/s in size.");
        require(reasons, law.rate >= 0.0f && law.rate <= k_most_rate, "motor.law.drive.rate", law.rate,
                "give 0 to 1e6 per second.");
    }
    void operator()(const WakeForce& law) const {
        require(reasons, law.strength >= 0.0f && law.strength <= k_most_wake, "motor.law.force.strength", law.strength,
                "give 0 to 1e4 per second.");
    }
    void operator()(const WakeDrive& law) const {
        require(reasons, law.per_metre >= 0.0f && law.per_metre <= k_most_wake, "motor.law.drive.per_metre", law.per_metre,
                "give 0 to 1e4 per metre.");
        require(reasons, law.entrainment >= 0.0f && law.entrainment <= 2.0f, "motor.law.drive.entrainment", law.entrainment,
                "give 0 to 2.");
    }
};

void check_envelope(detail::Reasons& reasons, const Envelope& envelope) {
    require(reasons, envelope.attack >= 0.0f && envelope.attack <= k_most_seconds, "motor.envelope.attack", envelope.attack,
            "give 0 to 1e9 s.");
    require(reasons, envelope.hold >= 0.0f, "motor.envelope.hold", envelope.hold,
            "give 0 s or more; infinity holds until it is removed.");
    require(reasons, envelope.decay >= 0.0f && envelope.decay <= k_most_seconds, "motor.envelope.decay", envelope.decay,
            "give 0 to 1e9 s.");
    if (envelope.attack == 0.0f && envelope.hold == 0.0f && envelope.decay == 0.0f)
        reasons.add("motor.envelope lasts 0 s: give attack, hold or decay a time.");
}

void check_turbulence(detail::Reasons& reasons, const Turbulence& turbulence) {
    require(reasons, turbulence.intensity >= 0.0f && turbulence.intensity <= 1.0f, "motor.turbulence.intensity",
            turbulence.intensity, "give 0 (none) to 1.");
    require(reasons, turbulence.length >= 0.0f && turbulence.length <= k_most_size, "motor.turbulence.length", turbulence.length,
            "give 0 m (two radii) to 1e6 m.");
}

struct MotorCheck {
    detail::Reasons& reasons;
    void operator()(const DirectionalMotor& motor) const {
        check_position(reasons, motor.position);
        check_direction(reasons, "motor.direction", motor.direction);
        std::visit(RegionCheck{reasons}, motor.region);
        std::visit(LawCheck{reasons}, motor.law);
        check_envelope(reasons, motor.envelope);
        check_turbulence(reasons, motor.turbulence);
    }
    void operator()(const WakeMotor& motor) const {
        check_position(reasons, motor.position);
        check_radius(reasons, "motor.radius", motor.radius);
        std::visit(LawCheck{reasons}, motor.law);
        check_envelope(reasons, motor.envelope);
        check_turbulence(reasons, motor.turbulence);
    }
    void operator()(const JetMotor& motor) const {
        check_position(reasons, motor.position);
        check_direction(reasons, "motor.direction", motor.direction);
        check_length(reasons, "motor.length", motor.length);
        check_radius(reasons, "motor.start_radius", motor.start_radius);
        check_radius(reasons, "motor.end_radius", motor.end_radius);
        std::visit(LawCheck{reasons}, motor.law);
        check_envelope(reasons, motor.envelope);
        check_turbulence(reasons, motor.turbulence);
    }
    void operator()(const VortexMotor& motor) const {
        check_position(reasons, motor.position);
        check_direction(reasons, "motor.axis", motor.axis);
        check_radius(reasons, "motor.radius", motor.radius);
        check_length(reasons, "motor.half_length", motor.half_length);
        require(reasons, std::abs(motor.lift) <= 10.0f, "motor.lift", motor.lift, "give -10 to 10.");
        std::visit(LawCheck{reasons}, motor.law);
        check_envelope(reasons, motor.envelope);
    }
    void operator()(const OmniMotor& motor) const {
        check_position(reasons, motor.position);
        check_radius(reasons, "motor.radius", motor.radius);
        require(reasons, std::abs(motor.speed) <= k_most_speed, "motor.speed", motor.speed, "give at most 1e4 m/s in size.");
        check_envelope(reasons, motor.envelope);
    }
    void operator()(const PressureMotor& motor) const {
        check_position(reasons, motor.position);
        check_radius(reasons, "motor.radius", motor.radius);
        require(reasons, std::abs(motor.speed) <= k_most_speed, "motor.speed", motor.speed, "give at most 1e4 m/s in size.");
        require(reasons, motor.duration > 0.0f && motor.duration <= k_most_seconds, "motor.duration", motor.duration,
                "give a time above 0 s, at most 1e9 s.");
    }
};

// Integral of 3 s^2 - 2 s^3 over s from 0 to `part`, which is held to 0..1: 1/2 of the whole rise.
double rise_integral(double part) {
    const double s = std::clamp(part, 0.0, 1.0);
    return s * s * s * (1.0 - 0.5 * s);
}

} // namespace

double Envelope::end() const {
    return static_cast<double>(attack) + static_cast<double>(hold) + static_cast<double>(decay);
}

// The three parts of the time between two ages, each integrated in closed form.
double Envelope::mean(double from, double to) const {
    const double rise = attack, held = rise + static_cast<double>(hold), fall = decay;
    double integral = std::max(0.0, std::min(to, held) - std::max(from, rise));
    if (rise > 0.0)
        integral += rise * (rise_integral(to / rise) - rise_integral(from / rise));
    if (fall > 0.0 && to > held) // the fall is the rise seen from its end
        integral += fall * (rise_integral(1.0 - (from - held) / fall) - rise_integral(1.0 - (to - held) / fall));
    return to > from ? integral / (to - from) : 0.0;
}

// Integral of (1 - s) exp(-s) is s exp(-s).
double PressureMotor::mean(double from, double to) const {
    const double T = duration;
    const auto outflow = [&](double age) { return age < end() ? age * std::exp(-age / T) : 0.0; };
    return to > from ? (outflow(to) - outflow(from)) / (to - from) : 0.0;
}

Result<void> validate(const Motor& motor) {
    detail::Reasons reasons;
    std::visit(MotorCheck{reasons}, motor);
    if (!reasons.empty())
        return Error{reasons.take()};
    return {};
}

Result<void> detail::validate_motor_position(glm::dvec3 position) {
    Reasons reasons;
    check_position(reasons, position);
    if (!reasons.empty())
        return Error{reasons.take()};
    return {};
}

glm::dvec3 position_of(const Motor& motor) {
    return std::visit([](const auto& kind) { return kind.position; }, motor);
}

} // namespace windrow
