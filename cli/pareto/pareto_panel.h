// One flow's panel: all its runs, the front, the default.
#pragma once

#include "cli/pareto/pareto_result.h"
#include "cli/pareto/plot.h"

#include <string>

namespace windrow::cli {

/// Drawn around `frame`, the rectangle of its axes: a title above, ticks and titles below and to the left. `runner`: whose time
/// it is.
void add_panel(Plot& plot, const FlowResult& flow, int threads, const std::string& runner, const Rect& frame);

} // namespace windrow::cli
