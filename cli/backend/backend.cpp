#include "cli/backend/backend.h"

#include "fluid/message.h"
#if WINDROW_WITH_VULKAN
#include "cli/vulkan_facts.h"
#include "fluid/vulkan/own_device.h"
#endif

namespace windrow::cli {

#if WINDROW_WITH_VULKAN

Fault Backend::open(const BackendRequest& request) {
    using detail::message;
    if (request.kind == BackendKind::cpu)
        return {};
    const auto devices = vulkan::list_devices();
    if (!devices)
        return {.sentence = message("--backend vulkan: ", devices.error()), .machine = true};
    if (request.device >= static_cast<int>(devices->size()))
        return {.sentence = message("--device is ", request.device, ", and this machine has ", devices->size(),
                                    devices->size() == 1 ? " device" : " devices", ": give a number that windrow info tells.")};
    auto device = vulkan::OwnDevice::create({.device = request.device});
    if (!device)
        return {.sentence = message("--backend vulkan: ", device.error()), .machine = true};
    device_ = *std::move(device);
    words_ = words_of(device_->facts());
    return {};
}

#else

Fault Backend::open(const BackendRequest& request) {
    if (request.kind == BackendKind::cpu)
        return {};
    return {.sentence = "--backend vulkan: this windrow was built without Vulkan: install libvulkan-dev, glslang-tools and "
                        "spirv-tools, and configure with -DWINDROW_VULKAN=ON."};
}

#endif

} // namespace windrow::cli
