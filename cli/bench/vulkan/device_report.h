// What `windrow bench --backend vulkan` prints.
#pragma once

#include "cli/bench/vulkan/device_result.h"
#include "cli/console.h"

namespace windrow::cli {

void report_device(const DeviceBenchResult& result, const Console& console);
void report_device_grid(const DeviceGridResult& grid, bool software, const Console& console);

} // namespace windrow::cli
