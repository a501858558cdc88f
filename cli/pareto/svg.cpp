#include "cli/pareto/svg.h"

#include "fluid/message.h"

#include <charconv>
#include <cmath>
#include <string_view>

namespace windrow::cli {
namespace {

using detail::message;

// A hundredth of a page unit is finer than any screen.
std::string number(double value) {
    char text[64];
    const double rounded = std::round(value * 100.0) / 100.0;
    return std::string(text, std::to_chars(text, text + sizeof text, rounded == 0.0 ? 0.0 : rounded).ptr);
}

std::string escaped(std::string_view text) {
    std::string safe;
    for (const char letter : text) {
        switch (letter) {
        case '&':
            safe += "&amp;";
            break;
        case '<':
            safe += "&lt;";
            break;
        case '>':
            safe += "&gt;";
            break;
        case '"':
            safe += "&quot;";
            break;
        default:
            safe += letter;
        }
    }
    return safe;
}

std::string rgb(Colour colour) {
    const auto part = [](double share) { return static_cast<int>(std::lround(255.0 * share)); };
    return message("rgb(", part(colour.red), ",", part(colour.green), ",", part(colour.blue), ")");
}

std::string fill(Colour colour) {
    if (colour.alpha <= 0.0)
        return " fill=\"none\"";
    return message(" fill=\"", rgb(colour), "\"", colour.alpha < 1.0 ? " fill-opacity=\"" + number(colour.alpha) + "\"" : "");
}

std::string stroke(const Line& line) {
    if (line.width <= 0.0 || line.colour.alpha <= 0.0)
        return {};
    return message(" stroke=\"", rgb(line.colour), "\" stroke-width=\"", number(line.width), "\" stroke-linejoin=\"round\"",
                   line.colour.alpha < 1.0 ? " stroke-opacity=\"" + number(line.colour.alpha) + "\"" : "",
                   line.dash > 0.0 ? " stroke-dasharray=\"" + number(line.dash) + " " + number(line.gap) + "\"" : "");
}

std::string points(const std::vector<glm::dvec2>& list) {
    std::string text;
    for (const glm::dvec2 point : list)
        text += message(text.empty() ? "" : " ", number(point.x), ",", number(point.y));
    return text;
}

struct Writer {
    std::string text;

    void operator()(const PlotLine& mark) {
        text += message("<polyline points=\"", points(mark.points), "\" fill=\"none\"", stroke(mark.line), "/>\n");
    }
    void operator()(const PlotPolygon& mark) {
        text += message("<polygon points=\"", points(mark.points), "\"", fill(mark.fill), stroke(mark.outline), "/>\n");
    }
    void operator()(const PlotCircle& mark) {
        text += message("<circle cx=\"", number(mark.middle.x), "\" cy=\"", number(mark.middle.y), "\" r=\"", number(mark.radius),
                        "\"", fill(mark.fill), stroke(mark.outline), "/>\n");
    }
    void operator()(const PlotWords& mark) {
        const Words& words = mark.words;
        const char* const anchor = words.align == Align::left ? "start" : words.align == Align::centre ? "middle" : "end";
        const std::string at = number(mark.at.x) + (words.upward ? " " : "\" y=\"") + number(mark.at.y);
        text += words.upward ? message("<text transform=\"translate(", at, ") rotate(-90)\"") : message("<text x=\"", at, "\"");
        text += message(" font-size=\"", number(words.size), "\" text-anchor=\"", anchor, "\"",
                        words.bold ? " font-weight=\"bold\"" : "", fill(words.colour), ">", escaped(mark.text), "</text>\n");
    }
};

} // namespace

std::string svg(const Plot& plot) {
    Writer writer;
    const std::string width = number(plot.width), height = number(plot.height);
    writer.text = message("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"", width,
                          "\" height=\"", height, "\" viewBox=\"0 0 ", width, " ", height,
                          "\" font-family=\"DejaVu Sans, Verdana, sans-serif\">\n<title>", escaped(plot.title),
                          "</title>\n<rect width=\"", width, "\" height=\"", height, "\"", fill(plot.paper), "/>\n");
    for (const PlotMark& mark : plot.marks)
        std::visit(writer, mark);
    return writer.text + "</svg>\n";
}

} // namespace windrow::cli
