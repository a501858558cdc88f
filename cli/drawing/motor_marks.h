// Names of things, and motors on a slice: what each kind is called and coloured and what it covers, its outline, and inside it a
// mark that shows what it does to the air.
#pragma once

#include "cli/drawing/canvas.h"
#include "cli/drawing/layout.h"
#include "cli/pictures.h"
#include "fluid/motor.h"

#include <array>
#include <cstddef>
#include <string>
#include <variant>
#include <vector>

namespace windrow::cli {

struct MotorStyle {
    const char* name;
    Colour colour;
};

/// In the order of windrow::Motor. Warm colours, pink and violet: the map of speeds holds none of them. Neighbours differ by
/// shape too.
inline constexpr std::array<MotorStyle, std::variant_size_v<Motor>> k_motor_styles{{{"fan, gust", hex(0xFF7A45)},
                                                                                    {"body, its wake", hex(0xFF6FC1)},
                                                                                    {"jet", hex(0xFFC02E)},
                                                                                    {"whirl", hex(0xBE95FF)},
                                                                                    {"blast, suction", hex(0xFF4F55)},
                                                                                    {"burst", hex(0xE040FB)}}};

[[nodiscard]] inline const MotorStyle& style_of(const Motor& motor) {
    return k_motor_styles[motor.index()];
}

/// Where a motor acts, as one of the regions.
struct PlacedRegion {
    Region region;
    glm::dvec3 centre{0.0}; ///< [m] world; first end of a cone
};
[[nodiscard]] PlacedRegion region_of(const Motor& motor);

/// "8 m/s": how strong it is, in few signs; nothing where no one figure says it.
[[nodiscard]] std::string strength_text(const Motor& motor);

struct Name {
    std::string text;   ///< what it is called
    std::string detail; ///< a few words more, in a lighter tone; may be empty
    Colour colour;
    Rect around; ///< what it names; the name stands beside it, or in it where there is no room beside
};

/// Writes the names on plates within `room`, first come first placed, clear of each other and of `kept_free`. A name that finds
/// no place is left out, except the first.
void draw_names(Canvas& canvas, const std::vector<Name>& names, const std::vector<Rect>& kept_free, const Rect& room);

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
