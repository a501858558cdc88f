#include "vegetation/render/scene.h"

#include "fluid/core/validation.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace windrow::vegetation::render {

using windrow::detail::FieldPath, windrow::detail::Figure, windrow::detail::Reasons, windrow::detail::validate_settings;

double Ground::height(double x, double z) const {
    return corner.y + static_cast<double>(heights.drawn_height(glm::vec2(x - corner.x, z - corner.z)));
}

windrow::Result<void> validate(const Camera& camera) {
    return validate_settings(camera, "camera");
}
windrow::Result<void> validate(const Sun& sun) {
    return validate_settings(sun, "sun");
}
windrow::Result<void> validate(const Fog& fog) {
    return validate_settings(fog, "fog");
}
windrow::Result<void> validate(const Clouds& clouds) {
    return validate_settings(clouds, "clouds");
}
windrow::Result<void> validate(const PlantLook& look) {
    return validate_settings(look, "look");
}

void check_rules(Reasons& reasons, const FieldPath& path, const Camera& camera) {
    const double near = static_cast<double>(camera.near), far = static_cast<double>(camera.far);
    if (near > 0.0 && !(far >= 1.01 * near && far <= 1e6 * near))
        reasons.add(FieldPath{&path, "far"}, " is ", camera.far, " m: give 1.01 to 1e6 times near, ", Figure{1.01 * near}, " to ",
                    Figure{1e6 * near}, " m.");
    const glm::dvec3 sight = camera.target - camera.position;
    const double level = glm::length(glm::dvec2(sight.x, sight.z));
    if (!(level > 1e-3 * glm::length(sight)) || !(level > 0.0))
        reasons.add(FieldPath{&path, "target"}, " is straight above, below or at ", FieldPath{&path, "position"},
                    ": move it aside, so that the picture has an up direction.");
}

void check_rules(Reasons& reasons, const FieldPath& path, const PlantLook& look) {
    const glm::vec3 through =
        (1.0f + 0.1f * look.against_light) * glm::max(look.through, 0.3f * look.through + 0.7f * look.dry); // fresh, and dry
    const glm::vec3 leaf = glm::max(glm::max(look.root, look.tip), glm::max(look.dry, look.second)) + through;
    const glm::vec3 brightest = glm::max(leaf, look.head * (1.3f + 0.03f * look.against_light)); // field_blade.vert
    const float most = std::max({brightest.r, brightest.g, brightest.b});
    if (!(most >= 0.0f && most <= 0.6f))
        reasons.add(path, " has a brightest colour that makes ", most,
                    " with (1 + against_light / 10) times what shines through it: give at most 0.6, by darker colours.");
}

windrow::Result<void> validate(const Ground& ground) {
    Reasons reasons; // the heights were judged when they were made
    windrow::detail::check_value(reasons, {nullptr, "ground.corner"}, ground.corner, k_place_range);
    if (ground.grown && glm::length(ground.grown->extent() - ground.heights.extent()) > 1e-3f * ground.heights.grid().spacing.x)
        reasons.add("ground.grown has another extent than ground.heights: give it ground.heights.extent().");
    return reasons.outcome();
}

windrow::Result<void> validate(const Scene& scene) {
    Reasons reasons;
    for (const windrow::Result<void>& judged :
         {validate(scene.camera), validate(scene.sun), validate(scene.fog), validate(scene.clouds), validate(scene.ground),
          windrow::validate(scene.plants), validate(scene.look), windrow::validate(scene.wind.wind),
          windrow::validate(scene.wind.sampling)})
        reasons.add_all_of(judged);
    for (const windrow::Motor& motor : scene.wind.motors)
        reasons.add_all_of(windrow::validate(motor));
    return reasons.outcome();
}

} // namespace windrow::vegetation::render
