#include "fluid/vulkan/functions.h"

#include <string>

namespace windrow::vulkan {
namespace {

void note_missing(std::string& missing, const char* name) {
    if (!missing.empty())
        missing += ", ";
    missing += name;
}

} // namespace

Result<Functions> load_functions(const Host& host) {
    if (host.get_instance_proc_addr == nullptr)
        return Error{"get_instance_proc_addr is null: give the vkGetInstanceProcAddr of your loader."};
    if (host.instance == VK_NULL_HANDLE || host.device == VK_NULL_HANDLE)
        return Error{"instance or device is null: give those that were made with the physical device."};
    Functions functions;
    std::string missing;
#define WINDROW_LOAD(name)                                                                                                       \
    functions.name = reinterpret_cast<PFN_##name>(host.get_instance_proc_addr(host.instance, #name));                            \
    if (functions.name == nullptr)                                                                                               \
        note_missing(missing, #name);
    WINDROW_INSTANCE_FUNCTIONS(WINDROW_LOAD)
#undef WINDROW_LOAD
    // Asked of the device, a call goes to its driver at once and not through the loader's choice between devices.
    if (functions.vkGetDeviceProcAddr != nullptr) {
#define WINDROW_LOAD(name)                                                                                                       \
    functions.name = reinterpret_cast<PFN_##name>(functions.vkGetDeviceProcAddr(host.device, #name));                            \
    if (functions.name == nullptr)                                                                                               \
        note_missing(missing, #name);
        WINDROW_DEVICE_FUNCTIONS(WINDROW_LOAD)
#undef WINDROW_LOAD
    }
    if (!missing.empty())
        return Error{"the driver lacks " + missing +
                     ": make instance and device with Vulkan 1.2 or newer, or update the driver."};
    return functions;
}

} // namespace windrow::vulkan
