#include "vegetation/program/body.h"

#include "vegetation/program/picture_scene.h"

namespace windrow::vegetation::program {

windrow::Pose pose_of(const PictureScene& scene, const Body& body, double time) {
    const auto* const path = body.motion.path ? &scene.air.paths[*body.motion.path].path : nullptr;
    const auto [position, turn] = windrow::scene::pose_at(body.place, body.motion, path, scene.picture.ground, time);
    return {.position = position, .rotation = {turn.x, turn.y, turn.z, turn.w}, .scale = static_cast<double>(body.place.scale)};
}

fur::CoatSettings settings_of(const BodyCoat& coat, const std::optional<fur::FurLine>& fur) {
    fur::CoatSettings settings = coat.coat;
    if (!fur)
        return settings;
    if (!coat.said.shells)
        settings.layers.shells = fur->shells;
    if (!coat.said.length)
        settings.layers.length = fur->height;
    if (!coat.said.thickness)
        settings.strands.thickness = fur->thickness;
    if (!coat.said.density)
        settings.strands.density = fur->resolution;
    return settings;
}

} // namespace windrow::vegetation::program
