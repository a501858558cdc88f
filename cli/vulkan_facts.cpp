#include "cli/vulkan_facts.h"

#if WINDROW_WITH_VULKAN
#include "fluid/message.h"
#include "fluid/vulkan/own_device.h"

#include <algorithm>
#include <cstddef>
#endif

namespace windrow::cli {

#if WINDROW_WITH_VULKAN

std::string words_of(const vulkan::DeviceFacts& facts) {
    return detail::message(facts.name, ", driver ", facts.driver, ", Vulkan ", facts.api_version,
                           facts.software ? ", software" : "");
}

std::vector<std::string> vulkan_lines() {
    const auto devices = vulkan::list_devices();
    if (!devices)
        return {"none: " + devices.error()};
    std::vector<std::string> lines;
    for (std::size_t place = 0; place < devices->size(); ++place) {
        const vulkan::DeviceFacts& facts = (*devices)[place];
        std::string line = detail::message(place, ": ", words_of(facts));
        if (!facts.trouble.empty()) {
            std::string trouble = facts.trouble;
            std::replace(trouble.begin(), trouble.end(), '\n', ' ');
            line += ", cannot run the wind: " + trouble;
        }
        lines.push_back(line);
    }
    return lines;
}

#else

std::vector<std::string> vulkan_lines() {
    return {"not built in: build with WINDROW_VULKAN=ON"};
}

#endif

} // namespace windrow::cli
