// The page: a panel a flow, and what colours and shapes mean.
#pragma once

#include "cli/pareto/pareto_result.h"
#include "cli/pareto/plot.h"

namespace windrow::cli {

[[nodiscard]] Plot pareto_plot(const ParetoResult& result);

} // namespace windrow::cli
