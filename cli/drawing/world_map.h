// A small map from above: the paths of a whole run and the box on it.
#pragma once

#include "cli/drawing/canvas.h"
#include "cli/drawing/slice.h"
#include "cli/pictures.h"

#include <span>

namespace windrow::cli {

/// Directional motors are dots. The map covers all paths with a box's width around the followed one, so that it holds still while
/// the box moves.
void draw_world_map(Canvas& canvas, const Rect& place, const Air& air, std::span<const Trail> trails,
                    std::span<const NamedMotor> motors);

} // namespace windrow::cli
