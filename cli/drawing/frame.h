// A whole frame: the two slices with everything on and around them, as an image.
#pragma once

#include "cli/drawing/image.h"
#include "cli/drawing/slice.h"
#include "cli/pictures.h"
#include "fluid/result.h"

#include <span>

namespace windrow::cli {

/// Refuses a width that PictureSettings does not allow. A speed scale that is no number above 0 becomes the default.
[[nodiscard]] Result<Image> compose_frame(const Air& air, double time, std::span<const Trail> trails,
                                          std::span<const NamedMotor> motors, const PictureSettings& settings);

/// "t = 3.40 s"
[[nodiscard]] std::string time_text(double time);

} // namespace windrow::cli
