// One flow's panel: all its runs, the front, the default.
#pragma once

#include "cli/pareto/pareto_result.h"
#include "cli/pareto/plot.h"

namespace windrow::cli {

/// Drawn around `frame`, the rectangle of its axes: a title above, ticks and titles below and to the left.
void add_panel(Plot& plot, const FlowResult& flow, int threads, const Rect& frame);

} // namespace windrow::cli
