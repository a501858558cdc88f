// Interface of what the renderer draws: preparation before the passes, and draws in each pass.
#pragma once

#include "../vulkan/pipeline.h"
#include "frame_block.h"

namespace windrow::vegetation::render {

/// Kind of the recorded pass.
enum class Pass { colour, shadow };

/// A pass that is being recorded. Set 0 is the frame's, set 1 the wind's; set 2 is the drawable's own.
struct PassContext {
    VkCommandBuffer commands = VK_NULL_HANDLE;
    VkDescriptorSet frame = VK_NULL_HANDLE, wind = VK_NULL_HANDLE;
    const ViewBlock* block = nullptr; ///< what set 0 holds: matrices of the eye and of both shadows, for culling
    glm::dvec3 anchor{0.0};           ///< [m] in the world: where all positions of the frame count from
    int slot = 0;                     ///< which frame in flight
    Pass pass = Pass::colour;
    int cascade = 0; ///< 0 the near shadow, 1 the far one: a shadow's vertex stage multiplies by frame.shadow[cascade]
};

class Drawable {
  public:
    virtual ~Drawable() = default;
    /// Outside of a render pass, before all of them: culling, bends. It ends with a barrier of its own. What fails draws nothing
    /// of this frame.
    virtual Result<void> prepare(const PassContext&) { return {}; }
    /// Within the render pass of `context.pass`.
    virtual void draw(const PassContext& context) = 0;
};

/// Targets that a drawable's pipelines must fit. The fragment stage writes light to location 0 and motion to location 1, as
/// vegetation/shaders/render/solid.frag does.
struct DrawTargets {
    engine::PassTarget colour{}, shadow{};
    VkDescriptorSetLayout frame = VK_NULL_HANDLE, wind = VK_NULL_HANDLE;
};

} // namespace windrow::vegetation::render
