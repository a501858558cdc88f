// The sentence for a Vulkan call that failed.
#pragma once

#include "fluid/vulkan/host.h"

#include <string_view>

namespace windrow::vulkan {

/// "vkCreateBuffer for a buffer of 64 bytes returned VK_ERROR_OUT_OF_HOST_MEMORY: free host memory or use a smaller box."
[[nodiscard]] Error call_error(std::string_view function, std::string_view what, VkResult result);

} // namespace windrow::vulkan
