// The calls of Vulkan that the renderer makes. They come from the loader that opened the device, and no library of Vulkan is linked:
// a program that draws starts without one. Within windrow::vegetation these names hide the functions of <vulkan/vulkan.h>.
#pragma once

#include "../../fluid/result.h"
#include "../../fluid/vulkan/host.h"

#include <vulkan/vulkan_core.h>

// clang-format off
#define WINDROW_RENDERER_CALLS(each) \
    each(vkAllocateCommandBuffers) \
    each(vkAllocateDescriptorSets) \
    each(vkBeginCommandBuffer) \
    each(vkBindBufferMemory) \
    each(vkBindImageMemory) \
    each(vkCmdBeginQuery) \
    each(vkCmdBeginRenderPass) \
    each(vkCmdBindDescriptorSets) \
    each(vkCmdBindIndexBuffer) \
    each(vkCmdBindPipeline) \
    each(vkCmdCopyBuffer) \
    each(vkCmdCopyBufferToImage) \
    each(vkCmdCopyImageToBuffer) \
    each(vkCmdDispatch) \
    each(vkCmdDraw) \
    each(vkCmdDrawIndexed) \
    each(vkCmdDrawIndirect) \
    each(vkCmdEndQuery) \
    each(vkCmdEndRenderPass) \
    each(vkCmdFillBuffer) \
    each(vkCmdPipelineBarrier) \
    each(vkCmdPushConstants) \
    each(vkCmdResetQueryPool) \
    each(vkCmdSetScissor) \
    each(vkCmdSetViewport) \
    each(vkCmdUpdateBuffer) \
    each(vkCmdWriteTimestamp) \
    each(vkCreateBuffer) \
    each(vkCreateCommandPool) \
    each(vkCreateComputePipelines) \
    each(vkCreateDescriptorPool) \
    each(vkCreateDescriptorSetLayout) \
    each(vkCreateFence) \
    each(vkCreateFramebuffer) \
    each(vkCreateGraphicsPipelines) \
    each(vkCreateImage) \
    each(vkCreateImageView) \
    each(vkCreatePipelineLayout) \
    each(vkCreateQueryPool) \
    each(vkCreateRenderPass) \
    each(vkCreateSampler) \
    each(vkCreateShaderModule) \
    each(vkDestroyBuffer) \
    each(vkDestroyCommandPool) \
    each(vkDestroyDescriptorPool) \
    each(vkDestroyDescriptorSetLayout) \
    each(vkDestroyFence) \
    each(vkDestroyFramebuffer) \
    each(vkDestroyImage) \
    each(vkDestroyImageView) \
    each(vkDestroyPipeline) \
    each(vkDestroyPipelineLayout) \
    each(vkDestroyQueryPool) \
    each(vkDestroyRenderPass) \
    each(vkDestroySampler) \
    each(vkDestroyShaderModule) \
    each(vkDeviceWaitIdle) \
    each(vkEndCommandBuffer) \
    each(vkGetBufferMemoryRequirements) \
    each(vkGetImageMemoryRequirements) \
    each(vkGetPhysicalDeviceFormatProperties) \
    each(vkGetPhysicalDeviceProperties) \
    each(vkGetPhysicalDeviceQueueFamilyProperties) \
    each(vkGetQueryPoolResults) \
    each(vkInvalidateMappedMemoryRanges) \
    each(vkQueueSubmit) \
    each(vkResetFences) \
    each(vkUpdateDescriptorSets) \
    each(vkWaitForFences)
// clang-format on

namespace windrow::vegetation {

#define WINDROW_DECLARE(name) extern PFN_##name name;
WINDROW_RENDERER_CALLS(WINDROW_DECLARE)
#undef WINDROW_DECLARE

namespace engine {
/// Fetches them from the host's loader, for all devices of the program: these are the loader's own, which find a device's driver by
/// its handles. An error names those that it lacks.
[[nodiscard]] windrow::Result<void> load_calls(const vulkan::Host& host);
} // namespace engine

} // namespace windrow::vegetation
