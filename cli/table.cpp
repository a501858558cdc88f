#include "cli/table.h"

#include "fluid/core/message.h"

#include <charconv>

namespace windrow::cli {
namespace {

std::string to_text(double value, std::chars_format format, int digits) {
    char text[400];
    return std::string(text, std::to_chars(text, text + sizeof text, value, format, digits).ptr);
}

} // namespace

std::string csv_field(std::string_view text) {
    if (text.find_first_of(",\"\r\n") == text.npos)
        return std::string(text);
    std::string field = "\"";
    for (const char letter : text)
        (field += letter == '"' ? "\"" : "") += letter;
    return field + "\"";
}

std::string to_fixed(double value, int digits) {
    return to_text(value, std::chars_format::fixed, digits);
}

std::string to_scientific(double value, int digits) {
    return to_text(value, std::chars_format::scientific, digits);
}

std::string to_digits(double value, int digits) {
    return to_text(value, std::chars_format::general, digits);
}

std::string grid_name(glm::ivec3 cells) {
    return detail::message(cells.x, "x", cells.y, "x", cells.z);
}

std::string right(std::string_view text, std::size_t width) {
    return std::string(text.size() < width ? width - text.size() : 1, ' ') + std::string(text);
}

std::string TableFormat::line(std::string_view name, std::span<const std::string> columns) const {
    std::string text = "  " + std::string(name) + std::string(name.size() < name_width ? name_width - name.size() : 0, ' ');
    for (const std::string& column : columns)
        text += right(column, width);
    return text + "\n";
}

std::string plot_csv(std::span<const PlotCurve> curves) {
    std::string text = "plot,panel,line,x,y\n";
    for (const PlotCurve& curve : curves) {
        const std::string line = csv_field(curve.plot) + "," + csv_field(curve.panel) + "," + csv_field(curve.line) + ",";
        for (const glm::dvec2 point : curve.points)
            text += line + to_digits(point.x, 6) + "," + to_digits(point.y, 6) + "\n";
    }
    return text;
}

} // namespace windrow::cli
