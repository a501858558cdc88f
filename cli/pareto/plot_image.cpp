#include "cli/pareto/plot_image.h"

#include "cli/drawing/image.h"
#include "fluid/message.h"

#include <cmath>

namespace windrow::cli {
namespace {

struct Painter {
    Canvas& canvas;

    void operator()(const PlotLine& mark) { canvas.stroke(mark.points, mark.line); }
    void operator()(const PlotPolygon& mark) {
        if (mark.fill.alpha > 0.0)
            canvas.fill(mark.points, mark.fill);
        if (mark.outline.width > 0.0)
            canvas.stroke(mark.points, mark.outline, true);
    }
    void operator()(const PlotCircle& mark) {
        if (mark.fill.alpha > 0.0)
            canvas.fill_circle(mark.middle, mark.radius, mark.fill);
        if (mark.outline.width > 0.0)
            canvas.stroke_circle(mark.middle, mark.radius, mark.outline);
    }
    void operator()(const PlotWords& mark) { canvas.words(mark.text, mark.at, mark.words); }
};

} // namespace

Result<void> write_plot(const Plot& plot, const std::filesystem::path& file) {
    const auto pixels = [](double length) { return static_cast<int>(std::lround(length * k_plot_pixels)); };
    Canvas canvas(pixels(plot.width), pixels(plot.height), k_plot_pixels, plot.paper);
    for (const PlotMark& mark : plot.marks)
        std::visit(Painter{canvas}, mark);
    const auto image = canvas.finish();
    if (!image)
        return Error{detail::message("picture ", file.string(), ": ", image.error())};
    return write_png(*image, {plot.title, {}}, file);
}

} // namespace windrow::cli
