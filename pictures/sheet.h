// Contact sheets: many pictures on one page, and what such a page is made of.
//
//     auto sheet = pictures::contact_sheet(frames, 4, 320);              // four beside each other, 320 px wide
//     if (sheet)
//         (void)pictures::write_png(*sheet, "sheet.png");
//
// A page with words of its own (the command's) places its tiles by SheetGrid.
#pragma once

#include "fluid/result.h"
#include "pictures/picture.h"

#include <span>

namespace windrow::pictures {

/// Tiles of one size in rows, `columns` beside each other. [px]
struct SheetGrid {
    int columns = 1;
    int tile_width = 0, tile_height = 0; ///< of a cell: a tile with its caption
    int gap = 0;                         ///< between tiles
    int left = 0, top = 0;               ///< corner of the first tile

    [[nodiscard]] int rows(std::size_t tiles) const { return (static_cast<int>(tiles) + columns - 1) / columns; }
    [[nodiscard]] int x(std::size_t tile) const { return left + static_cast<int>(tile) % columns * (tile_width + gap); }
    [[nodiscard]] int y(std::size_t tile) const { return top + static_cast<int>(tile) / columns * (tile_height + gap); }
    /// Ends of the last column and of the last row.
    [[nodiscard]] int right() const { return left + columns * (tile_width + gap) - gap; }
    [[nodiscard]] int bottom(std::size_t tiles) const { return top + rows(tiles) * (tile_height + gap) - gap; }
};

/// The part of a picture that is inside of it; at least one pixel.
[[nodiscard]] Picture8 cropped(const Picture8& picture, int left, int top, int width, int height);

/// Copies a picture onto a larger one, its corner at (left, top). It must fit.
void paste(const Picture8& picture, Picture8& onto, int left, int top);

/// The picture, `width` pixels wide, at most its own: each pixel the mean light of those that it covers.
[[nodiscard]] Picture8 shrunk(const Picture8& picture, int width);

/// The pictures, all of one size, row by row, `columns` beside each other, each `width` pixels wide, with a margin between them.
/// Rejects none, and pictures of different sizes.
[[nodiscard]] Result<Picture8> contact_sheet(std::span<const Picture8> pictures, int columns, int width);

} // namespace windrow::pictures
