// The colour bar: speed in m/s, and beneath it what people know such a wind by.
#pragma once

#include "cli/drawing/canvas.h"

namespace windrow::cli {

inline constexpr double k_colour_bar_height = 118.0;

/// `largest` [m/s] is marked on the bar.
void draw_colour_bar(Canvas& canvas, const Rect& place, float scale, float largest);

} // namespace windrow::cli
