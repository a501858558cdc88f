// What the machine's devices are called, and whether they can run the wind.
#pragma once

#include "fluid/vulkan/instance.h"
#include "fluid/vulkan/own_device.h"

#include <vector>

namespace windrow::vulkan {

struct FoundDevice {
    VkPhysicalDevice physical_device = VK_NULL_HANDLE;
    DeviceFacts facts{};
};

/// The devices of an instance, in the driver's order; an error where there is none.
[[nodiscard]] Result<std::vector<FoundDevice>> find_devices(const Instance& instance);

} // namespace windrow::vulkan
