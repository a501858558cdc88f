// A 3D image, its view and its memory.
#pragma once

#include "fluid/api.h"
#include "gpu/handle.h"
#include "gpu/memory.h"

namespace windrow::vulkan {

class Device;

/// Move-only. A 3D image with its view: storage, sampled, copied from and to; the host's shaders read it on the queue families
/// that Host names.
class WINDROW_INTERNAL Image3D {
  public:
    /// Empty.
    Image3D() = default;
    /// Rejects an extent that is 0 or beyond the device's limits, and a format that cannot do all of k_image_usage.
    /// `exported`: its memory can be exported as that handle type; 0: it cannot.
    [[nodiscard]] static Result<Image3D> create(Device& device, VkExtent3D extent, VkFormat format,
                                                VkExternalMemoryHandleTypeFlagBits exported = {});
    [[nodiscard]] VkImage handle() const { return image_.get(); }
    [[nodiscard]] VkImageView view() const { return view_.get(); }
    [[nodiscard]] const MemoryPiece& memory() const { return piece_.get(); }
    [[nodiscard]] VkDeviceSize memory_bytes() const { return memory_bytes_; }

  private:
    OwnedPiece piece_; // above what is bound to it, which goes first
    VkDeviceSize memory_bytes_ = 0;
    Handle<VkImage, &Functions::vkDestroyImage> image_;
    Handle<VkImageView, &Functions::vkDestroyImageView> view_;
};

} // namespace windrow::vulkan
