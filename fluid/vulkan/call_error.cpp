#include "fluid/vulkan/call_error.h"

#include "fluid/message.h"

namespace windrow::vulkan {
namespace {

const char* fix_of(VkResult result) {
    switch (result) {
    case VK_ERROR_OUT_OF_HOST_MEMORY:
        return "free host memory or use a smaller box.";
    case VK_ERROR_OUT_OF_DEVICE_MEMORY:
    case VK_ERROR_OUT_OF_POOL_MEMORY:
    case VK_ERROR_FRAGMENTED_POOL:
        return "free device memory or use a smaller box.";
    case VK_ERROR_TOO_MANY_OBJECTS:
        return "free device memory in fewer, larger pieces.";
    case VK_ERROR_DEVICE_LOST:
        return "make the device anew, or go on with the CPU.";
    default:
        return "update the driver, or use another device or the CPU.";
    }
}

} // namespace

Error call_error(std::string_view function, std::string_view what, VkResult result) {
    return {detail::message(function, " for ", what, " returned ", name_of(result), ": ", fix_of(result))};
}

} // namespace windrow::vulkan
