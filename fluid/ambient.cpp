#include "fluid/ambient.h"

#include "fluid/core/ambient_numerics.h"
#include "fluid/core/validation.h"
#include "fluid/window.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <string_view>

namespace windrow {
namespace {

// Exact: fmod rounds nothing, so a place a whole number of periods away gives the same bits.
double wrapped(double value, double period) {
    const double rest = std::fmod(value, period);
    return rest < 0.0 ? rest + period : rest;
}

// One field of AmbientWind::Settings, passed alone.
template <class Value>
Result<void> validate_alone(const char* name, const Value& value, const Range& range) {
    detail::Reasons reasons;
    check_value(reasons, detail::FieldPath{nullptr, name}, value, range);
    return reasons.outcome();
}

} // namespace

Result<void> validate(const LogProfile& profile) {
    return detail::validate_settings(profile, "profile");
}
Result<void> validate(const Gusts& gusts) {
    return detail::validate_settings(gusts, "gusts");
}
Result<void> validate(const Sampling& sampling) {
    return detail::validate_settings(sampling, "sampling");
}

glm::vec3 UniformGust::velocity(double time) const {
    if (!(period > 0.0f) || !std::isfinite(time))
        return mean * direction;
    const double reduced = wrapped(time, static_cast<double>(period));
    return numerics::windrow_uniform_gust(static_cast<float>(reduced), mean, amplitude, period) * direction;
}

Result<AmbientWind> AmbientWind::create(const Settings& settings) {
    if (auto valid = detail::validate_settings(settings); !valid)
        return valid.failure();
    AmbientWind wind(settings);
    if (settings.gusts.intensity > 0.0f && settings.gusts.tile == nullptr)
        wind.settings_.gusts.tile = GustTile::bake(settings.gusts.seed);
    if (settings.gusts.intensity > 0.0f && !wind.tile())
        return detail::out_of_memory();
    return wind;
}

AmbientWind AmbientWind::without_gusts() const {
    AmbientWind calm = *this;
    calm.settings_.gusts.intensity = 0.0f;
    return calm;
}

void AmbientWind::advance(double dt) {
    if (std::isfinite(dt))
        set_phase(phase_ + glm::dvec3(settings_.mean.x, 0.0, settings_.mean.z) * dt);
}

Result<void> AmbientWind::set_mean(glm::vec3 mean) {
    auto valid = validate_alone("mean", mean, k_speed_range);
    if (valid)
        settings_.mean = mean;
    return valid;
}

Result<void> AmbientWind::set_ground(double height) {
    auto valid = validate_alone("ground", height, k_world_range);
    if (valid)
        settings_.ground = height;
    return valid;
}

void AmbientWind::set_phase(glm::dvec3 phase) {
    for (int axis = 0; axis < 3; ++axis)
        phase_[axis] = std::isfinite(phase[axis]) ? wrapped(phase[axis], period()) : 0.0;
}

double AmbientWind::period() const {
    return GustTile::k_side * texel();
}

glm::dvec3 AmbientWind::between(glm::dvec3 a, glm::dvec3 b, double factor, double period) {
    glm::dvec3 phase;
    for (int axis = 0; axis < 3; ++axis) {
        const double way = std::remainder(b[axis] - a[axis], period); // within half a period
        phase[axis] = wrapped(a[axis] + factor * way, period);
    }
    return phase;
}

float AmbientWind::gust_strength() const {
    const glm::vec3 mean = settings_.mean;
    return settings_.gusts.intensity * std::sqrt(mean.x * mean.x + mean.z * mean.z);
}

float AmbientWind::profile_at(double height) const {
    if (!settings_.profile)
        return 1.0f;
    return numerics::windrow_profile(
        static_cast<float>(std::clamp(height - settings_.ground, k_world_range.min, k_world_range.max)),
        settings_.profile->roughness_length, settings_.profile->reference_height);
}

} // namespace windrow
