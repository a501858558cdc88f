#include "cli/backend/backend.h"

#if WINDROW_WITH_VULKAN
#include "cli/backend/open_device.h"
#include "cli/vulkan_facts.h"
#include "fluid/vulkan/own_device.h"
#endif

namespace windrow::cli {

#if WINDROW_WITH_VULKAN

Fault Backend::open(const BackendRequest& request) {
    if (request.kind == BackendKind::cpu)
        return {};
    std::unique_ptr<vulkan::OwnDevice> device;
    if (Fault fault = open_device({.device = request.device}, device))
        return fault;
    device_ = std::move(device);
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
