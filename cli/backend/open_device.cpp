#include "cli/backend/open_device.h"

#include "fluid/message.h"

#include <utility>

namespace windrow::cli {

using detail::message;

Fault open_device(const vulkan::OwnDevice::Settings& settings, std::unique_ptr<vulkan::OwnDevice>& device) {
    const auto devices = vulkan::list_devices();
    if (!devices)
        return {.sentence = message("no Vulkan device: ", devices.error()), .machine = true};
    const auto count = static_cast<int>(devices->size());
    if (settings.device >= count)
        return {.sentence =
                    message("--device is ", settings.device, ", and this machine has ", count,
                            count == 1 ? " device" : " devices", ": give a number in windrow info, from 0 to ", count - 1, ".")};
    auto made = vulkan::OwnDevice::create(settings);
    if (!made)
        return {.sentence = made.error(), .machine = true};
    device = *std::move(made);
    return {};
}

} // namespace windrow::cli
