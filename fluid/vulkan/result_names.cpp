#include "fluid/vulkan/host.h"

namespace windrow::vulkan {

const char* name_of(VkResult result) {
    switch (result) {
#define WINDROW_NAME(name)                                                                                                       \
    case name:                                                                                                                   \
        return #name;
        WINDROW_NAME(VK_SUCCESS)
        WINDROW_NAME(VK_NOT_READY)
        WINDROW_NAME(VK_TIMEOUT)
        WINDROW_NAME(VK_EVENT_SET)
        WINDROW_NAME(VK_EVENT_RESET)
        WINDROW_NAME(VK_INCOMPLETE)
        WINDROW_NAME(VK_ERROR_OUT_OF_HOST_MEMORY)
        WINDROW_NAME(VK_ERROR_OUT_OF_DEVICE_MEMORY)
        WINDROW_NAME(VK_ERROR_INITIALIZATION_FAILED)
        WINDROW_NAME(VK_ERROR_DEVICE_LOST)
        WINDROW_NAME(VK_ERROR_MEMORY_MAP_FAILED)
        WINDROW_NAME(VK_ERROR_LAYER_NOT_PRESENT)
        WINDROW_NAME(VK_ERROR_EXTENSION_NOT_PRESENT)
        WINDROW_NAME(VK_ERROR_FEATURE_NOT_PRESENT)
        WINDROW_NAME(VK_ERROR_INCOMPATIBLE_DRIVER)
        WINDROW_NAME(VK_ERROR_TOO_MANY_OBJECTS)
        WINDROW_NAME(VK_ERROR_FORMAT_NOT_SUPPORTED)
        WINDROW_NAME(VK_ERROR_FRAGMENTED_POOL)
        WINDROW_NAME(VK_ERROR_OUT_OF_POOL_MEMORY)
        WINDROW_NAME(VK_ERROR_INVALID_EXTERNAL_HANDLE)
        WINDROW_NAME(VK_ERROR_FRAGMENTATION)
        WINDROW_NAME(VK_ERROR_INVALID_OPAQUE_CAPTURE_ADDRESS)
        WINDROW_NAME(VK_ERROR_UNKNOWN)
#undef WINDROW_NAME
    default:
        return "a VkResult without a name";
    }
}

} // namespace windrow::vulkan
