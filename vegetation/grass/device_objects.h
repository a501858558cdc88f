// The Vulkan objects of a field: made on the host's device, destroyed together. Calls go to the loader that the host links.
#pragma once

#include "fluid/vulkan/host.h"

#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

namespace windrow::vegetation::grass {

class DeviceObjects {
  public:
    explicit DeviceObjects(const windrow::vulkan::Host& host) : host_(host) {}
    DeviceObjects(const DeviceObjects&) = delete;
    DeviceObjects& operator=(const DeviceObjects&) = delete;
    /// The host has waited until nothing uses them.
    ~DeviceObjects();

    /// In the device's own memory. Refuses a size beyond what shaders reach, and tells an allocation that fails.
    [[nodiscard]] windrow::Result<VkBuffer> buffer(const char* name, VkDeviceSize bytes, VkBufferUsageFlags usage);
    /// Bindings from 0, one a buffer kind, seen by `stages`.
    [[nodiscard]] windrow::Result<VkDescriptorSetLayout> layout(std::span<const VkDescriptorType> kinds,
                                                                VkShaderStageFlags stages);
    struct Bound {
        VkDescriptorType kind = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
        VkBuffer buffer = VK_NULL_HANDLE;
    };
    [[nodiscard]] windrow::Result<VkDescriptorSet> set(VkDescriptorSetLayout layout, std::span<const Bound> buffers);
    [[nodiscard]] windrow::Result<VkPipelineLayout> pipeline_layout(std::span<const VkDescriptorSetLayout> sets,
                                                                    std::uint32_t push_bytes);
    [[nodiscard]] windrow::Result<VkPipeline> compute(VkPipelineLayout layout, std::span<const std::uint32_t> words);

    /// [bytes] Of device memory.
    [[nodiscard]] std::uint64_t bytes() const { return bytes_; }

  private:
    void at_end(std::function<void()> destroy) { destroy_.push_back(std::move(destroy)); }

    windrow::vulkan::Host host_;
    std::uint64_t bytes_ = 0;
    std::vector<std::function<void()>> destroy_{};
};

} // namespace windrow::vegetation::grass
