// One flow of `windrow pareto`: errors of all methods, steps and grids, and the times that belong to them.
#pragma once

#include "cli/backend/backend.h"
#include "cli/console.h"
#include "cli/pareto/pareto_request.h"
#include "cli/pareto/pareto_result.h"
#include "fluid/parallel.h"
#include "fluid/result.h"

#include <functional>
#include <optional>

namespace windrow::cli {

/// Memory that the flow's largest grid takes. [bytes]
[[nodiscard]] std::uint64_t flow_run_bytes(const ParetoFlow& flow);

/// Tells a line a grid. `threads` is the most; nothing inside where `stopped` said so.
[[nodiscard]] Result<std::optional<FlowResult>> run_flow(const ParetoFlow& flow, const ParetoRequest& request, int threads,
                                                         const ParallelFor& parallel_for, const Backend& backend,
                                                         const Console& console, const std::function<bool()>& stopped);

} // namespace windrow::cli
