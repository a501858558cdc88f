// Names beside the things that they name, none over another.
#pragma once

#include "cli/drawing/canvas.h"

#include <string>
#include <vector>

namespace windrow::cli {

struct Name {
    std::string text;   ///< what it is called
    std::string detail; ///< a few words more, in a lighter tone; may be empty
    Colour colour;
    Rect around; ///< what it names; the name stands beside it, or in it where there is no room beside
};

/// Writes the names on plates within `room`, first come first placed, clear of each other and of `kept_free`. A name that finds
/// no place is left out, but for the first.
void draw_names(Canvas& canvas, const std::vector<Name>& names, const std::vector<Rect>& kept_free, const Rect& room);

} // namespace windrow::cli
