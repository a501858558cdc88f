#include "cli/plot_csv.h"

#include "cli/table.h"

namespace windrow::cli {

namespace {

std::string quoted(const std::string& name) {
    return name.find(',') == name.npos ? name : "\"" + name + "\"";
}

} // namespace

std::string plot_csv(std::span<const PlotCurve> curves) {
    std::string text = "plot,panel,line,x,y\n";
    for (const PlotCurve& curve : curves) {
        const std::string line = quoted(curve.plot) + "," + quoted(curve.panel) + "," + quoted(curve.line) + ",";
        for (const glm::dvec2 point : curve.points)
            text += line + to_digits(point.x, 6) + "," + to_digits(point.y, 6) + "\n";
    }
    return text;
}

} // namespace windrow::cli
