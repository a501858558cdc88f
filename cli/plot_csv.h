// The curves of a plot as CSV, which tools/plots.py draws.
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <string>
#include <vector>

namespace windrow::cli {

/// A line of a plot; a plot has one panel or more.
struct PlotCurve {
    std::string plot, panel, line;
    std::vector<glm::dvec2> points;
};

/// A row a point: plot, panel, line, x, y. Values of six digits.
[[nodiscard]] std::string plot_csv(std::span<const PlotCurve> curves);

} // namespace windrow::cli
