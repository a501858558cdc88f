// Where blades grow in a fan before the eye.
//
// Share q of the blades lies within distance r: density falls as r^-e on the ground, so q(r) = (r^(2-e) - near^(2-e)) /
// (far^(2-e) - near^(2-e)). Distances are stratified, one a blade; directions are by chance.
#include "coupling/plant_vertex.h"
#include "fluid/validation.h"
#include "vegetation/render/blades.h"
#include "vegetation/render/place_numerics.h"

#include <algorithm>
#include <cmath>

namespace windrow::vegetation::render {

windrow::Result<std::vector<BladePlace>> scatter(const BladeFan& fan, const Ground& ground, glm::dvec3 anchor) {
    windrow::detail::Reasons reasons;
    windrow::detail::check_settings(reasons, {nullptr, "fan"}, fan);
    if (fan.far < 1.001f * fan.near)
        reasons.add("fan.far is ", fan.far, " m: give 1.001 times fan.near or more, which is ", fan.near, " m.");
    reasons.add_all_of(validate(Camera{.position = fan.eye, .target = fan.target}));
    reasons.add_all_of(validate(ground));
    if (!reasons.empty())
        return windrow::Error{reasons.take()};

    const glm::dvec3 sight = fan.target - fan.eye;
    const double ahead = std::atan2(sight.z, sight.x);
    const double power = 2.0 - static_cast<double>(fan.exponent);
    const double low = std::pow(static_cast<double>(fan.near), power), high = std::pow(static_cast<double>(fan.far), power);
    std::vector<BladePlace> places;
    places.reserve(static_cast<std::size_t>(fan.count));
    for (int n = 0; n < fan.count; ++n) {
        const auto chance = [&](int which) { return static_cast<double>(numerics::windrow_place_chance({n, which})); };
        const double share = (n + chance(0)) / fan.count;
        const double distance = std::pow(low + (high - low) * share, 1.0 / power);
        const double angle = ahead + static_cast<double>(fan.half_angle) * (2.0 * chance(1) - 1.0);
        const double x = fan.eye.x + distance * std::cos(angle), z = fan.eye.z + distance * std::sin(angle);
        const double y = ground.height(x, z);
        const glm::dvec2 from_corner(x - ground.corner.x, z - ground.corner.z);
        BladePlace place;
        place.root = glm::vec3(glm::dvec3(x, y, z) - anchor);
        // Tufts: some places grow higher than others.
        place.size =
            0.72f + 0.55f * numerics::windrow_place_noise(from_corner / 1.7) + 0.25f * static_cast<float>(chance(2) * chance(2));
        const float end = std::clamp(3.0f * (1.0f - static_cast<float>(distance) / fan.far), 0.0f, 1.0f);
        place.size *= 0.25f + 0.75f * end;
        const windrow::PlantKey key = windrow::place_key(static_cast<float>(x), static_cast<float>(z));
        place.key = {key.x, key.y};
        place.dryness = numerics::windrow_dryness(from_corner);
        place.width_factor = std::max(1.0f, static_cast<float>(distance) / fan.wide_from);
        places.push_back(place);
    }
    return places;
}

} // namespace windrow::vegetation::render
