// Many pictures on one page.
#pragma once

#include "examples/render/picture.h"

#include <span>

namespace meadow {

/// The pictures, all of one size, row by row, `columns` beside each other, each `width` pixels wide, with a margin between them.
/// Refuses none, and pictures of different sizes.
[[nodiscard]] windrow::Result<render::Picture8> contact_sheet(std::span<const render::Picture8> pictures, int columns, int width);

} // namespace meadow
