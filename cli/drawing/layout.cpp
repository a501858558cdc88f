#include "cli/drawing/layout.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace windrow::cli {
namespace {

constexpr double k_ordinary_width = 1600.0;
// Smaller pictures get fewer page units, not smaller letters, down to what the legend needs.
constexpr double k_smallest_unit = 0.72;

constexpr double k_panel_margin = 34.0;
constexpr double k_header = 84.0;
constexpr double k_panel_caption = 30.0; // above a panel
constexpr double k_axis_left = 62.0;
constexpr double k_axis_below = 58.0;
constexpr double k_panel_gap = 30.0;
constexpr double k_legend_column = 392.0;
constexpr double k_narrowest_column = 250.0; // room for a caption above a narrow panel
constexpr double k_narrowest_legend = 330.0;
constexpr double k_thinnest_panel = 40.0; // a box one cell thick is stretched to this
constexpr double k_foot = 22.0;           // below everything
constexpr double k_tallest_page = 0.82;   // of the width

double snap(double coordinate, double unit) {
    return std::round(coordinate * unit) / unit;
}

/// One way to lay out the page, in page units.
struct Plan {
    double scale = 0.0; ///< page units a metre
    Rect level, upright, legend;
    double level_caption = 0.0, upright_caption = 0.0;
    double bottom = 0.0;
};

/// What every arrangement works with.
struct Paper {
    glm::dvec3 extent;  ///< [m]
    double width = 0.0; ///< of the page
    double inner = 0.0; ///< between the margins
    double tallest = 0.0;

    /// Height left for slices beside `fixed` page units of other things.
    [[nodiscard]] double height_without(double fixed) const {
        return std::max(tallest - k_header - k_panel_margin - fixed, 150.0);
    }
    [[nodiscard]] double right() const { return width - k_panel_margin; }
};

constexpr double k_left = k_panel_margin + k_axis_left;
constexpr double k_top = k_header + k_panel_caption;
constexpr double k_per_panel = k_panel_caption + k_axis_below; // above and below a slice

double length(double metres, double scale) {
    return std::max(metres * scale, k_thinnest_panel);
}

void size_panels(Plan& plan, const Paper& paper, double scale) {
    plan.scale = scale;
    plan.level = {k_left, k_top, length(paper.extent.x, scale), length(paper.extent.z, scale)};
    plan.upright = {k_left, k_top, plan.level.width, length(paper.extent.y, scale)};
    plan.level_caption = plan.upright_caption = std::max(plan.level.width, k_narrowest_column);
}

/// Level and upright slice beside each other; the legend below the upright one, or below both.
Plan beside(const Paper& paper, bool legend_across) {
    const double column = 0.5 * (paper.inner - k_panel_gap);
    const double needed = k_panel_gap + legend_height(legend_across ? paper.inner : column);
    const double by_width = (column - k_axis_left) / paper.extent.x;
    Plan plan;
    size_panels(plan, paper,
                std::min({by_width, paper.height_without(k_per_panel + (legend_across ? needed : 0.0)) / paper.extent.z,
                          paper.height_without(k_per_panel + needed) / paper.extent.y}));
    const double second = k_left + plan.level_caption + k_panel_gap;
    plan.upright.x = second + k_axis_left;
    plan.upright_caption = paper.right() - plan.upright.x;
    const double level_end = plan.level.bottom() + k_axis_below, upright_end = plan.upright.bottom() + k_axis_below;
    const double left = legend_across ? k_panel_margin : second;
    const double tall = legend_height(paper.right() - left);
    if (legend_across)
        plan.bottom = std::max(level_end, upright_end) + k_panel_gap + tall;
    else // it stands on the level slice's foot, so that the page has one lower edge
        plan.bottom = std::max(level_end, upright_end + k_panel_gap + tall);
    plan.legend = {left, plan.bottom - tall, paper.right() - left, tall};
    return plan;
}

/// The upright slice below the level one; the legend in a column to the right, or below both.
Plan stacked(const Paper& paper, bool legend_across) {
    const double column = std::min(k_legend_column, 0.45 * paper.inner);
    const double beside_panels = legend_across ? 0.0 : k_panel_gap + column;
    const double below_panels = legend_across ? k_panel_gap + legend_height(paper.inner) : 0.0;
    Plan plan;
    size_panels(plan, paper,
                std::min((paper.inner - beside_panels - k_axis_left) / paper.extent.x,
                         paper.height_without(2.0 * k_per_panel + below_panels) / (paper.extent.y + paper.extent.z)));
    plan.upright.y = plan.level.bottom() + k_per_panel;
    const double end = plan.upright.bottom() + k_axis_below;
    if (legend_across) {
        plan.legend = {k_panel_margin, end + k_panel_gap, paper.inner, legend_height(paper.inner)};
    } else {
        const double left = k_left + plan.level_caption + k_panel_gap;
        plan.legend = {left, k_header, paper.right() - left, legend_height(paper.right() - left)};
    }
    plan.bottom = std::max(end, plan.legend.bottom());
    return plan;
}

/// Level slice, upright slice and legend, one beside another.
Plan in_a_row(const Paper& paper) {
    const double column = std::min(k_legend_column, 0.4 * paper.inner);
    const double width = 0.5 * (paper.inner - 2.0 * k_panel_gap - column) - k_axis_left;
    Plan plan;
    size_panels(plan, paper,
                std::min(std::max(width, 50.0) / paper.extent.x,
                         paper.height_without(k_per_panel) / std::max(paper.extent.y, paper.extent.z)));
    plan.upright.x = plan.level.x + plan.level_caption + k_panel_gap + k_axis_left;
    const double left = plan.upright.x + plan.upright_caption + k_panel_gap;
    plan.legend = {left, k_header, paper.right() - left, legend_height(std::max(paper.right() - left, 1.0))};
    plan.bottom = std::max(std::max(plan.level.bottom(), plan.upright.bottom()) + k_axis_below, plan.legend.bottom());
    if (plan.legend.width < k_narrowest_legend)
        plan.scale = 0.0; // never chosen
    return plan;
}

/// How well a plan uses its page: large air first, little empty paper second.
double merit(const Plan& plan, const Paper& paper) {
    const auto area = [](const Rect& rect) { return rect.width * rect.height; };
    const double used = area(plan.level) + area(plan.upright) + area(plan.legend);
    return plan.scale * std::sqrt(used / (paper.width * plan.bottom));
}

Panel place(const SlicedAir& air, Plane plane, const Rect& rect, double caption_width, double unit) {
    Panel panel;
    panel.plane = held_inside(plane, air);
    panel.width_px = std::max(1, static_cast<int>(std::lround(rect.width * unit)));
    panel.height_px = std::max(1, static_cast<int>(std::lround(rect.height * unit)));
    panel.rect = {snap(rect.x, unit), snap(rect.y, unit), panel.width_px / unit, panel.height_px / unit};
    panel.low = plane.in_plane(air.origin);
    panel.extent = plane.in_plane(air.extent());
    panel.scale = glm::dvec2(panel.rect.width, panel.rect.height) / panel.extent;
    panel.caption_width = caption_width;
    return panel;
}

} // namespace

glm::dvec2 Panel::to_page(glm::dvec2 in_plane) const {
    const glm::dvec2 share = (in_plane - low) / extent;
    return {rect.x + share.x * rect.width, rect.y + (plane.grows_upward() ? 1.0 - share.y : share.y) * rect.height};
}

FrameLayout lay_out(const SlicedAir& air, glm::dvec3 slice_point, int width_px) {
    FrameLayout layout;
    layout.width_px = width_px - width_px % 2;
    layout.unit = std::max(width_px / k_ordinary_width, k_smallest_unit);
    Paper paper{.extent = air.extent(), .width = layout.width_px / layout.unit};
    paper.inner = paper.width - 2.0 * k_panel_margin;
    paper.tallest = std::max(k_tallest_page * paper.width, 900.0);

    const std::array plans{beside(paper, false), beside(paper, true), stacked(paper, false), stacked(paper, true),
                           in_a_row(paper)};
    const Plan& plan = *std::max_element(plans.begin(), plans.end(),
                                         [&](const Plan& a, const Plan& b) { return merit(a, paper) < merit(b, paper); });
    layout.level = place(air, {Normal::y, slice_point.y}, plan.level, plan.level_caption, layout.unit);
    layout.upright = place(air, {Normal::z, slice_point.z}, plan.upright, plan.upright_caption, layout.unit);
    layout.legend = plan.legend;

    layout.height_px = static_cast<int>(std::lround((plan.bottom + k_foot) * layout.unit));
    layout.height_px += layout.height_px % 2;
    layout.page = {0.0, 0.0, paper.width, layout.height_px / layout.unit};
    layout.header = {k_panel_margin, 0.0, paper.inner, k_header};
    return layout;
}

} // namespace windrow::cli
