#include "cli/drawing/motor_style.h"

#include "cli/drawing/text.h"

#include <glm/geometric.hpp>

namespace windrow::cli {
namespace {

/// Of any length but 0; 0 stays 0.
glm::vec3 unit(glm::vec3 direction) {
    const float length = glm::length(direction);
    return length > 0.0f ? direction / length : glm::vec3(0.0f);
}

struct RegionOf {
    PlacedRegion operator()(const DirectionalMotor& motor) const { return {motor.region, motor.position}; }
    PlacedRegion operator()(const JetMotor& motor) const {
        return {Cone{motor.length * unit(motor.direction), motor.start_radius, motor.end_radius}, motor.position};
    }
    PlacedRegion operator()(const VortexMotor& motor) const {
        const glm::vec3 half = motor.half_length * unit(motor.axis);
        return {Cone{2.0f * half, motor.radius, motor.radius}, motor.position - glm::dvec3(half)};
    }
    PlacedRegion operator()(const auto& ball) const { return {Sphere{ball.radius}, ball.position}; }
};

std::string text_of(const std::variant<Force, Drive>& law) {
    if (const auto* drive = std::get_if<Drive>(&law))
        return brief(drive->speed) + " m/s";
    return brief(std::get<Force>(law).acceleration) + " m/s\xc2\xb2";
}

struct StrengthText {
    std::string operator()(const WakeMotor& /*its speed is its path's*/) const { return {}; }
    std::string operator()(const OmniMotor& motor) const { return brief(motor.speed) + " m/s"; }
    std::string operator()(const PressureMotor& motor) const { return brief(motor.speed) + " m/s"; }
    std::string operator()(const auto& motor) const { return text_of(motor.law); }
};

} // namespace

PlacedRegion region_of(const Motor& motor) {
    return std::visit(RegionOf{}, motor);
}

std::string strength_text(const Motor& motor) {
    return std::visit(StrengthText{}, motor);
}

} // namespace windrow::cli
