// A field of grass on the GPU, inside the host's renderer: chunks near the camera are made, culled and drawn without the CPU ever
// seeing a blade.
//
//     auto field = grass::GrassField::create(device, *hills, *mask, {});       // engine::Device::adopt(...): your device
//     (void)field->place({4.0e5, 0.0, -2.5e5});                              // its corner in the world
//     // Outside of a render pass:
//     (void)field->record_cull(commands, {.anchor = anchor, .view_projection = m, .eye = eye});
//     // Within it, with a vertex stage that includes vegetation/shaders/grass/grass_blade.glsl:
//     vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, yours);
//     field->draw(commands, {.layout = your_layout, .set = 1, .push_offset = 64});
//
// A frame asks a quadtree (chunk_tree.h) for the chunks that it needs, gives them slots of memory (chunk_cache.h), records one
// dispatch that makes the blades of new ones and one that culls the blades of all into index lists, and draws each list by an
// indirect draw: two a chunk, near and far blades. Nothing is submitted and nothing waited for; frames run on one queue, in the
// order of recording.
//
// Your pipeline: triangle strips without vertex buffers or restart, no face culled, `layout()` as set GRASS_SET, eight bytes of
// push constants for the vertex stage. No feature of the device is needed.
#pragma once

#include "../vulkan/objects.h"
#include "grass_block.h"

#include <memory>

namespace windrow::vegetation::grass {

enum class View { colour, shadow };

/// Draw arguments of one pass, for the host's pipeline.
struct GrassPass {
    /// Of the pipeline that is bound.
    VkPipelineLayout layout = VK_NULL_HANDLE;
    /// Index of the set `layout()` in it. Default 1: the wind's is 0.
    std::uint32_t set = 1;
    /// [bytes] Where the eight bytes lie within the push constants of `push_stages`. Default 64: after a matrix.
    std::uint32_t push_offset = 64;
    /// The stages of the layout's push constant range over those bytes. Default: as engine::make_pipeline_layout makes it.
    VkShaderStageFlags push_stages = VK_SHADER_STAGE_ALL;
    /// Whose blades: those that the camera sees, or those within the shadow map.
    View view = View::colour;
};

/// Figures of the frame recorded last.
struct GrassReport {
    int colour_chunks = 0; ///< drawn for the camera
    int shadow_chunks = 0; ///< and for the shadow
    int made_chunks = 0;   ///< that had no blades yet
    int left_out = 0;      ///< asked for beyond GrassSettings::max_chunks: the farthest
    int first_order = 0;   ///< where the chunks that are drawn stand in the orders (vegetation/shaders/grass/field.glsl)
    int orders = 0;        ///< and how many
};

class GrassField {
  public:
    /// Makes buffers and pipelines. Rejects what `validate` rejects, a mask of another extent than the heights', and a device
    /// that lacks memory, each with the reason. Copies heights and mask. The device outlives the field.
    [[nodiscard]] static windrow::Result<GrassField> create(engine::Device& device, const HeightMap& heights,
                                                            const PlacementMask& mask, const GrassSettings& settings);

    /// [m] World position of the first corner of the heights. Default: the origin. Rejects values that are not finite.
    windrow::Result<void> place(const glm::dvec3& corner);
    /// A changed mask, of the same corners and extent: chunks in what was touched are made again.
    windrow::Result<void> repaint(const PlacementMask& mask, const Touched& touched);

    /// Records what the draws of this frame need, outside of a render pass. Rejects a camera that is not finite; nothing is
    /// recorded then.
    windrow::Result<GrassReport> record_cull(VkCommandBuffer commands, const GrassCamera& camera);
    /// Within a render pass, after `record_cull` in the same queue, with a pipeline bound: binds the set and draws a view.
    void draw(VkCommandBuffer commands, const GrassPass& pass) const;

    /// Six buffers that the vertex stage reads, or a compute pass of the host's; `draw` binds the set by itself. The first four
    /// are in vegetation/shaders/grass/grass_blade.glsl.
    [[nodiscard]] VkDescriptorSetLayout layout() const;
    [[nodiscard]] VkDescriptorSet set() const;
    [[nodiscard]] const GrassSettings& settings() const;
    [[nodiscard]] const ChunkTree& tree() const;
    /// [bytes] Device memory in use: it never changes after `create`.
    [[nodiscard]] std::uint64_t memory_bytes() const;
    /// The draw commands of all slots, for those who count blades: four VkDrawIndirectCommand a slot, near and far of the
    /// colour's view, then of the shadow's. May be copied from.
    [[nodiscard]] VkBuffer draw_buffer() const;
    /// The records of all slots. May be copied from.
    [[nodiscard]] VkBuffer blade_buffer() const;
    /// The index lists of all slots (vegetation/shaders/grass/field.glsl draws their layout). May be copied from.
    [[nodiscard]] VkBuffer list_buffer() const;
    /// The slot of a chunk, -1 where it has none.
    [[nodiscard]] int slot_of(Chunk chunk) const;

    GrassField(GrassField&&) noexcept;
    GrassField& operator=(GrassField&&) noexcept;
    /// No recording of it is in flight.
    ~GrassField();

  private:
    struct State;
    explicit GrassField(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

} // namespace windrow::vegetation::grass
