// What lies on the air: arrows of the wind, paths, motors, the player, their names.
#pragma once

#include "cli/drawing/canvas.h"
#include "cli/drawing/layout.h"
#include "cli/drawing/slice.h"
#include "cli/pictures.h"

#include <span>

namespace windrow::cli {

/// Page units between arrows at least, and the length of an arrow of full scale as a share of their spacing.
inline constexpr double k_arrow_spacing = 27.0;
inline constexpr double k_arrow_reach = 0.92;

/// An arrow of the wind on air of a colour: light on dark air, dark on light air. A dot where `length` is next to nothing.
void draw_wind_arrow(Canvas& canvas, glm::dvec2 middle, glm::dvec2 direction, double length, Rgb8 air);

/// Arrows on the slice's own picture.
void draw_arrows(Canvas& canvas, const Panel& panel, const Air& air, const Image& slice, float scale);

/// The mark of the one that the box follows.
void draw_player(Canvas& canvas, glm::dvec2 at);

void draw_things(Canvas& canvas, const Panel& panel, std::span<const Trail> trails, std::span<const NamedMotor> motors);

} // namespace windrow::cli
