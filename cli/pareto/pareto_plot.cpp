#include "cli/pareto/pareto_plot.h"

#include "cli/drawing/palette.h"
#include "cli/pareto/method_style.h"
#include "cli/pareto/pareto_panel.h"
#include "fluid/message.h"

#include <string>

namespace windrow::cli {
namespace {

using detail::message;

constexpr double k_width = 1600.0, k_header = 116.0, k_legend = 190.0;
constexpr double k_left = 100.0, k_between = 110.0, k_right = 30.0;
constexpr double k_panel_height = 440.0, k_row_height = k_panel_height + 104.0;

void add_words(Plot& plot, const std::string& text, glm::dvec2 at, double size, bool bold = false, Colour colour = k_ink) {
    plot.marks.emplace_back(PlotWords{text, at, {.size = size, .colour = colour, .bold = bold}});
}

void add_legend(Plot& plot, double top) {
    constexpr double k_line = 26.0, k_size = 14.5;
    const double columns[] = {k_left, 620.0, 960.0};
    const auto at = [&](int column, int line) { return glm::dvec2(columns[column], top + (line + 1) * k_line); };
    add_words(plot, "Colour: time step and advection", {columns[0], top}, k_size, true);
    int line = 0;
    for (const Scheme scheme : k_schemes)
        for (const Interpolation advection : k_advections) {
            const glm::dvec2 place = at(0, line++);
            plot.marks.emplace_back(PlotCircle{place + glm::dvec2(8.0, -5.0), 7.0, colour_of(scheme, advection)});
            add_words(plot, words_of(scheme, advection), place + glm::dvec2(26.0, 0.0), k_size);
        }
    add_words(plot, "Shape: pressure", {columns[1], top}, k_size, true);
    line = 0;
    for (const Pressure pressure : k_pressures) {
        const glm::dvec2 place = at(1, line++);
        add_marker(plot, pressure, place + glm::dvec2(8.0, -5.0), 6.0, k_dim_ink);
        add_words(plot, words_of(pressure), place + glm::dvec2(26.0, 0.0), k_size);
    }
    add_words(plot, "Marks", {columns[2], top}, k_size, true);
    glm::dvec2 place = at(2, 0);
    plot.marks.emplace_back(
        PlotLine{{place + glm::dvec2(0.0, -10.0), place + glm::dvec2(16.0, 0.0)}, {.colour = k_ink, .width = 1.8}});
    add_words(plot, "the front: whatever is as exact takes longer", place + glm::dvec2(26.0, 0.0), k_size);
    place = at(2, 1);
    plot.marks.emplace_back(PlotCircle{place + glm::dvec2(8.0, -5.0), 8.0, k_nothing, {.colour = k_ink, .width = 1.4}});
    add_words(plot, "what a Wind does by default: second-order, cubic, direct", place + glm::dvec2(26.0, 0.0), k_size);
    place = at(2, 2);
    add_words(plot, "pale points are beaten: something is as quick and more exact", place + glm::dvec2(26.0, 0.0), k_size);
    plot.marks.emplace_back(PlotCircle{place + glm::dvec2(8.0, -5.0), 4.0, k_dim_ink.faded(0.42)});
    place = at(2, 3);
    add_words(plot, "CFL: cells that the fastest air crosses in a step", place + glm::dvec2(26.0, 0.0), k_size);
    place = at(2, 4);
    add_words(plot, "on the upper edge: the flow was lost, error above 300 %", place + glm::dvec2(26.0, 0.0), k_size);
}

} // namespace

Plot pareto_plot(const ParetoResult& result) {
    const std::size_t count = result.flows.size(), rows = (count + 1) / 2;
    Plot plot{.width = k_width,
              .height = k_header + static_cast<double>(rows) * k_row_height + k_legend,
              .paper = k_paper,
              .title = "Speed against error"};
    add_words(plot, "Speed against error: the least error that can be had for the time", {k_left - 66.0, 42.0}, 25.0, true);
    add_words(plot,
              message("Each point is one method on one grid with one time step. Lower is more exact, further left is quicker. ",
                      result.device, ", ", result.simd, "."),
              {k_left - 66.0, 70.0}, 15.0, false, k_dim_ink);
    const std::string runner = result.backend == BackendKind::vulkan
                                   ? "the device, to the end of each step"
                                   : message(result.threads, result.threads == 1 ? " thread" : " threads");
    const double width = count == 1 ? k_width - k_left - k_right : 0.5 * (k_width - k_left - k_between - k_right);
    for (std::size_t n = 0; n < count; ++n)
        add_panel(plot, result.flows[n], result.threads, runner,
                  {k_left + static_cast<double>(n % 2) * (width + k_between),
                   k_header + static_cast<double>(n / 2) * k_row_height, width, k_panel_height});
    add_legend(plot, k_header + static_cast<double>(rows) * k_row_height + 8.0);
    return plot;
}

} // namespace windrow::cli
