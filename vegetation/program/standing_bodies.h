// Solids of a scene's picture that a wind flows around or comes from: its fans and the obstacles of its air.
#pragma once

#include "scene/scene_air.h"
#include "vegetation/program/picture_scene.h"
#include "vegetation/render/bodies.h"
#include "vegetation/render/renderer.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace windrow::vegetation::program {

class StandingBodies {
  public:
    /// `anchor`: the renderer's. `edited`: each obstacle is a body of its own. Device and scene outlive it.
    [[nodiscard]] static Result<StandingBodies> create(engine::Device& device, const render::DrawTargets& targets,
                                                       const PictureScene& scene, glm::dvec3 anchor, bool edited);
    /// Again, after obstacles came or got another shape. Nothing that draws them is in flight.
    Result<void> make_obstacles(const render::DrawTargets& targets);
    void add_to(render::Renderer& renderer);
    /// Where they are at a time [s].
    void place(double time, const windrow::scene::SceneAir& air);

  private:
    StandingBodies(engine::Device& device, const PictureScene& scene, glm::dvec3 anchor, bool edited)
        : device_(&device), scene_(&scene), anchor_(anchor), edited_(edited) {}
    Result<void> make_fans(const render::DrawTargets& targets);
    void place_fans(double time);

    engine::Device* device_;
    const PictureScene* scene_;
    glm::dvec3 anchor_;
    bool edited_;
    std::unique_ptr<render::Bodies> fans_{};
    std::unique_ptr<render::Bodies> obstacles_{}; ///< those at rest are the first body
    std::vector<std::size_t> moving_{};           ///< indices in Scene::obstacles of the other bodies
};

} // namespace windrow::vegetation::program
