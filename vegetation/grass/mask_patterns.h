// Where grass does not grow by itself: patches by chance, and a path that feet keep bare. For masks that nobody paints.
//
//     auto mask = grass::PlacementMask::create({601, 601}, hills->extent(), 1.0f);
//     (void)grass::thin_out(*mask, {.share = 0.6f, .size = 3.0f});     // flowers here and there
//     (void)grass::tread(*mask, {.width = 1.2f, .at = 75.0f});
#pragma once

#include "vegetation/grass/placement_mask.h"

#include <cstdint>

namespace windrow::vegetation::grass {

struct BarePatches {
    /// Share of the ground on which nothing grows, 0 (default: no patches) to 0.95: within 0.1 of it over many patches
    /// (vegetation/tests/grass/mask_patterns_test.cpp). Plants grow lower at a patch's rim.
    float share = 0.0f;
    /// [m] Size of patches, 0.2 to 1000. Default 4. Ought to be four times the mask's spacing or more: smaller ones blur.
    float size = 4.0f;
    /// Others for another number; of 64 kinds.
    std::uint32_t seed = 0;
};

/// Winds along z about a line, by 1.6 m at most to either side.
struct FootPath {
    /// [m] That is bare, 0 (default: no path) to 20; plants beside it grow lower over as much again.
    float width = 0.0f;
    /// [m] Of the line along x, from the mask's first corner, -1e5 to 1e5. Default 50: the middle of a ground of 100 m.
    float at = 50.0f;
};

/// Both multiply the alpha that is there. They refuse values outside of the ranges above and touch nothing then.
windrow::Result<void> thin_out(PlacementMask& mask, const BarePatches& patches);
windrow::Result<void> tread(PlacementMask& mask, const FootPath& path);

} // namespace windrow::vegetation::grass
