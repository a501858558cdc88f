// `windrow bench`: measures, tells, and keeps the figures.
#pragma once

#include "cli/bench/bench_request.h"
#include "cli/console.h"

#include <functional>

namespace windrow::cli {

/// Returns the exit code. `stop_signal` is asked between turns; anything but 0 ends the measurement there, and no file is made.
[[nodiscard]] int run_bench(const BenchRequest& request, const Console& console, const std::function<int()>& stop_signal);

} // namespace windrow::cli
