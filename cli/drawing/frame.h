// A whole frame: the two slices with everything on and around them, and the legend, as an image.
#pragma once

#include "cli/drawing/layout.h"
#include "cli/drawing/slice.h"
#include "cli/pictures.h"
#include "fluid/result.h"

#include <span>

namespace windrow::cli {

/// Rejects a width that PictureSettings does not allow. A speed scale that is no number above 0 becomes the default.
[[nodiscard]] Result<Image> compose_frame(const SlicedAir& air, double time, std::span<const Trail> trails,
                                          std::span<const NamedMotor> motors, const PictureSettings& settings);

/// "t = 3.40 s"
[[nodiscard]] std::string time_text(double time);

struct LegendInput {
    const SlicedAir& air;
    const FrameLayout& layout;
    std::span<const Trail> trails;
    std::span<const NamedMotor> motors;
    MotorCounts motors_of_scene{};
    float scale = 10.0f;     ///< [m/s] top of the colour bar
    float largest = 0.0f;    ///< [m/s] largest speed that both slices show
    bool broken_air = false; ///< a slice holds wind that is no number
    scene::FlowMarks flow = scene::FlowMarks::arrows;
};

void draw_legend(Canvas& canvas, const LegendInput& input);

} // namespace windrow::cli
