// A plot as a list of marks on a page, drawn by whatever can draw lines, shapes and words: as SVG (svg.h), as pixels
// (plot_image.h). Page units, x right, y down.
#pragma once

#include "cli/drawing/canvas.h"

#include <glm/vec2.hpp>
#include <string>
#include <variant>
#include <vector>

namespace windrow::cli {

inline constexpr Colour k_nothing{0.0, 0.0, 0.0, 0.0};
inline constexpr Line k_no_outline{.colour = k_nothing, .width = 0.0};

struct PlotLine {
    std::vector<glm::dvec2> points;
    Line line;
};

/// A filled shape; its outline is drawn where it is wider than 0.
struct PlotPolygon {
    std::vector<glm::dvec2> points;
    Colour fill;
    Line outline = k_no_outline;
};

struct PlotCircle {
    glm::dvec2 middle{0.0};
    double radius = 1.0;
    Colour fill;
    Line outline = k_no_outline;
};

/// `at` is on the base line.
struct PlotWords {
    std::string text;
    glm::dvec2 at{0.0};
    Words words;
};

using PlotMark = std::variant<PlotLine, PlotPolygon, PlotCircle, PlotWords>;

struct Plot {
    double width = 0.0, height = 0.0;
    Colour paper;
    std::string title;             ///< of the file
    std::vector<PlotMark> marks{}; ///< later ones over earlier ones
};

/// About how wide a text is: the widths of DejaVu Sans by kinds of letters, within a tenth. SVG's reader chooses the font.
[[nodiscard]] double width_about(std::string_view text, double size, bool bold = false);

} // namespace windrow::cli
