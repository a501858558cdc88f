#include "fluid/ambient.h"

#include "fluid/ambient_numerics.h"
#include "fluid/validation.h"
#include "fluid/window.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <string_view>

namespace windrow {
namespace {

bool finite(const glm::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// Exact: fmod rounds nothing, so a place a whole number of periods away gives the same bits.
double wrapped(double value, double period) {
    const double rest = std::fmod(value, period);
    return rest < 0.0 ? rest + period : rest;
}

// Replaces each field that validate() rejects by its default: a NaN would spread through the shaders.
Sampling usable(Sampling sampling) {
    for_each_setting(sampling, [](const auto& field, float& value) {
        if (!field.range.holds(value))
            value = Sampling{}.*field.member;
    });
    return sampling;
}

// One field of AmbientWind::Settings, passed alone.
template <class Value>
Result<void> validate_alone(const char* name, const Value& value, const Range& range) {
    detail::Reasons reasons;
    check_value(reasons, detail::FieldPath{nullptr, name}, value, range);
    return reasons.outcome();
}

numerics::TileView view(const std::shared_ptr<const GustTile>& tile) {
    return {tile ? tile->texels().data() : nullptr};
}

numerics::WindrowAmbient shared(const AmbientBlock& block) {
    static_assert(sizeof(numerics::WindrowAmbient) == sizeof(AmbientBlock));
    return std::bit_cast<numerics::WindrowAmbient>(block);
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
        return Error{valid.error()};
    AmbientWind wind(settings);
    if (settings.gusts.intensity > 0.0f && settings.gusts.tile == nullptr)
        wind.settings_.gusts.tile = GustTile::bake(settings.gusts.seed);
    if (settings.gusts.intensity > 0.0f && !wind.tile())
        return detail::out_of_memory();
    return wind;
}

// The anchor is the point itself. The place in the tile is computed in double and the shared text adds 0 to it.
glm::vec3 AmbientWind::velocity(glm::dvec3 position) const {
    if (uniform() || !finite(position))
        return settings_.mean;
    return numerics::windrow_ambient(view(tile()), shared(block(position)), glm::vec3(0.0f));
}

glm::vec3 AmbientWind::felt(glm::vec3 velocity, glm::dvec3 position, const Sampling& asked) const {
    const Sampling sampling = usable(asked);
    if (!(sampling.detail > 0.0f) || !finite(position))
        return numerics::windrow_limited(velocity, sampling.strength, sampling.limit);
    return numerics::windrow_felt(view(tile()), shared(block(position, sampling)), velocity, glm::vec3(0.0f));
}

AmbientBlock AmbientWind::block(glm::dvec3 anchor, const Sampling& asked) const {
    const Sampling sampling = usable(asked);
    anchor = detail::usable_anchor(anchor);
    AmbientBlock block;
    block.mean = settings_.mean;
    block.gust_strength = gust_strength();
    if (settings_.profile) {
        block.roughness_length = settings_.profile->roughness_length;
        block.reference_height = settings_.profile->reference_height;
    }
    block.anchor_height = static_cast<float>(std::clamp(anchor.y - settings_.ground, k_world_range.min, k_world_range.max));
    block.felt_strength = sampling.strength;
    block.gust_texels = static_cast<float>(1.0 / texel());
    block.longest_gust = tile() ? tile()->bound() : 1.0f;
    block.gust_axes = gust_axes_;
    block.felt_limit = sampling.limit;
    // A whole number of tiles of detail fits the gusts' tile, so the wrapped phase of the one is also a phase of the other.
    const double fit = std::round(static_cast<double>(settings_.gusts.length) / static_cast<double>(sampling.detail_length));
    const int repeats = fit >= 1.0 ? static_cast<int>(std::min(fit, 1e9)) : 1; // NaN too
    block.detail_texels = static_cast<float>(repeats / texel());
    block.detail_amount = tile() ? sampling.detail : 0.0f;
    for (int axis = 0; axis < 3; ++axis) {
        const TilePlace gust = gusting() ? gust_place(axis, anchor[axis]) : TilePlace{};
        block.gust_texel[axis] = static_cast<float>(gust.texel);
        block.gust_fraction[axis] = gust.fraction;
        const TilePlace ripple = block.detail_amount > 0.0f ? place(axis, anchor[axis], repeats) : TilePlace{};
        block.detail_texel[axis] = static_cast<float>(ripple.texel);
        block.detail_fraction[axis] = ripple.fraction;
    }
    return block;
}

// The coordinate is wrapped before the phase is subtracted, so the difference keeps its digits. Repeating detail is wrapped at
// the gusts' period: places a whole number of tiles apart have the same detail to the bit.
AmbientWind::TilePlace AmbientWind::place(int axis, double coordinate, int repeats) const {
    const int texels = axis == 1 ? 2 * GustTile::k_height : GustTile::k_side;
    const double origin = axis == 1 ? settings_.ground : 0.0;
    const double along = wrapped(coordinate - origin, texels * texel()) - phase_[axis];
    const double in_texels = wrapped(along / texel() * repeats, texels) - 0.5;
    const double whole = std::floor(in_texels);
    return {std::min(static_cast<int>(whole), texels - 1), static_cast<float>(in_texels - whole)};
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
