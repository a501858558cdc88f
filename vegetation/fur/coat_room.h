// What keeps a coat's strands outside of the body that wears it: patches of its skin in cells of space, and two passes a frame.
//
// At creation the whole mesh is cut into patches about 0.4 of the strands' length apart. Where bones move the mesh every vertex
// of the coat is looked at in each frame. A rigid mesh is looked at once: only vertices whose strands have skin rising before them
// are named, on a ball or a plane none, and then there are no passes. In a frame: patches go where the pose has them, then each
// named vertex takes back its lean until its strand is outside (vegetation/shaders/numerics/coat_room.glsl).
#pragma once

#include "../vulkan/objects.h"
#include "coat_block.h"

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace windrow::vegetation::fur {

/// A place on a triangle: CoatPatchRoot of vegetation/shaders/fur/coat_patches.glsl.
struct CoatPatchBlock {
    glm::uvec3 corners{0u};  ///< vertices
    float radius = 0.0f;     ///< [m] within which it stands for the skin
    glm::vec2 weights{0.0f}; ///< of the second and the third corner
    glm::vec2 unused{0.0f};
};
static_assert(sizeof(CoatPatchBlock) == 32);

/// The skin as patches 0.4 of `length` [m] apart, at most some hundred thousand of any mesh.
[[nodiscard]] std::vector<CoatPatchBlock> skin_patches(std::span<const CoatVertexBlock> vertices,
                                                       std::span<const std::uint32_t> indices, float length);
/// Those of the first `drawn` vertices whose strands of `length` [m] may meet a patch; all of them where bones move a vertex.
[[nodiscard]] std::vector<std::uint32_t> narrow_vertices(std::span<const CoatVertexBlock> vertices, std::size_t drawn,
                                                         std::span<const CoatPatchBlock> patches, float length);

class CoatRoom {
  public:
    /// `before` are the sets 0 to 2 of the coat, `skins` its buffer. The makers throw Failure.
    CoatRoom(engine::Objects& objects, std::span<const VkDescriptorSetLayout, 3> before, std::span<const CoatPatchBlock> patches,
             std::span<const std::uint32_t> narrow);

    /// After the skin's pass and its barrier to reading and writing by compute; ends with such a barrier. Sets 0 to 2 are bound
    /// again. `seconds` since the last frame, 0: unknown, strands are at once where they belong. `first`: no frame was before.
    void record(VkCommandBuffer commands, std::span<const VkDescriptorSet, 3> before, double seconds, bool first) const;

  private:
    std::uint32_t patches_ = 0, last_cell_ = 0, narrow_ = 0;
    VkDescriptorSet set_ = VK_NULL_HANDLE;
    VkPipelineLayout layout_ = VK_NULL_HANDLE;
    VkPipeline place_ = VK_NULL_HANDLE, limit_ = VK_NULL_HANDLE;
    VkBuffer cells_ = VK_NULL_HANDLE;
};

} // namespace windrow::vegetation::fur
