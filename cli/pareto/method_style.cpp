#include "cli/pareto/method_style.h"

namespace windrow::cli {

Colour colour_of(Scheme scheme, Interpolation advection) {
    const bool cubic = advection == Interpolation::cubic;
    if (scheme == Scheme::second_order)
        return cubic ? hex(0x0060A8) : hex(0x56B4E9);
    return cubic ? hex(0xC44E00) : hex(0xF0AE20);
}

const char* words_of(Scheme scheme, Interpolation advection) {
    const bool cubic = advection == Interpolation::cubic;
    if (scheme == Scheme::second_order)
        return cubic ? "second-order step, cubic advection" : "second-order step, linear advection";
    return cubic ? "classic split (stable fluids), cubic advection" : "classic split (stable fluids), linear advection";
}

const char* words_of(Pressure pressure) {
    switch (pressure) {
    case Pressure::direct:
        return "direct solve";
    case Pressure::multigrid:
        return "multigrid, 2 cycles";
    case Pressure::jacobi80:
        return "80 Jacobi sweeps";
    case Pressure::jacobi40:
        return "40 Jacobi sweeps";
    default:
        return "20 Jacobi sweeps";
    }
}

void add_marker(Plot& plot, Pressure pressure, glm::dvec2 middle, double radius, Colour fill, const Line& outline) {
    const auto polygon = [&](std::vector<glm::dvec2> corners) {
        for (glm::dvec2& corner : corners)
            corner = middle + radius * corner;
        plot.marks.emplace_back(PlotPolygon{std::move(corners), fill, outline});
    };
    switch (pressure) { // of about the same area
    case Pressure::direct:
        plot.marks.emplace_back(PlotCircle{middle, radius, fill, outline});
        return;
    case Pressure::multigrid:
        return polygon({{0.0, -1.3}, {1.3, 0.0}, {0.0, 1.3}, {-1.3, 0.0}});
    case Pressure::jacobi80:
        return polygon({{-0.9, -0.9}, {0.9, -0.9}, {0.9, 0.9}, {-0.9, 0.9}});
    case Pressure::jacobi40:
        return polygon({{0.0, -1.3}, {1.2, 0.85}, {-1.2, 0.85}});
    case Pressure::jacobi20:
        return polygon({{0.0, 1.3}, {1.2, -0.85}, {-1.2, -0.85}});
    }
}

} // namespace windrow::cli
