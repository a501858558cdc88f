// What `windrow pareto` tells: the front of each flow, and where the default stands.
#pragma once

#include "cli/console.h"
#include "cli/pareto/pareto_result.h"

namespace windrow::cli {

void report_pareto_start(const ParetoResult& result, const Console& console);
/// `threads`: those of the front.
void report_front(const FlowResult& flow, int threads, const Console& console);

} // namespace windrow::cli
