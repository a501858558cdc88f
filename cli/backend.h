// What a command runs the air on.
#pragma once

#include "cases/backend_wind.h"
#include "cli/console.h"

#include <memory>
#include <string>
#include <vector>
#if WINDROW_WITH_VULKAN
#include "fluid/vulkan/own_device.h"
#endif

namespace windrow::cli {

struct BackendRequest {
    cases::BackendKind kind = cases::BackendKind::cpu;
    int device = -1; ///< place in the list of `windrow info`; -1: the first that is no software, else the first
};

/// Opens what is asked for.
[[nodiscard]] Fault open_backend(const BackendRequest& request, cases::Backend& backend);

/// The machine's Vulkan devices, a line each, in the order that --device counts; or one line that says why there is none.
[[nodiscard]] std::vector<std::string> vulkan_lines();

#if WINDROW_WITH_VULKAN
/// Makes `device`. A number that no device has is wrong use; the machine lacks the rest.
[[nodiscard]] Fault open_device(const vulkan::OwnDevice::Settings& settings, std::unique_ptr<vulkan::OwnDevice>& device);
/// Name, driver, version, and whether it is software.
[[nodiscard]] std::string words_of(const vulkan::DeviceFacts& facts);
#endif

} // namespace windrow::cli
