// What `windrow check` finds.
#pragma once

#include "cli/bench/vulkan/device_result.h"
#include "cli/parity/run.h"

#include <string>
#include <vector>

namespace windrow::cli {

/// The stories, run under some checks of the validation layer.
struct CheckedStories {
    std::string validation; ///< "core and synchronisation", or why there was none
    bool validated = false;
    std::vector<ParityResult> stories{};
    std::vector<std::string> broken{};   ///< stories that could not run, a sentence each
    std::vector<std::string> messages{}; ///< the layer's first few
    int message_count = 0;               ///< all of them, those at the device's start and end too

    [[nodiscard]] bool pass() const;
};

struct CheckResult {
    vulkan::DeviceFacts device;
    std::vector<CheckedStories> runs{};
    DeviceBenchResult bench{};

    [[nodiscard]] bool pass() const;
};

} // namespace windrow::cli
