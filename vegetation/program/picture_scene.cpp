#include "vegetation/program/picture_scene.h"

#include <algorithm>
#include <cmath>

namespace windrow::vegetation::program {

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
