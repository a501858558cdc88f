// Pipelines without vertex buffers: vertices make themselves from their numbers and from storage buffers.
#pragma once

#include "objects.h"

#include <cstdint>

namespace windrow::vegetation::engine {

/// Targets of a pipeline: a render pass and its attachments.
struct PassTarget {
    VkRenderPass render_pass = VK_NULL_HANDLE;
    VkSampleCountFlagBits samples = VK_SAMPLE_COUNT_1_BIT;
    std::uint32_t colours = 1; ///< colour attachments
    bool depth = true;
};

struct PipelineRecipe {
    std::span<const std::uint32_t> vertex{}, fragment{}; ///< SPIR-V; no fragment stage: depth alone
    std::span<const std::uint32_t> constants{};          ///< of the fragment stage: constant_id 0, 1, 2 ...
    VkPipelineLayout layout = VK_NULL_HANDLE;
    PassTarget target{};
    VkPrimitiveTopology topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
    bool writes_depth = true;
    bool writes_colour = true;
    bool blends = false; ///< over what is there, by the fragment's alpha
    bool bias = false;   ///< a shadow's: depth is moved away from the light by the slope
};

/// Sets 0, 1, 2 ... and push constants for every stage.
inline constexpr std::uint32_t k_push_bytes = 16;
[[nodiscard]] VkPipelineLayout make_pipeline_layout(Objects& objects, std::span<const VkDescriptorSetLayout> sets,
                                                    std::uint32_t push_bytes = k_push_bytes);

/// Triangles without face culling, viewport and scissor dynamic, depth LESS_OR_EQUAL, no blending unless asked.
[[nodiscard]] VkPipeline make_pipeline(Objects& objects, const PipelineRecipe& recipe);
[[nodiscard]] VkPipeline make_compute_pipeline(Objects& objects, VkPipelineLayout layout, std::span<const std::uint32_t> words);

} // namespace windrow::vegetation::engine
