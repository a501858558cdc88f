// `windrow pareto`: the least error that can be had for the time.
#pragma once

#include "cli/console.h"
#include "cli/pareto/pareto_request.h"

#include <functional>

namespace windrow::cli {

/// Returns the exit code: 1 where the default method broke on a flow. `stop_signal` is asked between runs and turns; anything but
/// 0 ends it there, and no file is made.
[[nodiscard]] int run_pareto(const ParetoRequest& request, const Console& console, const std::function<int()>& stop_signal);

} // namespace windrow::cli
