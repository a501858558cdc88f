// What docs/plants.md shows: each plot is computed by the library's own calls.
#pragma once

#include "cli/pareto/plot.h"

#include <string>
#include <vector>

namespace windrow::cli {

/// Lean of the tip against the wind at the plant, eight classes.
[[nodiscard]] Plot bend_plot();
/// Middle line of a blade at six speeds: the bend that keeps its length, and the translate form beside it.
[[nodiscard]] Plot blade_plot();
/// Shells over a hill in a wind and under droop: the stem form and the translate form.
[[nodiscard]] Plot shell_plot();

/// The lean of each class in the middle of Beaufort's forces 1 to 10, as a table of text.
[[nodiscard]] std::string beaufort_table();

} // namespace windrow::cli
