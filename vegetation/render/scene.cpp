#include "vegetation/render/scene.h"

#include "vegetation/render/refusals.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace windrow::vegetation::render {
namespace {

constexpr double k_farthest = 1e9; // [m] beyond which a double has less than a micrometre

void colour(Refusals& refusals, const char* field, glm::vec3 value) {
    for (int channel = 0; channel < 3; ++channel)
        refusals.range((std::string(field) + "." + "rgb"[channel]).c_str(), static_cast<double>(value[channel]), 0.0, 1.0);
}

void place(Refusals& refusals, const char* field, glm::dvec3 value) {
    for (int axis = 0; axis < 3; ++axis)
        refusals.range((std::string(field) + "." + "xyz"[axis]).c_str(), value[axis], -k_farthest, k_farthest);
}

} // namespace

double Ground::height(double x, double z) const {
    return corner.y + static_cast<double>(heights.drawn_height(glm::vec2(x - corner.x, z - corner.z)));
}

windrow::Result<void> validate(const Camera& camera) {
    Refusals refusals;
    place(refusals, "camera.position", camera.position);
    place(refusals, "camera.target", camera.target);
    refusals.range("camera.view_deg", static_cast<double>(camera.view_deg), 1.0, 150.0);
    refusals.range("camera.near", static_cast<double>(camera.near), 1e-3, 1e3);
    refusals.range("camera.far", static_cast<double>(camera.far), 1.01 * static_cast<double>(camera.near),
                   1e6 * static_cast<double>(camera.near));
    refusals.range("camera.exposure", static_cast<double>(camera.exposure), 1e-6, 1e6);
    const glm::dvec3 sight = camera.target - camera.position;
    const double level = glm::length(glm::dvec2(sight.x, sight.z));
    if (!(level > 1e-3 * glm::length(sight)) || !(level > 0.0))
        refusals.add("camera.target lies straight above, below or at camera.position; move it aside, so that up has a meaning.");
    return refusals.result();
}

windrow::Result<void> validate(const Sun& sun) {
    Refusals refusals;
    refusals.range("sun.elevation_deg", static_cast<double>(sun.elevation_deg), 1.0, 90.0);
    refusals.range("sun.azimuth_deg", static_cast<double>(sun.azimuth_deg), -360.0, 360.0);
    refusals.range("sun.irradiance", static_cast<double>(sun.irradiance), 1e-6, 100.0);
    refusals.range("sun.haze", static_cast<double>(sun.haze), 0.0, 0.5);
    refusals.range("sun.radius_deg", static_cast<double>(sun.radius_deg), 0.05, 5.0);
    return refusals.result();
}

windrow::Result<void> validate(const Fog& fog) {
    Refusals refusals;
    refusals.range("fog.density", static_cast<double>(fog.density), 0.0, 1.0);
    refusals.range("fog.fall", static_cast<double>(fog.fall), 0.0, 1.0);
    refusals.range("fog.base", fog.base, -k_farthest, k_farthest);
    return refusals.result();
}

windrow::Result<void> validate(const Clouds& clouds) {
    Refusals refusals;
    refusals.range("clouds.cover", static_cast<double>(clouds.cover), 0.0, 1.0);
    refusals.range("clouds.height", clouds.height, -k_farthest, k_farthest);
    refusals.range("clouds.size", static_cast<double>(clouds.size), 1.0, 1e5);
    refusals.range("clouds.depth", static_cast<double>(clouds.depth), 0.0, 100.0);
    refusals.range("clouds.drift.x", static_cast<double>(clouds.drift.x), -200.0, 200.0);
    refusals.range("clouds.drift.z", static_cast<double>(clouds.drift.y), -200.0, 200.0);
    return refusals.result();
}

windrow::Result<void> validate(const Ground& ground) {
    Refusals refusals; // the heights were judged when they were made
    place(refusals, "ground.corner", ground.corner);
    if (ground.grown && glm::length(ground.grown->extent() - ground.heights.extent()) > 1e-3f * ground.heights.grid().spacing.x)
        refusals.add("ground.grown has another extent than ground.heights; give it ground.heights.extent().");
    return refusals.result();
}

windrow::Result<void> validate(const PlantLook& look) {
    Refusals refusals;
    colour(refusals, "look.root", look.root);
    colour(refusals, "look.tip", look.tip);
    colour(refusals, "look.dry", look.dry);
    colour(refusals, "look.through", look.through);
    const glm::vec3 through = (1.0f + 0.1f * look.against_light) *
                              glm::max(look.through, 0.3f * look.through + 0.7f * look.dry); // as plant.frag mixes them
    colour(refusals, "look.second", look.second);
    colour(refusals, "look.head", look.head);
    colour(refusals, "look.soil", look.soil);
    const glm::vec3 leaf = glm::max(glm::max(look.root, look.tip), glm::max(look.dry, look.second)) + through;
    const glm::vec3 brightest = glm::max(leaf, look.head * (1.3f + 0.03f * look.against_light)); // field_blade.vert
    refusals.range("look's brightest colour and (1 + against_light / 10) times what shines through it, together",
                   static_cast<double>(std::max({brightest.r, brightest.g, brightest.b})), 0.0, 0.6);
    refusals.range("look.variation", static_cast<double>(look.variation), 0.0, 0.9);
    refusals.range("look.root_light", static_cast<double>(look.root_light), 0.0, 1.0);
    refusals.range("look.gloss", static_cast<double>(look.gloss), 1.0, 1000.0);
    refusals.range("look.against_light", static_cast<double>(look.against_light), 0.0, 20.0);
    refusals.range("look.dryness", static_cast<double>(look.dryness), 0.0, 1.0);
    refusals.range("look.fold", static_cast<double>(look.fold), 0.0, 1.2);
    refusals.range("look.midrib", static_cast<double>(look.midrib), 0.0, 1.0);
    refusals.range("look.soften", static_cast<double>(look.soften), 0.0, 1.0);
    refusals.range("look.self_shade", static_cast<double>(look.self_shade), 0.0, 5.0);
    refusals.range("look.head_from", static_cast<double>(look.head_from), 0.3, 1.0);
    refusals.range("look.head_width", static_cast<double>(look.head_width), 0.0, 0.5);
    refusals.range("look.even_from", static_cast<double>(look.even_from), 1e-3, 1e6);
    return refusals.result();
}

windrow::Result<void> validate(const Scene& scene) {
    Refusals refusals;
    refusals.add(validate(scene.camera));
    refusals.add(validate(scene.sun));
    refusals.add(validate(scene.fog));
    refusals.add(validate(scene.clouds));
    refusals.add(validate(scene.ground));
    refusals.add(windrow::validate(scene.plants));
    refusals.add(validate(scene.look));
    refusals.add(windrow::validate(scene.wind.wind));
    refusals.add(windrow::validate(scene.wind.sampling));
    for (const windrow::Motor& motor : scene.wind.motors)
        refusals.add(windrow::validate(motor));
    return refusals.result();
}

} // namespace windrow::vegetation::render
