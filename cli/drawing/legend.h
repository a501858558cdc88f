// What the frame's colours, arrows and marks mean, and where in the world the box is.
#pragma once

#include "cli/drawing/canvas.h"
#include "cli/drawing/layout.h"
#include "cli/drawing/slice.h"
#include "cli/pictures.h"

#include <span>

namespace windrow::cli {

struct LegendInput {
    const Air& air;
    const Layout& layout;
    std::span<const Trail> trails;
    std::span<const NamedMotor> motors;
    MotorCounts motors_of_scene{};
    float scale = 10.0f;     ///< [m/s] top of the colour bar
    float largest = 0.0f;    ///< [m/s] largest speed that both slices show
    bool broken_air = false; ///< a slice holds wind that is no number
};

void draw_legend(Canvas& canvas, const LegendInput& input);

} // namespace windrow::cli
