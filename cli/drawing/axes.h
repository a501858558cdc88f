// The frame of a slice: its outline by kind of side, ticks in world metres, titles.
#pragma once

#include "cli/drawing/canvas.h"
#include "cli/drawing/layout.h"
#include "fluid/sides.h"

#include <string>
#include <vector>

namespace windrow::cli {

struct Ticks {
    double step = 1.0;
    int decimals = 0;
    /// Taken off every label where coordinates are far from 0; the axis title says so. 0 elsewhere.
    double offset = 0.0;
    std::vector<double> places; ///< [m] world, at least one
};

/// Ticks at whole multiples of 1, 2 or 5 times a power of ten on low..low + extent, at least `apart` [m] from each other.
[[nodiscard]] Ticks make_ticks(double low, double extent, double apart);

/// Draws around the panel, never inside it.
void draw_axes(Canvas& canvas, const Panel& panel, const Sides& sides);

} // namespace windrow::cli
