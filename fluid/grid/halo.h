// Values beyond the cells of a box, as plain data: a level's kernels include this (cpu/kernels/kernels.h).
#pragma once

namespace windrow {

/// Halo of a padded field: cells below 0 and above n - 1 that a cubic read at a legal position can touch.
inline constexpr int k_halo_low = 2;
inline constexpr int k_halo_high = 3;
inline constexpr int k_halo = k_halo_low + k_halo_high;

/// Source of a padded value: value = scale * source + offset, or the ambient wind.
struct HaloRule {
    int source = 0;       ///< cell index along the axis, always inside
    bool ambient = false; ///< beyond an open boundary
    bool identity = true; ///< inside or periodic: the source's value unchanged
    float scale[4] = {1, 1, 1, 1};
    float offset[4] = {0, 0, 0, 0};
    float history_scale[4] = {1, 1, 1, 1}; ///< for the second-order history: odd along the normal, even else
};

/// One end of an axis for a stencil: the ghost beyond it is scale * value[source].
struct NormalGhost {
    int source;
    float scale;
};

} // namespace windrow
