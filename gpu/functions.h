// Table of the Vulkan functions that Windrow calls, without loader symbols or globals; a test can replace them. And the message
// of a failed call.
#pragma once

#include "fluid/api.h"
#include "fluid/result.h"
#include "fluid/vulkan/host.h"

#include <string_view>

namespace windrow::vulkan {

// One name a line, so that the struct and its filling cannot differ.
// clang-format off
#define WINDROW_INSTANCE_FUNCTIONS(each) \
    each(vkGetDeviceProcAddr) \
    each(vkGetPhysicalDeviceProperties) \
    each(vkGetPhysicalDeviceProperties2) \
    each(vkGetPhysicalDeviceQueueFamilyProperties) \
    each(vkGetPhysicalDeviceMemoryProperties) \
    each(vkGetPhysicalDeviceImageFormatProperties) \
    each(vkGetPhysicalDeviceImageFormatProperties2)
#define WINDROW_DEVICE_FUNCTIONS(each) \
    each(vkAllocateMemory) \
    each(vkFreeMemory) \
    each(vkMapMemory) \
    each(vkFlushMappedMemoryRanges) \
    each(vkInvalidateMappedMemoryRanges) \
    each(vkCreateBuffer) \
    each(vkDestroyBuffer) \
    each(vkGetBufferMemoryRequirements) \
    each(vkBindBufferMemory) \
    each(vkCreateImage) \
    each(vkDestroyImage) \
    each(vkGetImageMemoryRequirements) \
    each(vkBindImageMemory) \
    each(vkCreateImageView) \
    each(vkDestroyImageView) \
    each(vkCreateSampler) \
    each(vkDestroySampler) \
    each(vkCreateShaderModule) \
    each(vkDestroyShaderModule) \
    each(vkCreateDescriptorSetLayout) \
    each(vkDestroyDescriptorSetLayout) \
    each(vkCreatePipelineLayout) \
    each(vkDestroyPipelineLayout) \
    each(vkCreateComputePipelines) \
    each(vkDestroyPipeline) \
    each(vkCreateDescriptorPool) \
    each(vkDestroyDescriptorPool) \
    each(vkAllocateDescriptorSets) \
    each(vkUpdateDescriptorSets) \
    each(vkCmdBindPipeline) \
    each(vkCmdBindDescriptorSets) \
    each(vkCmdPushConstants) \
    each(vkCmdDispatch) \
    each(vkCmdDispatchIndirect) \
    each(vkCmdPipelineBarrier) \
    each(vkCmdCopyBuffer) \
    each(vkCmdCopyBufferToImage) \
    each(vkCmdCopyImageToBuffer) \
    each(vkCmdFillBuffer) \
    each(vkCmdUpdateBuffer) \
    each(vkCmdWriteTimestamp) \
    each(vkCmdResetQueryPool) \
    each(vkCreateQueryPool) \
    each(vkDestroyQueryPool) \
    each(vkGetQueryPoolResults)
// Of VK_EXT_debug_utils: null where the host did not enable it.
#define WINDROW_DEBUG_FUNCTIONS(each) \
    each(vkSetDebugUtilsObjectNameEXT) \
    each(vkCmdBeginDebugUtilsLabelEXT) \
    each(vkCmdEndDebugUtilsLabelEXT)
// clang-format on

struct Functions {
#define WINDROW_DECLARE(name) PFN_##name name = nullptr;
    WINDROW_INSTANCE_FUNCTIONS(WINDROW_DECLARE)
    WINDROW_DEVICE_FUNCTIONS(WINDROW_DECLARE)
    WINDROW_DEBUG_FUNCTIONS(WINDROW_DECLARE)
#undef WINDROW_DECLARE
};

/// Fills the table for a device; names every function that is missing.
[[nodiscard]] WINDROW_INTERNAL Result<Functions> load_functions(const Host& host);

/// Of a call that failed: "vkCreateBuffer for a buffer of 64 bytes returned VK_ERROR_OUT_OF_HOST_MEMORY: free host memory or use
/// a smaller box."
[[nodiscard]] WINDROW_INTERNAL Error call_error(std::string_view function, std::string_view what, VkResult result);

} // namespace windrow::vulkan
