#include "cli/backend.h"

#include "fluid/core/message.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace windrow::cli {

using detail::message;

#if WINDROW_WITH_VULKAN

Fault open_backend(const BackendRequest& request, cases::Backend& backend) {
    if (request.kind == cases::BackendKind::cpu)
        return {};
    std::unique_ptr<vulkan::OwnDevice> device;
    if (Fault fault = open_device({.device = request.device}, device))
        return fault;
    std::string words = words_of(device->facts());
    backend = {std::move(device), std::move(words)};
    return {};
}

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

std::string words_of(const vulkan::DeviceFacts& facts) {
    return message(facts.name, ", driver ", facts.driver, ", Vulkan ", facts.api_version, facts.software ? ", software" : "");
}

std::vector<std::string> vulkan_lines() {
    const auto devices = vulkan::list_devices();
    if (!devices)
        return {"none: " + devices.error()};
    std::vector<std::string> lines;
    for (std::size_t place = 0; place < devices->size(); ++place) {
        const vulkan::DeviceFacts& facts = (*devices)[place];
        lines.push_back(message(place, ": ", words_of(facts)));
        if (facts.trouble.empty())
            continue;
        std::string trouble = facts.trouble;
        std::replace(trouble.begin(), trouble.end(), '\n', ' ');
        lines.back() += ", cannot run the wind: " + trouble;
    }
    return lines;
}

#else

Fault open_backend(const BackendRequest& request, cases::Backend&) {
    if (request.kind == cases::BackendKind::cpu)
        return {};
    return {.sentence = "--backend vulkan: this windrow was built without Vulkan: install libvulkan-dev, glslang-tools and "
                        "spirv-tools, and configure with -DWINDROW_VULKAN=ON."};
}

std::vector<std::string> vulkan_lines() {
    return {"not built in: build with WINDROW_VULKAN=ON"};
}

#endif

} // namespace windrow::cli
