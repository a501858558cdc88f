// `windrow bench --backend vulkan`.
#pragma once

#include "cli/bench/bench_request.h"
#include "cli/bench/vulkan/device_result.h"
#include "cli/console.h"

#include <functional>

namespace windrow::cli {

/// Opens the device, measures each grid, prints, and keeps the file where one is asked for. Returns the exit code.
[[nodiscard]] int run_device_bench(const BenchRequest& request, const Console& console, const std::function<int()>& stop_signal);

/// The same on a device that is open, without a file: what `windrow check` ends with. Grids as far as it came.
[[nodiscard]] int measure_device(vulkan::OwnDevice& own, const BenchRequest& request, const Console& console,
                                 const std::function<int()>& stop_signal, DeviceBenchResult& result);

} // namespace windrow::cli
