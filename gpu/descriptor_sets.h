// Descriptor sets of the passes, written once.
#pragma once

#include "fluid/api.h"
#include "gpu/handle.h"

#include <cstddef>
#include <span>
#include <vector>

namespace windrow::vulkan {

class Device;
class PipelineLayout;

/// Contents of a descriptor set, in the order of its bindings.
struct Binding {
    VkDescriptorType type;
    VkBuffer buffer = VK_NULL_HANDLE;
    VkImageView view = VK_NULL_HANDLE; ///< in VK_IMAGE_LAYOUT_GENERAL (storage) or SHADER_READ_ONLY_OPTIMAL (sampled)
    VkSampler sampler = VK_NULL_HANDLE;
    VkDeviceSize bytes =
        VK_WHOLE_SIZE; ///< of the buffer: from an offset on that is given as the set is bound, where it is dynamic
};

/// Move-only. Descriptor sets, all made and written at once: ordinary ones, since GPU-assisted validation takes push descriptors
/// amiss.
class WINDROW_INTERNAL Sets {
  public:
    /// Empty.
    Sets() = default;
    struct Content {
        const PipelineLayout* layout;    ///< or a Pipeline
        std::vector<Binding> bindings{}; ///< of the layout's kinds; none: the caller writes the set
    };
    /// One set for each entry of `contents`.
    [[nodiscard]] static Result<Sets> create(Device& device, std::span<const Content> contents);
    [[nodiscard]] VkDescriptorSet at(std::size_t n) const { return sets_[n]; }

  private:
    Handle<VkDescriptorPool, &Functions::vkDestroyDescriptorPool> pool_; // its sets go with it
    std::vector<VkDescriptorSet> sets_;
};

} // namespace windrow::vulkan
