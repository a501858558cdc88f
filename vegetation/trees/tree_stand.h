// A stand of trees in the renderer: one kind at many places, each tree bent part by part by the wind at that part.
//
//     auto stand = trees::TreeStand::create(device, renderer.draw_targets(), {.kind = *trees::preset("oak")}, places, anchor);
//     renderer.add(**stand);
//     (*stand)->set_time_step(dt);       // before each frame that is recorded: what springs go by
//
// In each frame: a tree whose ball no view and no shadow sees costs nothing; of the others the parts that are drawn at their
// distance are bent once, by a compute pass, and the vertices follow in the colour and in both shadow passes. One indexed draw
// for wood and one for leaves a tree, each as long as its distance asks.
#pragma once

#include "../render/drawable.h"
#include "../vulkan/frames.h"
#include "stand_blocks.h"
#include "stand_settings.h"
#include "tree_model.h"

#include <array>
#include <memory>
#include <span>

namespace windrow::vegetation::trees {

class TreeStand final : public render::Drawable {
  public:
    /// Rejects what `validate` rejects, no places, and more trees than a dispatch takes (some 3,800 oaks). Shaders
    /// count from `anchor` [m], the renderer's.
    [[nodiscard]] static windrow::Result<std::unique_ptr<TreeStand>> create(engine::Device& device,
                                                                            const render::DrawTargets& targets,
                                                                            const TreeStandSettings& settings,
                                                                            std::span<const TreePlace> places, glm::dvec3 anchor);

    /// [s] Time from the last frame to those that follow, 0 or more; others count as 0. Default 1/60.
    void set_time_step(double seconds);

    Result<void> prepare(const render::PassContext& context) override;
    void draw(const render::PassContext& context) override;

    [[nodiscard]] std::size_t count() const { return places_.size(); }
    [[nodiscard]] const TreeModel& model(std::size_t tree) const { return models_[tree % models_.size()]; }
    [[nodiscard]] const PlaceBlock& place(std::size_t tree) const { return places_[tree]; }
    [[nodiscard]] const LevelBlock& levels() const { return block_.levels; }
    /// Vertices that the last frame's colour pass drew.
    [[nodiscard]] std::uint64_t drawn_vertices() const { return drawn_vertices_; }
    /// States of a tree's parts, once the frame is done: those of its model, in their order. Waits for the device.
    [[nodiscard]] Result<std::vector<PartState>> states(std::size_t tree) const;
    /// Set 2 of a frame in flight, and its layout, for shaders of a host's own that include trees/tree_parts.glsl.
    [[nodiscard]] VkDescriptorSet set(int slot) const { return sets_[static_cast<std::size_t>(slot)]; }
    [[nodiscard]] VkDescriptorSetLayout layout() const { return own_; }

  private:
    // A tree that some pass of this frame sees.
    struct Seen {
        std::uint32_t tree = 0;
        std::array<bool, 3> by{}; // the eye, the near shadow, the far one
        Drawn drawn{};
    };

    TreeStand(engine::Device& device, const render::DrawTargets& targets, const TreeStandSettings& settings,
              std::vector<TreeModel> models, std::span<const TreePlace> places, glm::dvec3 anchor);
    void make_pipelines(const render::DrawTargets& targets);
    void fill_buffers();
    void find_seen(const render::ViewBlock& frame);

    engine::Objects objects_;
    std::vector<TreeModel> models_;
    std::vector<PlaceBlock> places_{};
    std::vector<std::uint32_t> first_vertex_{}, first_index_{}, first_part_{}; // one a model
    StandBlock block_{};
    bool springs_ = true;
    windrow::FlutterClass flutter_{};
    double time_step_ = 1.0 / 60.0;
    double time_ = 0.0; // [s] of its frames
    std::vector<Seen> seen_{};
    std::uint64_t drawn_vertices_ = 0;

    VkDescriptorSetLayout own_ = VK_NULL_HANDLE;
    VkPipelineLayout layout_ = VK_NULL_HANDLE;
    VkPipeline loads_ = VK_NULL_HANDLE, bark_ = VK_NULL_HANDLE, leaf_ = VK_NULL_HANDLE, shadow_ = VK_NULL_HANDLE;
    std::array<VkDescriptorSet, engine::k_frames_in_flight> sets_{};
    engine::FrameBuffers blocks_{}, jobs_{};
    engine::Buffer states_{}, indices_{};
};

} // namespace windrow::vegetation::trees
