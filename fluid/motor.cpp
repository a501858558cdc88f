#include "fluid/motor.h"

#include "fluid/core/validation.h"
#include "fluid/portable_math.h"

#include <algorithm>

namespace windrow {
namespace {

// Integral of 3 s^2 - 2 s^3 over s from 0 to `part`, clamped to 0..1: 1/2 for the whole rise.
double rise_integral(double part) {
    const double s = std::clamp(part, 0.0, 1.0);
    return s * s * s * (1.0 - 0.5 * s);
}

} // namespace

double Envelope::end() const {
    return static_cast<double>(delay) + static_cast<double>(attack) + static_cast<double>(hold) + static_cast<double>(decay);
}

// The three parts of the time between two ages, each integrated in closed form.
double Envelope::mean(double from, double to) const {
    from -= static_cast<double>(delay);
    to -= static_cast<double>(delay);
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
    const auto outflow = [&](double age) { return age < end() ? age * numerics::exp(-age / T) : 0.0; };
    return to > from ? (outflow(to) - outflow(from)) / (to - from) : 0.0;
}

void check_rules(detail::Reasons& reasons, const detail::FieldPath& path, const Envelope& envelope) {
    if (envelope.attack == 0.0f && envelope.hold == 0.0f && envelope.decay == 0.0f)
        reasons.add(path, " lasts 0 s: set attack, hold or decay above 0.");
}

Result<void> validate(const Motor& motor) {
    return std::visit([](const auto& kind) { return detail::validate_settings(kind, "motor"); }, motor);
}

Result<void> detail::validate_motor_position(glm::dvec3 position) {
    Reasons reasons;
    const FieldPath motor{nullptr, "motor"};
    check_value(reasons, FieldPath{&motor, "position"}, position, k_world_range);
    return reasons.outcome();
}

glm::dvec3 position_of(const Motor& motor) {
    return std::visit([](const auto& kind) { return kind.position; }, motor);
}

} // namespace windrow
