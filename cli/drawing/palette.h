// The colours of everything on a frame that is not air, and what they mean.
#pragma once

#include "cli/drawing/canvas.h"

namespace windrow::cli {

inline constexpr Colour k_paper = hex(0xFBFAF7);
inline constexpr Colour k_ink = hex(0x1C222B);
inline constexpr Colour k_dim_ink = hex(0x69717E);
inline constexpr Colour k_hairline = hex(0xD5D4CE);

// On the air: warm colours that the map of speeds does not hold, each with a dark casing, so that they read on calm and on fast
// air.
inline constexpr Colour k_casing = hex(0x0B0F16, 0.72);
inline constexpr Colour k_body = hex(0xFF6FC1); // a path and what moves on it; motors: motor_style.h
inline constexpr Colour k_player = hex(0xFFFFFF);
inline constexpr Colour k_plate = hex(0x10151D, 0.84); // behind names

} // namespace windrow::cli
