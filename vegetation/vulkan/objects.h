// The Vulkan objects of one owner: made on a device, destroyed together.
#pragma once

#include "device.h"
#include "shared_objects.h"

#include <span>

namespace windrow::vegetation::engine {

struct Image {
    VkImage image = VK_NULL_HANDLE;
    VkImageView view = VK_NULL_HANDLE;
};

struct ImageRecipe {
    VkFormat format = VK_FORMAT_UNDEFINED;
    VkExtent2D extent{};
    std::uint32_t slices = 0; ///< of a 3D image; 0: a 2D one
    VkSampleCountFlagBits samples = VK_SAMPLE_COUNT_1_BIT;
    VkImageUsageFlags usage = 0;
    VkImageAspectFlags aspect = VK_IMAGE_ASPECT_COLOR_BIT;
};

/// Kind of a sampler: single texels, four of them mixed, or the fraction of four texels that are not nearer than a depth.
enum class Sampler { texels, filter, depth };

/// One buffer a frame in flight.
using FrameBuffers = std::array<Buffer, k_frames_in_flight>;

/// The makers throw Failure (failure.h).
class Objects {
  public:
    explicit Objects(Device& device) : device_(&device) {}
    Objects(const Objects&) = delete;
    Objects& operator=(const Objects&) = delete;
    /// Destroys the last first. The host has waited until nothing uses them.
    ~Objects();

    [[nodiscard]] Device& device() const { return *device_; }
    /// For the device alone, Use::work, or Use::readback.
    [[nodiscard]] Buffer buffer(Use use, VkDeviceSize bytes, VkBufferUsageFlags usage);
    /// A storage buffer of Use::work that shaders see whole: the failure names it, its size and the fix.
    [[nodiscard]] VkBuffer storage(const char* name, const char* fix, VkDeviceSize bytes, VkBufferUsageFlags usage);
    /// Fixed content, on the device from the next frame on. At least one byte.
    [[nodiscard]] Buffer filled(std::span<const std::byte> content, VkBufferUsageFlags usage);
    /// Written by the host at `mapped` of its slot, in each frame before the submission.
    [[nodiscard]] FrameBuffers frame_buffers(VkDeviceSize bytes, VkBufferUsageFlags usage);
    /// An image to draw to, or to copy to and sample.
    [[nodiscard]] Image image(const ImageRecipe& recipe);
    [[nodiscard]] VkSampler sampler(Sampler kind);
    [[nodiscard]] VkSampler sampler(const VkSamplerCreateInfo& info);
    [[nodiscard]] VkQueryPool queries(VkQueryType type, std::uint32_t count, VkQueryPipelineStatisticFlags statistics = 0);

    /// An object of a call vkCreate...(device, info, callbacks, object), ended by `destroy`.
    template <class Object, class Info>
    [[nodiscard]] Object make(VkResult (*create)(VkDevice, const Info*, const VkAllocationCallbacks*, Object*),
                              void (*destroy)(VkDevice, Object, const VkAllocationCallbacks*), const Info& info,
                              const char* call) {
        Object made = VK_NULL_HANDLE;
        const VkAllocationCallbacks* const callbacks = device_->host().allocation_callbacks;
        must(create(device_->handle(), &info, callbacks, &made), call);
        at_end([destroy, vulkan = device_->handle(), made, callbacks] { destroy(vulkan, made, callbacks); });
        return made;
    }
    /// An object that others on this device use as well: theirs, or what `make` makes with the Objects that it is given.
    template <class Make>
    [[nodiscard]] auto shared(const SharedKey& key, const Make& make) {
        using Handle = std::invoke_result_t<Make, Objects&>;
        const auto found =
            device_->shared_objects().find(*this, key, [&](Objects& owner) { return bits_of<Handle>(make(owner)); });
        if (!found)
            return make(*this);
        at_end([found] {}); // used until then
        return handle_of<Handle>(found->handle);
    }
    void at_end(std::function<void()> destroy) { destroy_.push_back(std::move(destroy)); }

    /// [bytes] Device memory of these objects.
    [[nodiscard]] VkDeviceSize memory_bytes() const { return bytes_; }

  private:
    Device* device_;
    VkDeviceSize bytes_ = 0;
    std::vector<std::function<void()>> destroy_{};
};

/// Fixed content: the values of a list, or one block.
template <class Values>
[[nodiscard]] Buffer filled(Objects& objects, const Values& from, VkBufferUsageFlags usage) {
    return objects.filled(std::as_bytes(std::span(from)), usage);
}
template <class Block>
[[nodiscard]] Buffer filled_block(Objects& objects, const Block& block, VkBufferUsageFlags usage) {
    return objects.filled(std::as_bytes(std::span(&block, 1)), usage);
}

} // namespace windrow::vegetation::engine
