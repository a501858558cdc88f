// A chart of lines on plain axes: a frame with ticks, lines that carry their names at their ends.
#pragma once

#include "cli/pareto/plot.h"

#include <string>
#include <vector>

namespace windrow::cli {

struct ChartAxis {
    std::string title;
    double low = 0.0, high = 1.0, tick = 0.2; ///< values; ticks at whole multiples
};

/// Part of a page with its own axes.
class Chart {
  public:
    Chart(Plot& plot, const Rect& frame, const ChartAxis& x, const ChartAxis& y);

    /// Grid, ticks, titles; first, so that lines lie over them.
    void add_axes(const std::string& title);
    [[nodiscard]] glm::dvec2 at(glm::dvec2 value) const;
    void add_line(const std::vector<glm::dvec2>& values, const Line& line);
    /// Words whose base line begins at a value, moved by `offset` [page units].
    void add_label(const std::string& text, glm::dvec2 value, Colour colour, glm::dvec2 offset = {6.0, 5.0});

  private:
    Plot& plot_;
    Rect frame_;
    ChartAxis x_, y_;
};

void add_words(Plot& plot, const std::string& text, glm::dvec2 at, const Words& words);

/// Colours that tell neighbours apart, light to dark paper, also to most colour-blind eyes.
[[nodiscard]] Colour series_colour(std::size_t n);

} // namespace windrow::cli
