// How a method looks on the plot: its colour tells scheme and advection, its shape the pressure solve.
#pragma once

#include "cli/pareto/pareto_method.h"
#include "cli/pareto/plot.h"

namespace windrow::cli {

// Two blues and two oranges that eyes of all kinds tell apart. Based on: Okabe & Ito 2008, Color Universal Design.
[[nodiscard]] Colour colour_of(Scheme scheme, Interpolation advection);
/// In plain words, for the legend.
[[nodiscard]] const char* words_of(Scheme scheme, Interpolation advection);
[[nodiscard]] const char* words_of(Pressure pressure);

/// The shape of a pressure solve around `middle`, about `radius` large.
void add_marker(Plot& plot, Pressure pressure, glm::dvec2 middle, double radius, Colour fill, const Line& outline = k_no_outline);

} // namespace windrow::cli
