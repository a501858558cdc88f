// The host's Vulkan device. Windrow creates no instance, device, queue or command buffer, and does not submit or wait. It calls
// only functions from the host's vkGetInstanceProcAddr, no symbol of the loader.
#pragma once

#include "../api.h"
#include "../result.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>
#include <vulkan/vulkan_core.h>

namespace windrow::vulkan {

/// A block of device memory from the host's own allocator.
struct MemoryPiece {
    VkDeviceMemory memory = VK_NULL_HANDLE;
    VkDeviceSize offset = 0; ///< [bytes] aligned as asked
    void* mapped = nullptr;  ///< address of the block where host-visible memory was asked for
    std::uint64_t user = 0;  ///< the host's own; given back with the block
};

/// The host's allocator in place of ours (memory.h). Both or neither. Called from `create`, from `Wind::set_boundaries` where a
/// kind of boundary changes, and, to give back, from recording and destruction.
struct MemoryCallbacks {
    /// Memory of the type `type_index` that fits `requirements`; host-visible memory comes mapped. Size and alignment already
    /// hold what nonCoherentAtomSize and bufferImageGranularity ask, so that blocks may be adjacent. A result other than
    /// VK_SUCCESS is returned to the caller of `create`.
    std::function<VkResult(const VkMemoryRequirements& requirements, std::uint32_t type_index, MemoryPiece& piece)> allocate;
    std::function<void(const MemoryPiece& piece)> release;
};

class PipelineStore; // pipeline_store.h

/// For tools that look at compiled pipelines, as VK_KHR_pipeline_executable_properties does.
struct PipelineWatch {
    VkPipelineCreateFlags flags = 0; ///< of each pipeline, such as VK_PIPELINE_CREATE_CAPTURE_STATISTICS_BIT_KHR
    /// Called for each pipeline that was created, with the name of its pass.
    std::function<void(const char* name, VkPipeline pipeline)> created;
};

/// The host's device. All of it outlives what is made from it.
struct Host {
    VkInstance instance = VK_NULL_HANDLE;
    VkPhysicalDevice physical_device = VK_NULL_HANDLE;
    VkDevice device = VK_NULL_HANDLE;
    /// Family of the queue that will run the command buffers; it can compute. It need not draw.
    std::uint32_t queue_family = 0;
    /// Shader stages of that family which sample the textures or read the gust buffer. A recording waits for the earlier ones
    /// before it overwrites and makes its textures visible to the later ones. Default 0: vertex, fragment and compute, or compute
    /// alone where the family cannot draw. A host that samples in others (tessellation, geometry, mesh) names all that sample;
    /// fewer stages hold back less of the frame before. Rejected where the family lacks one.
    VkPipelineStageFlags reader_stages = 0;
    /// Other families whose queues sample them. Default none: the textures and the gust buffer are exclusive to `queue_family`.
    /// Else they are shared concurrently, so that no ownership is transferred: three small images, of which a frame reads each
    /// texel a few times, lose little by it. The host orders the submissions by semaphores (docs/vulkan.md).
    std::vector<std::uint32_t> reader_queue_families{};
    PFN_vkGetInstanceProcAddr get_instance_proc_addr = nullptr;
    /// Handed to every vkCreate and vkDestroy; null: the driver's own.
    const VkAllocationCallbacks* allocation_callbacks = nullptr;
    MemoryCallbacks memory{};
    /// [bytes] Shared memory of a work group, at most; 0: the device's limit. Less divides planes that would fit, as a device
    /// with less would: for tests.
    std::uint32_t shared_bytes = 0;
    PipelineWatch pipelines{};
    /// Where the driver looks for compiled pipelines, and keeps them. Null: nowhere, each is compiled.
    VkPipelineCache pipeline_cache = VK_NULL_HANDLE;
    /// Pipelines of all winds made from this host, from `PipelineStore::create`. Null: each wind makes its own.
    std::shared_ptr<PipelineStore> pipeline_store{};
};

/// Requirements of the device, for its creation. No extension is needed.
struct Requirements {
    std::uint32_t api_version = VK_API_VERSION_1_2;
    /// To be enabled when the device is made. One: shaderStorageImageExtendedFormats, without which no shader writes an R16F
    /// image.
    VkPhysicalDeviceFeatures features{};
    std::uint32_t shared_bytes = 16384; ///< maxComputeSharedMemorySize
    std::uint32_t invocations = 128;    ///< maxComputeWorkGroupInvocations
    std::uint32_t storage_buffers = 13; ///< maxPerStageDescriptorStorageBuffers
    std::uint32_t storage_images = 4;   ///< maxPerStageDescriptorStorageImages
};
[[nodiscard]] WINDROW_API Requirements requirements();

/// Usage of the images of the wind, which their formats must support.
inline constexpr VkImageUsageFlags k_image_usage =
    VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;

/// All reasons why a physical device cannot run the wind, one per line: version, limits, features,
/// formats. `get_instance_proc_addr` as in Host.
[[nodiscard]] WINDROW_API Result<void> check(VkInstance instance, VkPhysicalDevice physical_device,
                                             PFN_vkGetInstanceProcAddr get_instance_proc_addr);

/// Name of a VkResult, for messages.
[[nodiscard]] WINDROW_API const char* name_of(VkResult result);

} // namespace windrow::vulkan
