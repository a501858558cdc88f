// All that describes a field of grass but its ground and its mask.
#pragma once

#include "coupling/blade.h"
#include "fluid/result.h"

#include <cstdint>

namespace windrow::vegetation::grass {

/// What is left out of a frame before it is drawn.
enum class Culling {
    none,   ///< nothing but what lies beyond the cut: every chunk, every blade
    chunks, ///< chunks out of view, by the quadtree
    blades  ///< and of the others each blade out of view, on the GPU
};

struct GrassSettings {
    /// The class of blades: length, width, stiffness, own bend, view bend. Default: meadow grass of 0.3 m, whose bend adds 0.5
    /// rad when seen from above, so that it covers the ground there too.
    windrow::BladeSettings blade{.view_bend = 0.5f};
    /// [1/m] Blade places along a metre of each axis, 0.1 to 64. Default 6: 36 a square metre.
    float density = 6.0f;
    /// Share of its cell over which a blade's place is drawn by chance, along each axis for itself, 0 to 1. Default 1: no rows
    /// are seen. 0 is the grid.
    float jitter = 1.0f;
    /// Another number, another field of the same kind. 0 to 2^32 - 1. Default 0.
    std::uint32_t seed = 0;
    /// Blade places along a chunk's side, 8 to 256. Default 96: 16 m at 6 a metre, 9,216 blades. Larger chunks are fewer draws
    /// and coarser culling.
    int chunk_cells = 96;
    /// [m] Distance of the eye from the root where 15 vertices become 7; above 0, below `cut_distance`. Default 25: there, a
    /// blade of 0.3 m has 14 pixels at 1080p and 50 degrees, and the strip of 7 is off by a pixel at most in any wind
    /// (vegetation/tests/grass/levels_test.cpp).
    float split_distance = 25.0f;
    /// [m] Where no blade is drawn, up to 1e4. Default 90: there, a blade has 4 pixels and the ground's colour takes over.
    float cut_distance = 90.0f;
    /// Share of `split_distance` at which near blades begin to morph into far ones, 0 to 0.99. Default 0.6. Later is sudden.
    float morph_from = 0.6f;
    /// Share of `cut_distance` at which blades begin to shrink into the ground, 0 to 0.99. Default 0.75.
    float fade_from = 0.75f;
    /// [m] The same for the shadow's pass, 0 to 1e4, no more than `cut_distance` counts. Default 40. 0: grass casts no shadow.
    float shadow_distance = 40.0f;
    /// [rad] Least width at which a blade is drawn, 0 to 0.01. Default 0.0007: about a pixel at 1080p; thinner ones flicker.
    float least_width = 0.0007f;
    /// [m] From here on fewer blades are drawn, each wider for it. 0.1 to 1e4. Default 10.
    float thin_from = 10.0f;
    /// Their share falls as (thin_from / distance)^thin_power, 0 to 3. Default 0: all are drawn. 1.5 halves them with every 1.6
    /// times the distance; from 2 on the eye sees few and wide blades.
    float thin_power = 0.0f;
    /// By how much of what is lost the others are wider, 0 to 1. Default 1: what they cover from above stays. A low eye looks
    /// across many blades and is content with 0.6, which keeps far ones slender.
    float thin_widen = 1.0f;
    /// [m] Mean distance between the middles of clumps, 0.01 to 100. Default 0.35: a tuft. What a clump shares:
    float clump_size = 0.35f;
    /// Share by which clumps may be lower than the class, 0 to 0.9. Default 0: all are as high.
    float clump_height = 0.0f;
    /// How much of a blade's facing, along which it bends by itself, is its clump's: 0 (default) its own, 1 all as one.
    float clump_lean = 0.0f;
    /// How much blades face outward from their clump's middle, 0 (default) to 1: a tuft that opens.
    float clump_fan = 0.0f;
    /// [m] Size of patches that grow lower, 0.1 to 1000. Default 6.
    float patch_size = 6.0f;
    /// Share by which the lowest patches are lower, 0 (default) to 0.9.
    float patch_height = 0.0f;
    /// Chunks that have memory at once, 1 to 32767. Default 160: a view of 90 degrees to 90 m and its shadows. With fewer than a
    /// view needs the farthest are left out, and counted (GrassReport::left_out).
    int most_chunks = 160;
    /// Default: all that can be. The others are there to measure what it saves; they draw the same picture.
    Culling culling = Culling::blades;
};

/// Every reason why it cannot be used, a line each.
[[nodiscard]] windrow::Result<void> validate(const GrassSettings& settings);

} // namespace windrow::vegetation::grass
