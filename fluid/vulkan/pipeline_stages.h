// The stages that the wind's commands run in, by short names.
#pragma once

#include <vulkan/vulkan_core.h>

namespace windrow::vulkan {

inline constexpr VkPipelineStageFlags k_compute = VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT,
                                      k_transfer = VK_PIPELINE_STAGE_TRANSFER_BIT,
                                      k_indirect = VK_PIPELINE_STAGE_DRAW_INDIRECT_BIT;

} // namespace windrow::vulkan
