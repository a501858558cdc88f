// What `windrow info` says of the machine's Vulkan devices.
#pragma once

#include <string>
#include <vector>

namespace windrow::vulkan {
struct DeviceFacts;
}

namespace windrow::cli {

/// A line a device, in the order that --device counts; or one that says why there is none.
[[nodiscard]] std::vector<std::string> vulkan_lines();
/// Name, driver, version, and whether it is software. Where Vulkan is built in.
[[nodiscard]] std::string words_of(const vulkan::DeviceFacts& facts);

} // namespace windrow::cli
