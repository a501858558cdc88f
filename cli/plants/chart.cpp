#include "cli/plants/chart.h"

#include "cli/drawing/palette.h"
#include "scene/number_text.h"

#include <array>
#include <cmath>

namespace windrow::cli {
namespace {

constexpr double k_tick_size = 13.0, k_title_size = 14.0;

} // namespace

void add_words(Plot& plot, const std::string& text, glm::dvec2 at, const Words& words) {
    plot.marks.emplace_back(PlotWords{text, at, words});
}

// Okabe and Ito's palette, darkened where it is too pale for thin lines.
Colour series_colour(std::size_t n) {
    constexpr std::array k_colours{hex(0x0072B2), hex(0xD55E00), hex(0x009E73), hex(0xB0568F),
                                   hex(0x2E9BD6), hex(0xB8860B), hex(0x5B4B3A), hex(0x1C222B)};
    return k_colours[n % k_colours.size()];
}

Chart::Chart(Plot& plot, const Rect& frame, const ChartAxis& x, const ChartAxis& y) : plot_(plot), frame_(frame), x_(x), y_(y) {}

glm::dvec2 Chart::at(glm::dvec2 value) const {
    return {frame_.x + frame_.width * (value.x - x_.low) / (x_.high - x_.low),
            frame_.bottom() - frame_.height * (value.y - y_.low) / (y_.high - y_.low)};
}

void Chart::add_axes(const std::string& title) {
    const Line grid{.colour = k_hairline, .width = 1.0};
    for (int n = static_cast<int>(std::ceil(x_.low / x_.tick - 1e-9)); n * x_.tick <= x_.high * (1.0 + 1e-9); ++n) {
        const double value = n * x_.tick;
        add_line({{value, y_.low}, {value, y_.high}}, grid);
        add_words(plot_, scene::figure(std::round(value * 1e6) / 1e6), at({value, y_.low}) + glm::dvec2(0.0, 20.0),
                  {.size = k_tick_size, .colour = k_dim_ink, .align = Align::centre});
    }
    for (int n = static_cast<int>(std::ceil(y_.low / y_.tick - 1e-9)); n * y_.tick <= y_.high * (1.0 + 1e-9); ++n) {
        const double value = n * y_.tick;
        add_line({{x_.low, value}, {x_.high, value}}, grid);
        add_words(plot_, scene::figure(std::round(value * 1e6) / 1e6), at({x_.low, value}) + glm::dvec2(-8.0, 4.5),
                  {.size = k_tick_size, .colour = k_dim_ink, .align = Align::right});
    }
    add_words(plot_, title, {frame_.x, frame_.y - 14.0}, {.size = 16.0, .colour = k_ink, .bold = true});
    add_words(plot_, x_.title, {frame_.middle().x, frame_.bottom() + 44.0},
              {.size = k_title_size, .colour = k_ink, .align = Align::centre});
    add_words(plot_, y_.title, {frame_.x - 46.0, frame_.middle().y},
              {.size = k_title_size, .colour = k_ink, .align = Align::centre, .upward = true});
}

void Chart::add_line(const std::vector<glm::dvec2>& values, const Line& line) {
    PlotLine drawn{.points = {}, .line = line};
    for (const glm::dvec2 value : values)
        drawn.points.push_back(at(value));
    plot_.marks.emplace_back(std::move(drawn));
}

void Chart::add_label(const std::string& text, glm::dvec2 value, Colour colour, glm::dvec2 offset) {
    add_words(plot_, text, at(value) + offset, {.size = k_tick_size, .colour = colour});
}

} // namespace windrow::cli
