// A plot as SVG 1.1 text.
#pragma once

#include "cli/pareto/plot.h"

#include <string>

namespace windrow::cli {

[[nodiscard]] std::string svg(const Plot& plot);

} // namespace windrow::cli
