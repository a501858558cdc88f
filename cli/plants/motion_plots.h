// What docs/plants_motion.md shows: each plot is computed by the library's own calls.
#pragma once

#include "cli/pareto/plot.h"

namespace windrow::cli {

/// A stalk of wheat in a gust that comes at once, at five frame rates: one curve.
[[nodiscard]] Plot spring_plot();
/// The tip of a fur whose body jumps, with 20 and 200 shells: on stages, and as each shell following the one inside by a share a
/// frame.
[[nodiscard]] Plot cascade_plot();

} // namespace windrow::cli
