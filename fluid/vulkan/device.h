// The host's device as the rest of the backend uses it: calls, limits, memory, and the objects that free themselves.
#pragma once

#include "fluid/vulkan/buffer.h"
#include "fluid/vulkan/descriptor_sets.h"
#include "fluid/vulkan/functions.h"
#include "fluid/vulkan/image.h"
#include "fluid/vulkan/memory.h"
#include "fluid/vulkan/pipeline.h"

#include <array>
#include <cstdint>
#include <memory>

namespace windrow::vulkan {

/// One for each Wind. Outlives the objects of the headers above.
class Device {
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

    Host host_;
    Functions functions_;
    VkPhysicalDeviceLimits limits_{};
    Memory memory_;
};

} // namespace windrow::vulkan
