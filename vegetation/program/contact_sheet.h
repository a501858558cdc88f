// Many pictures on one page.
#pragma once

#include "vegetation/render/picture.h"

#include <span>

namespace windrow::vegetation::program {

/// The picture, `width` pixels wide, at most its own: each pixel the mean light of those that it covers.
[[nodiscard]] render::Picture8 shrunk(const render::Picture8& picture, int width);

/// The pictures, all of one size, row by row, `columns` beside each other, each `width` pixels wide, with a margin between them.
/// Refuses none, and pictures of different sizes.
[[nodiscard]] windrow::Result<render::Picture8> contact_sheet(std::span<const render::Picture8> pictures, int columns, int width);

} // namespace windrow::vegetation::program
