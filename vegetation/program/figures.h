// The people of a scene: walkers that are drawn, on their feet and in their cloaks, moved frame by frame.
//
//     auto figures = Figures::create(device, renderer->draw_targets(), scene, anchor);
//     figures->move(now, now - before, wind);                 // each frame, also one that is not drawn
//     figures->place();                                       // before the renderer's recording
#pragma once

#include "vegetation/program/gait.h"
#include "vegetation/program/picture_scene.h"
#include "vegetation/render/bodies.h"
#include "vegetation/render/cloak.h"
#include "vegetation/render/renderer.h"

#include <functional>
#include <memory>
#include <vector>

namespace windrow::vegetation::program {

/// How a walker stands at a time [s], in its own space: feet on the ground at the path's place, facing along the path.
struct WalkerPose {
    glm::dvec3 place{0.0}; ///< [m] in the world
    double yaw = 0.0;      ///< [rad]
    render::PersonStance stance{};
};
[[nodiscard]] WalkerPose walker_pose(const PictureScene& scene, const Walker& walker, const Gait& gait, double time);

/// [m/s] Of the air at a place of the world.
using WindAt = std::function<glm::vec3(glm::dvec3)>;

class Figures {
  public:
    /// No bodies where the scene draws none. The scene outlives it.
    [[nodiscard]] static windrow::Result<Figures> create(engine::Device& device, const render::DrawTargets& targets,
                                                         const PictureScene& scene, glm::dvec3 anchor);
    [[nodiscard]] static bool any(const PictureScene& scene);

    void add_to(render::Renderer& renderer);
    /// All are where they are at `time` [s], `seconds` after the last call; cloaks swing in the wind that they feel.
    void move(double time, double seconds, const WindAt& wind);
    /// Hands the renderer what was moved.
    void place();

  private:
    struct Figure {
        Walker walker; ///< a copy: more may come to the scene
        Gait gait;
        render::Cloak cloak{};
        WalkerPose pose{};
        render::PersonParts parts{};
    };
    Figures(const PictureScene& scene, glm::dvec3 anchor) : scene_(&scene), anchor_(anchor) {}

    const PictureScene* scene_;
    glm::dvec3 anchor_;
    std::vector<Figure> figures_{};
    std::unique_ptr<render::Bodies> bodies_{};
};

} // namespace windrow::vegetation::program
