#include "cli/plants/motion_plots.h"

#include "cli/drawing/palette.h"
#include "cli/plants/chart.h"
#include "cli/plants/motion_curves.h"

#include <array>

namespace windrow::cli {

Plot spring_plot() {
    Plot plot{.width = 1000.0, .height = 520.0, .paper = k_paper, .title = "A spring at five frame rates"};
    constexpr double k_seconds = 2.0;
    Chart chart(plot, {90.0, 60.0, 770.0, 380.0}, {"time [s]", 0.0, k_seconds, 0.25},
                {"share of the steady lean", 0.0, 1.8, 0.25});
    chart.add_axes("Wheat in a gust that comes at once: the same swing at 15 to 1000 Hz");
    constexpr std::array k_rates{1000, 144, 60, 30, 15};
    const auto curves = spring_response_curves(springs::wheat, k_rates, k_seconds);
    for (std::size_t n = 0; n < curves.size(); ++n) {
        const Colour colour = series_colour(n);
        if (n == 0)
            chart.add_line(curves[n].points, {.colour = colour, .width = 2.0});
        else // its frames alone: they lie on the curve
            for (const glm::dvec2 point : curves[n].points)
                plot.marks.emplace_back(PlotCircle{.middle = chart.at(point),
                                                   .radius = 1.2 + static_cast<double>(n),
                                                   .fill = k_nothing,
                                                   .outline = {.colour = colour, .width = 1.4}});
        chart.add_label(curves[n].name, {k_seconds, 1.4 - 0.12 * static_cast<double>(n)}, colour);
    }
    return plot;
}

Plot cascade_plot() {
    Plot plot{.width = 1000.0, .height = 520.0, .paper = k_paper, .title = "Fur that lags, with 20 and 200 shells"};
    constexpr double k_seconds = 12.0; // the slowest needs 9
    Chart chart(plot, {90.0, 60.0, 870.0, 380.0}, {"time after the body's jump [s]", 0.0, k_seconds, 1.0},
                {"way of the tip", 0.0, 1.1, 0.25});
    chart.add_axes("The tip of a fur whose body jumps, at 60 Hz");
    constexpr std::array k_shells{20, 200};
    const auto curves = cascade_curves({}, k_shells, k_seconds);
    const char* const names[] = {"stages, 20 shells (wide)", "a share a frame, 20 shells", "stages, 200 shells: on the same line",
                                 "a share a frame, 200 shells"};
    for (std::size_t n = 0; n < curves.size(); ++n) {
        const Colour colour = series_colour(n);
        // Where the two on stages lie on each other, the wide one shows beside the narrow one.
        chart.add_line(curves[n].points, {.colour = colour, .width = n == 0 ? 6.0 : 2.0});
        chart.add_label(names[n], {2.5, 0.72 - 0.09 * static_cast<double>(n)}, colour);
    }
    return plot;
}

} // namespace windrow::cli
