// One grid measured on a device: the step, its passes, and what they are compared with, in turns.
#pragma once

#include "cli/bench/vulkan/device_result.h"
#include "fluid/parallel.h"
#include "fluid/simd.h"

#include <functional>
#include <optional>

namespace windrow::cli {

struct DeviceGridRequest {
    glm::ivec3 cells{0};
    double seconds = 5.0;
    /// Of the CPU's wind that the result is compared with.
    Simd simd = Simd::best;
    ParallelFor parallel_for{};
};

/// Nothing where it was stopped.
[[nodiscard]] Result<std::optional<DeviceGridResult>>
measure_device_grid(vulkan::OwnDevice& own, const DeviceGridRequest& request, const std::function<bool()>& stopped);

} // namespace windrow::cli
