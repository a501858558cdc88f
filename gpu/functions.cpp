#include "gpu/functions.h"

#include "fluid/core/message.h"

#include <string>

namespace windrow::vulkan {
namespace {

void note_missing(std::string& missing, const char* name) {
    if (!missing.empty())
        missing += ", ";
    missing += name;
}

struct Fix {
    Fault fault;
    const char* what;
};

Fix fix_of(VkResult result) {
    switch (result) {
    case VK_ERROR_OUT_OF_HOST_MEMORY:
        return {Fault::out_of_memory, "free host memory or use a smaller box."};
    case VK_ERROR_OUT_OF_DEVICE_MEMORY:
    case VK_ERROR_OUT_OF_POOL_MEMORY:
    case VK_ERROR_FRAGMENTED_POOL:
        return {Fault::out_of_memory, "free device memory or use a smaller box."};
    case VK_ERROR_TOO_MANY_OBJECTS:
        return {Fault::out_of_memory, "free device memory, or allocate fewer and larger blocks."};
    case VK_ERROR_DEVICE_LOST:
        return {Fault::device_lost, "make the device again, or go on with the CPU."};
    default:
        return {Fault::rejected, "update the driver, or use another device or the CPU."};
    }
}

} // namespace

Result<Functions> load_functions(const Host& host) {
    if (host.get_instance_proc_addr == nullptr)
        return Error{"get_instance_proc_addr is null: give the vkGetInstanceProcAddr of your loader."};
    if (host.instance == VK_NULL_HANDLE || host.device == VK_NULL_HANDLE)
        return Error{"instance or device is null: give those that were made with the physical device."};
    Functions functions;
    std::string missing;
#define WINDROW_FETCH(name)                                                                                                      \
    functions.name = reinterpret_cast<PFN_##name>(host.get_instance_proc_addr(host.instance, #name));                            \
    if (functions.name == nullptr)                                                                                               \
        note_missing(missing, #name);
    WINDROW_INSTANCE_FUNCTIONS(WINDROW_FETCH)
#undef WINDROW_FETCH
    // A function pointer from the device calls its driver directly, without the loader's dispatch between devices.
    if (functions.vkGetDeviceProcAddr != nullptr) {
#define WINDROW_FETCH(name)                                                                                                      \
    functions.name = reinterpret_cast<PFN_##name>(functions.vkGetDeviceProcAddr(host.device, #name));                            \
    if (functions.name == nullptr)                                                                                               \
        note_missing(missing, #name);
        WINDROW_DEVICE_FUNCTIONS(WINDROW_FETCH)
#undef WINDROW_FETCH
    }
#define WINDROW_FETCH(name) functions.name = reinterpret_cast<PFN_##name>(host.get_instance_proc_addr(host.instance, #name));
    WINDROW_DEBUG_FUNCTIONS(WINDROW_FETCH)
#undef WINDROW_FETCH
    if (functions.vkCmdEndDebugUtilsLabelEXT == nullptr)
        functions.vkCmdBeginDebugUtilsLabelEXT = nullptr;
    if (!missing.empty())
        return Error{"the driver lacks " + missing +
                     ": make instance and device with Vulkan 1.2 or newer, or update the driver."};
    return functions;
}

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

Error call_error(std::string_view function, std::string_view what, VkResult result) {
    const Fix fix = fix_of(result);
    return {detail::message(function, " for ", what, " returned ", name_of(result), ": ", fix.what), fix.fault};
}

} // namespace windrow::vulkan
