// What colour a speed has.
//
// The map of speeds runs from ink blue (calm) over blue, teal and green to pale straw (fast). It is drawn in OKLab: lightness
// rises in equal steps, so that equal steps of speed look equal, a grey print keeps the order, and an eye that does not tell
// red from green loses nothing. The map of signed components is pale at 0, blue below and rust above it.
// Based on: Ottosson 2020, "A perceptual color space for image processing" (the matrices of OKLab).
#pragma once

#include "cli/drawing/image.h"

#include <glm/vec3.hpp>

namespace windrow::cli {

/// Colour of a share of the scale, 0 calm to 1 fast; below and above it is held.
[[nodiscard]] Rgb8 speed_colour(float share);

/// Colour of a signed share of the scale, -1 to 1; below and above it is held.
[[nodiscard]] Rgb8 signed_colour(float share);

/// Colour of what is no number: far from every colour of either map.
inline constexpr Rgb8 k_broken_colour{255, 0, 170};

/// OKLab lightness (0 black, 1 white) and the two colour axes of an sRGB colour.
[[nodiscard]] glm::dvec3 to_oklab(Rgb8 colour);

} // namespace windrow::cli
