// Where the parts of a frame lie on the page.
//
// It depends on the box's shape and the picture's width alone, never on where the box is or what the air does, so that the
// frames of a run lie on each other. Both slices have one scale. Of five arrangements the one is taken that draws the air
// largest and leaves the least paper empty; U is the upright slice, L the level one:
//
//     LLLL  UUUU      LLLL  UUUU      LLLL  legend      LLLLLLLLLL      L  U  legend
//     LLLL  legend    LLLL  UUUU      UUUU  legend      UUUUUUUUUU      L  U  legend
//     LLLL  legend    legend......    UUUU  legend      legend....      L  U  legend
//
#pragma once

#include "cli/drawing/canvas.h"
#include "cli/drawing/slice.h"

#include <algorithm>
#include <glm/vec2.hpp>

namespace windrow::cli {

/// A slice on the page.
struct Panel {
    Plane plane;
    Rect rect; ///< on whole pixels
    int width_px = 0, height_px = 0;
    glm::dvec2 low{0.0};        ///< [m] coordinates in the plane of the box's low corner
    glm::dvec2 extent{1.0};     ///< [m]
    glm::dvec2 scale{1.0};      ///< page units a metre, right and along the height; differ only where a thin box was stretched
    double caption_width = 0.0; ///< room for the words above the panel

    /// With its caption, ticks and titles.
    [[nodiscard]] Rect whole() const {
        return {rect.x - 62.0, rect.y - 28.0, std::max(rect.width, caption_width) + 80.0, rect.height + 28.0 + 54.0};
    }

    [[nodiscard]] glm::dvec2 to_page(glm::dvec2 in_plane) const;
    [[nodiscard]] glm::dvec2 to_page(const glm::dvec3& world) const { return to_page(plane.in_plane(world)); }
    /// A direction in the plane, turned as the page has it.
    [[nodiscard]] glm::dvec2 turned(glm::dvec2 in_plane) const {
        return {in_plane.x, plane.grows_upward() ? -in_plane.y : in_plane.y};
    }
};

struct FrameLayout {
    double unit = 1.0; ///< pixels a page unit
    int width_px = 0, height_px = 0;
    Rect page, header, legend;
    Panel level, upright;
};

/// Height that the legend needs at a width (legend.cpp).
[[nodiscard]] double legend_height(double width);

/// `width_px` within k_smallest_width..k_largest_width; both sizes come out even, as video coders want them.
[[nodiscard]] FrameLayout lay_out(const SlicedAir& air, glm::dvec3 slice_point, int width_px);

inline constexpr int k_smallest_width = 640;
inline constexpr int k_largest_width = 8000;

} // namespace windrow::cli
