// The bodies of a scene as they are drawn: mesh, skeleton and coats, moved frame by frame.
//
//     auto furred = FurredBodies::create(device, renderer->draw_targets(), scene, anchor);
//     furred->add_to(*renderer);
//     (void)furred->move(now, now - before);         // before each frame that is recorded, and each that keeps up
#pragma once

#include "vegetation/fur/coat.h"
#include "vegetation/program/picture_scene.h"
#include "vegetation/render/renderer.h"

#include <memory>
#include <optional>
#include <vector>

namespace windrow::vegetation::program {

/// The mesh of a body: read, or made of its formula; bound to its skeleton if it has one.
struct BodyModel {
    fur::Mesh mesh{};
    std::optional<fur::Skeleton> skeleton{};
};
/// Rejects what the mesh's reader rejects, and bones that do not hang together. The mesh's file takes its part of `budget`.
[[nodiscard]] windrow::Result<BodyModel> model_of(const PictureScene& scene, const Body& body,
                                                  windrow::detail::InputBudget& budget);

/// Those parts of the mesh that a coat is for; all where it names no material. Rejects a material that the mesh has not.
[[nodiscard]] windrow::Result<std::vector<fur::MeshPart>> parts_of(const fur::Mesh& mesh, const BodyCoat& coat);

/// [m] By which the mean wind at a body has carried a pattern until a time [s], along x and z: their product, so that it is as
/// exact at any time as the wind itself, a float (6e-8 of the way). Gusts are left out: over time they carry nothing.
[[nodiscard]] glm::dvec2 drift_of(const PictureScene& scene, const Body& body, double time);

/// The feet of the first fur::k_max_feet walkers, on the ground or as high above it as they jump.
[[nodiscard]] std::vector<fur::Foot> feet_of(const PictureScene& scene, double time);

class FurredBodies {
  public:
    /// All bodies where they are at time 0. Rejects what any part rejects, with the body's name. The scene outlives it.
    [[nodiscard]] static windrow::Result<FurredBodies> create(engine::Device& device, const render::DrawTargets& targets,
                                                              const PictureScene& scene, glm::dvec3 anchor);

    void add_to(render::Renderer& renderer);
    /// All bodies are where they are at `time` [s], `seconds` after the last call; 0: they are there, or placed there. The wind
    /// that they feel and the lag of their tips do not depend on how long frames are.
    windrow::Result<void> move(double time, double seconds);
    /// What keeps up in frames that are not drawn.
    void append_to(std::vector<render::Drawable*>& drawables) const;
    [[nodiscard]] bool empty() const { return furred_.empty(); }
    /// Coats of all bodies, in the scene's order.
    [[nodiscard]] std::vector<const fur::Coat*> coats() const;

  private:
    struct Furred {
        const Body* body;
        BodyModel model;
        std::vector<std::unique_ptr<fur::Coat>> coats;
    };
    explicit FurredBodies(const PictureScene& scene) : scene_(&scene), inputs_(scene.inputs) {}
    windrow::Result<void> dress(engine::Device& device, const render::DrawTargets& targets, const Body& body, glm::dvec3 anchor);
    windrow::Result<void> move(const Furred& furred, double time, double seconds);

    const PictureScene* scene_;
    windrow::detail::InputBudget inputs_; ///< what the scene's own reading has left
    std::vector<Furred> furred_{};
    double time_ = 0.0; ///< [s] of the last call
};

} // namespace windrow::vegetation::program
