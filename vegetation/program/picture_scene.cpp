#include "vegetation/program/picture_scene.h"

#include "vegetation/render/place_numerics.h"

#include <algorithm>
#include <cmath>

namespace windrow::vegetation::program {

float Hills::at(glm::vec2 place) const {
    const glm::vec2 cell = place / static_cast<float>(length) + 17.3f * static_cast<float>(seed % 64u);
    // Incommensurable steps, so that the octaves' lattices do not meet; each weighs less than it is finer: no slope stands out.
    const float noise = 0.72f * render::numerics::windrow_place_noise(cell) +
                        0.22f * render::numerics::windrow_place_noise(2.7f * cell + 31.0f) +
                        0.06f * render::numerics::windrow_place_noise(7.3f * cell + 77.0f);
    return static_cast<float>(height) * noise;
}

double GroundSource::height(double x, double z) const {
    const double above = heights ? static_cast<double>(heights->drawn_height(glm::vec2(x - corner.x, z - corner.z))) : low;
    return corner.y + above;
}

float Walker::foot_height(double time) const {
    double highest = 0.0;
    for (const Jump& jump : airborne) {
        const double share = std::clamp((time - jump.from) / (jump.until - jump.from), 0.0, 1.0);
        highest = std::max(highest, 4.0 * static_cast<double>(jump.height) * share * (1.0 - share));
    }
    return static_cast<float>(highest);
}

std::int64_t PictureScene::frame_count() const {
    // As Scene::frame_count rounds.
    return static_cast<std::int64_t>(std::floor(air.duration * frames_per_second() * (1.0 + 1e-12) + 1e-9)) + 1;
}

render::Camera camera_at(const PictureScene& scene, double time) {
    const CameraSource& source = scene.picture.camera;
    render::Camera camera = source.lens;
    if (source.path)
        camera.position = scene.air.paths[*source.path].path.at(time);
    if (source.target_path)
        camera.target = scene.air.paths[*source.target_path].path.at(time);
    if (source.above_ground) {
        camera.position.y += scene.picture.ground.height(camera.position.x, camera.position.z);
        camera.target.y += scene.picture.ground.height(camera.target.x, camera.target.z);
    }
    return camera;
}

windrow::GroundWalker walker_at(const PictureScene& scene, const Walker& walker, double start, double end) {
    const windrow::scene::MotionPath& path = scene.air.paths[walker.path].path;
    return {.position = path.at(end),
            .previous = path.at(start),
            .foot_height = walker.foot_height(end),
            .previous_foot_height = walker.foot_height(start),
            .radius = walker.radius,
            .weight = walker.weight};
}

} // namespace windrow::vegetation::program
