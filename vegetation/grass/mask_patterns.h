// Procedural bare ground for placement masks: random patches, and a trodden path.
//
//     auto mask = grass::PlacementMask::create({601, 601}, hills->extent(), 1.0f);
//     (void)grass::thin_out(*mask, {.share = 0.6f, .size = 3.0f});     // flowers here and there
//     (void)grass::tread(*mask, {.width = 1.2f, .at = 75.0f});
#pragma once

#include "placement_mask.h"

#include <cstdint>

namespace windrow::vegetation::grass {

struct BarePatches {
    float share = 0.0f;
    float size = 4.0f;
    std::uint32_t seed = 0;

    static constexpr auto settings() {
        return std::tuple{
            Setting("bare", &BarePatches::share, {.min = 0.0, .max = 0.95, .zero = "no patches"},
                    "Fraction of the ground on which it does not grow, in patches by the seed of the layer: within 0.1 of it "
                    "over many patches. Plants grow lower at the edge of a patch."),
            Setting("bare_size", &BarePatches::size, {0.2, 1000.0, "m"},
                    "Size of those patches; ones below four times the mask's spacing blur."),
            Setting("seed", &BarePatches::seed, "Others for another number; of 64 kinds.", k_not_stored),
        };
    }
};

/// Winds along z about a line, by 1.6 m at most to either side.
struct FootPath {
    float width = 0.0f;
    float at = 50.0f;

    static constexpr auto settings() {
        return std::tuple{
            Setting("width", &FootPath::width, {0.0, 20.0, "m", "no path"},
                    "That is bare; plants beside it grow lower over as much again."),
            Setting("at", &FootPath::at, {-1e5, 1e5, "m"}, "Its position along x, from the ground's corner."),
        };
    }
};

/// Both multiply the alpha that is there. They reject values outside of the ranges above and touch nothing then.
windrow::Result<void> thin_out(PlacementMask& mask, const BarePatches& patches);
windrow::Result<void> tread(PlacementMask& mask, const FootPath& path);

} // namespace windrow::vegetation::grass
