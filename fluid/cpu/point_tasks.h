// What the kernels need to sample a wind at points: tasks of plain data, made from a box, its place and the ambient wind around it.
#pragma once

#include "fluid/ambient.h"
#include "fluid/cpu/kernels/kernels.h"

namespace windrow::cpu {

/// Valid while the wind's tile is. What is off stays unset.
void set_ambient(AmbientTask& task, const AmbientWind& wind);
/// The detail is that of the wind's tile, none without one.
[[nodiscard]] FeltTask felt_task(const AmbientWind& wind, const Sampling& sampling);

/// Each field that `validate` rejects replaced by its default: a NaN would spread.
[[nodiscard]] Sampling usable(Sampling sampling);

/// Axis of the wind's tile; the detail repeats in it.
[[nodiscard]] TileAxis tile_axis(const AmbientWind& wind, int axis, int repeats);
[[nodiscard]] AmbientWind::TilePlace tile_place(const TileAxis& axis, double coordinate);
/// A whole number of tiles of detail fits the gusts' tile, so the wrapped phase of the one is also a phase of the other.
[[nodiscard]] int detail_repeats(const AmbientWind& wind, const Sampling& sampling);

[[nodiscard]] Period period_of(double whole);

} // namespace windrow::cpu
