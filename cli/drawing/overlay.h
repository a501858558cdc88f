// Marks on a slice and around it: arrows or streamlines of the wind, plates, paths, motors, the player, their names; the outline by kind of side,
// ticks in world metres, titles.
#pragma once

#include "cli/drawing/canvas.h"
#include "cli/drawing/layout.h"
#include "cli/drawing/slice.h"
#include "cli/pictures.h"
#include "fluid/boundaries.h"

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace windrow::cli {

struct AxisTicks {
    double step = 1.0;
    int decimals = 0;
    /// Taken off every label where coordinates are far from 0; the axis title names it. 0 elsewhere.
    double offset = 0.0;
    std::vector<double> places; ///< [m] world, at least one
};

/// AxisTicks at whole multiples of 1, 2 or 5 times a power of ten on low..low + extent, at least `apart` [m] from each other.
[[nodiscard]] AxisTicks make_ticks(double low, double extent, double apart);

/// Draws around the panel, never inside it.
void draw_axes(Canvas& canvas, const Panel& panel, const Boundaries& boundaries);

/// Page units between arrows at least, and the length of an arrow of full scale as a share of their spacing.
inline constexpr double k_arrow_spacing = 27.0;
inline constexpr double k_arrow_reach = 0.92;

/// An arrow of the wind on air of a colour: light on dark air, dark on light air. A dot where `length` is next to nothing.
void draw_wind_arrow(Canvas& canvas, glm::dvec2 middle, glm::dvec2 direction, double length, Rgb8 air);

/// Page units between streamlines.
inline constexpr double k_streamline_spacing = 15.0;

/// A streamline on page units, with heads along it; `air` is the colour below a point.
void draw_streamline(Canvas& canvas, std::span<const glm::dvec2> points, const std::function<Rgb8(glm::dvec2)>& air);

/// Marks of the flow on the slice's own picture, and plates, which are as thin as lines.
void draw_flow(Canvas& canvas, const Panel& panel, const SlicedAir& air, const Image& slice, float scale, scene::FlowMarks marks);

/// The mark of the one that the box follows.
void draw_player(Canvas& canvas, glm::dvec2 at);

void draw_things(Canvas& canvas, const Panel& panel, const SlicedAir& air, std::span<const Trail> trails,
                 std::span<const NamedMotor> motors);

} // namespace windrow::cli
