// The Vulkan device that a command runs on, or why there is none.
#pragma once

#include "cli/fault.h"
#include "fluid/vulkan/own_device.h"

#include <memory>

namespace windrow::cli {

/// Makes `device`. A number that no device has is wrong use; the machine lacks the rest.
[[nodiscard]] Fault open_device(const vulkan::OwnDevice::Settings& settings, std::unique_ptr<vulkan::OwnDevice>& device);

} // namespace windrow::cli
