// Motors on a slice: each kind's outline in its colour, and inside it a mark that says what it does to the air.
#pragma once

#include "cli/drawing/canvas.h"
#include "cli/drawing/layout.h"
#include "cli/drawing/names.h"
#include "cli/pictures.h"

#include <vector>

namespace windrow::cli {

/// What is drawn on one panel, and what is still to be named there.
struct Marks {
    Canvas& canvas;
    const Panel& panel;
    /// So many motors that names, and those off the slice, would fill the picture.
    bool crowded = false;
    std::vector<Name> bodies, devices; ///< bodies are named first: they move, and a reader looks for them
    std::vector<Rect> kept_free;
};

/// Solid where the panel's plane cuts the motor's region, dashed where it lies before or behind. Weak motors are drawn faint,
/// those that do nothing not at all. A motor whose name stands elsewhere gets none here.
void draw_motor(Marks& marks, const NamedMotor& motor, bool named_elsewhere);

// --- Marks, for the legend too ---------------------------------------------------------------------------------------

/// A thick arrow along a direction of the world: a ring with a dot where it points at the reader, with a cross where away.
void draw_motor_arrow(Canvas& canvas, const Panel& panel, glm::dvec2 middle, glm::vec3 direction, double length, Colour colour);
/// Arrows about a point, outward or inward.
void draw_radial_arrows(Canvas& canvas, glm::dvec2 middle, double radius, bool outward, Colour colour);
/// Arrows along a circle, from x to y of the page (clockwise) or the other way.
void draw_turning_arrows(Canvas& canvas, glm::dvec2 middle, double radius, bool clockwise, Colour colour);
/// A star of sixteen points.
[[nodiscard]] std::vector<glm::dvec2> star(glm::dvec2 middle, double radius);

/// A line that reads on light and dark air.
[[nodiscard]] Line on_air(Colour colour, double width);

} // namespace windrow::cli
