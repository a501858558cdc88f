#include "coupling/blade.h"

#include "coupling/blade_numerics.h"
#include "fluid/core/validation.h"

namespace windrow {

using detail::k_up;
using detail::shared;

Result<void> validate(const BladeSettings& settings) {
    return detail::validate_settings(settings, "blades");
}

Result<Blades> Blades::create(const BladeSettings& settings) {
    if (auto valid = validate(settings); !valid)
        return valid.failure();
    return Blades(settings);
}

Blades::Blades(const BladeSettings& settings) : settings_(settings) {
    block_.size = {settings.stalk.length, settings.length_spread, 0.5f * settings.width, settings.tip_width};
    block_.form = {settings.taper, settings.along_wind, settings.stiffness_spread, settings.rest_curve};
    block_.own = {settings.rest_bend, settings.rest_bend_spread, settings.view_bend, settings.twist};
    block_.drag = windrow::block(settings.stalk);
}

float Blades::length(PlantKey key) const {
    return numerics::windrow_blade_length(shared(block_), numerics::windrow_plant_hash(key));
}

glm::vec3 Blades::load(PlantKey key, glm::vec3 wind) const {
    return numerics::windrow_blade_load(shared(block_), k_up, numerics::windrow_plant_hash(key), wind);
}

PlantVertex Blades::vertex(PlantKey key, glm::vec3 load, float h, float side, glm::vec3 view) const {
    const numerics::WindrowBlade blade = shared(block_);
    const numerics::WindrowVertex made = numerics::windrow_blade_vertex(
        blade, numerics::windrow_blade_plant(blade, k_up, numerics::windrow_plant_hash(key), load, view), h, side);
    return {made.position, made.normal, made.tangent};
}

} // namespace windrow
