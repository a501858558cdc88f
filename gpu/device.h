// The host's device as the rest of the backend uses it: calls, limits, memory, and the objects that free themselves.
#pragma once

#include "fluid/api.h"
#include "gpu/buffer.h"
#include "gpu/descriptor_sets.h"
#include "gpu/functions.h"
#include "gpu/image.h"
#include "gpu/memory.h"
#include "gpu/pipeline.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

namespace windrow::vulkan {

/// One for each Wind. Outlives the objects of the headers above.
class WINDROW_INTERNAL Device {
  public:
    /// Checks the host's device (host.h) and fills the calls.
    [[nodiscard]] static Result<std::unique_ptr<Device>> create(const Host& host);
    /// The same with calls given, as a test does that has one fail.
    [[nodiscard]] static Result<std::unique_ptr<Device>> create(const Host& host, const Functions& functions);
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

    [[nodiscard]] const Host& host() const { return host_; }
    [[nodiscard]] const Functions& functions() const { return functions_; }
    [[nodiscard]] const VkPhysicalDeviceLimits& limits() const { return limits_; }
    [[nodiscard]] Memory& memory() { return memory_; }
    /// Host::reader_stages, or its default.
    [[nodiscard]] VkPipelineStageFlags reader_stages() const { return reader_stages_; }
    /// Sharing mode of an image or a buffer that the host's shaders read (Host::reader_queue_families).
    template <class CreateInfo>
    void share_with_readers(CreateInfo& info) const {
        info.sharingMode = families_.size() > 1 ? VK_SHARING_MODE_CONCURRENT : VK_SHARING_MODE_EXCLUSIVE;
        if (families_.size() <= 1)
            return;
        info.queueFamilyIndexCount = static_cast<std::uint32_t>(families_.size());
        info.pQueueFamilyIndices = families_.data();
    }
    /// From Host::pipeline_store, or made for this device alone.
    [[nodiscard]] Result<std::shared_ptr<const Pipeline>> pipeline(const Pipeline::Description& description);
    /// Names an object for debuggers and validation messages: "windrow velocity". Nothing without VK_EXT_debug_utils.
    template <class Object>
    void name(VkObjectType type, Object object, std::string_view text) const {
        if (functions_.vkSetDebugUtilsObjectNameEXT != nullptr && !memory_.measuring())
            set_name(type, (std::uint64_t)object, text); // a pointer or an integer, by platform
    }

    /// Rejects a dispatch that the device cannot run: groups on an axis, invocations of a group, shared memory. `name` of the
    /// pass.
    struct Dispatch {
        std::array<std::uint32_t, 3> groups{1, 1, 1};
        std::array<std::uint32_t, 3> local_size{1, 1, 1};
        std::uint32_t shared_bytes = 0;
        const char* name = "";
    };
    [[nodiscard]] Result<void> check(const Dispatch& dispatch) const;

  private:
    Device(const Host& host, const Functions& functions);
    void set_name(VkObjectType type, std::uint64_t object, std::string_view text) const;

    Host host_;
    Functions functions_;
    VkPhysicalDeviceLimits limits_{};
    VkPipelineStageFlags reader_stages_ = 0;
    std::vector<std::uint32_t> families_; ///< of `host_`, the queue's own first
    Memory memory_;
};

} // namespace windrow::vulkan
